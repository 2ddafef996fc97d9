using System;
using System.Threading;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>
    /// A whole <see cref="SegmentedVolume"/> in few bytes that load fast: intensities, labels, segments, geometry, warnings, and what would have to be
    /// computed otherwise (automatic transfer function, histogram, voxels per segment). Lossless, bit by bit. The bytes carry a version and checksums; the
    /// layout stands in the header of <c>PackedHeaderWriter</c>. They are made once, by whoever imports a scan, and depend on the volume alone.
    /// </summary>
    public static class PackedVolume
    {
        const string Format = "packed volume";

        /// <summary>Whether bytes begin as packed volumes do; says nothing of the rest.</summary>
        public static bool IsPacked(ReadOnlySpan<byte> data)
        {
            if (data.Length < PackedHeader.Magic.Length)
                return false;
            for (int n = 0; n < PackedHeader.Magic.Length; n++)
            {
                if (data[n] != PackedHeader.Magic[n])
                    return false;
            }

            return true;
        }

        /// <summary>A checksum of packed bytes (XXH64): the same volume has the same on every machine.</summary>
        public static ulong Checksum(ReadOnlySpan<byte> data) => Checksum64.Of(data);

        /// <summary>Packs a volume.</summary>
        /// <param name="volume">The volume.</param>
        /// <param name="cancellation">Cancels the work.</param>
        /// <param name="progress">Told the share done, 0 to 1, on the calling thread; may be null.</param>
        /// <returns>The bytes: the same for the same volume, on every machine.</returns>
        /// <exception cref="ArgumentNullException"><paramref name="volume"/> is null.</exception>
        /// <exception cref="AnatomyCarveException">The volume takes more bytes than one array holds (2 GiB).</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public static byte[] Write(SegmentedVolume volume, CancellationToken cancellation = default, IProgress<float> progress = null) =>
            new PackedVolumeWriter(volume ?? throw new ArgumentNullException(nameof(volume)), cancellation, progress).Write();

        /// <summary>Reads what a packed volume says of itself, without its voxels.</summary>
        /// <param name="data">All bytes of it.</param>
        /// <param name="name">What messages call it.</param>
        /// <exception cref="VolumeFormatException">It is no packed volume, of another version, cut off, or its header damaged.</exception>
        public static PackedVolumeInfo ReadInfo(ReadOnlyMemory<byte> data, string name) =>
            PackedHeaderReader.ReadInfo(data, Context(name));

        /// <summary>Reads the header, for whoever wants to know before unpacking, or a coarser volume first.</summary>
        /// <param name="data">All bytes of it. They must not change as long as the reader is used.</param>
        /// <param name="name">What messages call it.</param>
        /// <exception cref="VolumeFormatException">It is no packed volume, of another version, cut off, or its header damaged.</exception>
        public static PackedVolumeReader Open(ReadOnlyMemory<byte> data, string name) => new PackedVolumeReader(data, name);

        /// <summary>
        /// Unpacks a volume, on the calling thread and up to three more: all processors but one, at most four. No thread looks at the bytes any more
        /// when it returns.
        /// </summary>
        /// <param name="data">All bytes of it.</param>
        /// <param name="name">What messages call it.</param>
        /// <param name="cancellation">Cancels the work.</param>
        /// <param name="progress">Told the share done, 0 to 1, on the calling thread; may be null.</param>
        /// <exception cref="VolumeFormatException">It is no packed volume, of another version, cut off or damaged.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public static SegmentedVolume Read(
            ReadOnlyMemory<byte> data, string name, CancellationToken cancellation = default, IProgress<float> progress = null) =>
            Read(data, name, BlockWorkers.DefaultThreads, cancellation, progress);

        /// <summary>Unpacks a volume on a number of threads.</summary>
        /// <param name="data">All bytes of it.</param>
        /// <param name="name">What messages call it.</param>
        /// <param name="threads">The threads that work, the calling one among them: at least 1.</param>
        /// <param name="cancellation">Cancels the work.</param>
        /// <param name="progress">Told the share done, 0 to 1, on the calling thread; may be null.</param>
        /// <exception cref="ArgumentOutOfRangeException"><paramref name="threads"/> is below 1.</exception>
        /// <exception cref="VolumeFormatException">It is no packed volume, of another version, cut off or damaged.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public static SegmentedVolume Read(
            ReadOnlyMemory<byte> data, string name, int threads, CancellationToken cancellation = default, IProgress<float> progress = null)
        {
            if (threads < 1)
                throw new ArgumentOutOfRangeException(nameof(threads), threads, "At least one thread has to work.");
            cancellation.ThrowIfCancellationRequested();
            return Open(data, name).Read(threads, cancellation, progress);
        }

        /// <summary>What refusals are made with.</summary>
        internal static ReadContext Context(string name) => new ReadContext(name, Format, default, null);
    }
}
