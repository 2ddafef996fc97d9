using System.IO;
using System.IO.Compression;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>Facts about gzip data (RFC 1952), and how they are opened.</summary>
    static class GzipData
    {
        /// <summary>Deflate never makes more than this of one byte (258 bytes of output per two bits of input, RFC 1951).</summary>
        const long LargestRatio = 1032;

        /// <summary>True when the bytes at the stream's position start a gzip member; the position stays.</summary>
        internal static bool StartsAt(Stream stream)
        {
            long position = stream.Position;
            bool gzip = stream.ReadByte() == 0x1F && stream.ReadByte() == 0x8B;
            stream.Position = position;
            return gzip;
        }

        /// <summary>The most bytes that what is left of a stream can inflate to.</summary>
        internal static long LargestInflatedSize(Stream compressed) => (compressed.Length - compressed.Position) * LargestRatio;

        /// <summary>Opens gzip data at the stream's position. Further members follow on; checksums are checked at each member's end.</summary>
        internal static Stream Open(Stream compressed) => new GZipStream(compressed, CompressionMode.Decompress, leaveOpen: true);

        /// <summary>The refusal of data that are cut or damaged.</summary>
        internal static VolumeFormatException Damaged(ReadContext context, InvalidDataException cause) =>
            context.Refusal("the gzip data", $"damaged or cut off", "an intact gzip stream", cause);

        /// <summary>Reads on by one byte behind the last voxel: checks the checksum where the data end here (data cut off inside their last bytes pass), and warns where they don't.</summary>
        internal static void CheckEnd(Stream inflated, ReadContext context)
        {
            if (inflated.ReadByte() >= 0)
                context.Warn($"The gzip data go on behind the last voxel; the rest is ignored and its checksum was not checked.");
        }
    }
}
