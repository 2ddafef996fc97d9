using System.Collections.Generic;

namespace AnatomyCarve.Volumes
{
    /// <summary>What a file says beside its voxels; filled by whoever makes a <see cref="VolumeData"/>, which copies it.</summary>
    public sealed class VolumeDescription
    {
        /// <summary>The file, or what the caller names the stream.</summary>
        public string Source { get; set; } = string.Empty;

        /// <summary>The file format's name.</summary>
        public string Format { get; set; } = string.Empty;

        /// <summary>The segments that the file names.</summary>
        public IList<SegmentInfo> Segments { get; } = new List<SegmentInfo>();

        /// <summary>What was odd but could be read, a sentence each.</summary>
        public IList<string> Warnings { get; } = new List<string>();

        /// <summary>Key/value pairs of the header.</summary>
        public IDictionary<string, string> Metadata { get; } = new Dictionary<string, string>();
    }
}
