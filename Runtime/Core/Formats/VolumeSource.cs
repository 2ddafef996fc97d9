using System;
using System.IO;
using System.Threading;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>Where a scan or a segmentation comes from: a file, or a file's content that is in memory already. Immutable.</summary>
    public sealed class VolumeSource
    {
        readonly ReadOnlyMemory<byte>? content;

        VolumeSource(string name, ReadOnlyMemory<byte>? content)
        {
            Name = name;
            this.content = content;
        }

        /// <summary>What messages call it: the path, or the name that came with the content.</summary>
        public string Name { get; }

        /// <summary>What warnings call it: the name without folders.</summary>
        public string ShortName => Path.GetFileName(Name);

        /// <summary>A file.</summary>
        /// <param name="path">The file; null or empty = there is none.</param>
        /// <returns>Null where there is none.</returns>
        public static VolumeSource OfFile(string path) => string.IsNullOrEmpty(path) ? null : new VolumeSource(path, null);

        /// <summary>A file's content.</summary>
        /// <param name="content">All bytes of the file.</param>
        /// <param name="name">What messages call it.</param>
        public static VolumeSource OfContent(ReadOnlyMemory<byte> content, string name) => new VolumeSource(name, content);

        /// <summary>Reads what its header says, without the voxels.</summary>
        /// <exception cref="VolumeFormatException">The header cannot be read.</exception>
        public VolumeFileInfo ReadInfo() => content is ReadOnlyMemory<byte> bytes ? VolumeReader.ReadInfo(bytes, Name) : VolumeReader.ReadInfo(Name);

        /// <summary>Reads it, in whichever format its content shows.</summary>
        /// <exception cref="VolumeFormatException">It cannot be read.</exception>
        public VolumeData Read(CancellationToken cancellationToken, IProgress<float> progress) => content is ReadOnlyMemory<byte> bytes
            ? VolumeReader.Read(bytes, Name, cancellationToken, progress)
            : VolumeReader.Read(Name, cancellationToken, progress);
    }
}
