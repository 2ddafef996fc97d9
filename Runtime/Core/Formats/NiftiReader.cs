using System;
using System.IO;
using System.Text;
using System.Threading;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>
    /// Reads NIfTI-1 in one file (.nii, .nii.gz): both byte orders, every integer and floating-point type, RGB24 and RGBA32, time points
    /// and vectors as components. NIfTI-2, pairs (.hdr/.img), complex and 128-bit numbers are refused by name.
    /// </summary>
    public static class NiftiReader
    {
        /// <summary>Header extensions may take so many bytes before the voxels; more is taken for a damaged header.</summary>
        const float LargestVoxelOffset = 64 << 20;

        /// <summary>The voxels' earliest place in one file: behind the header and the four bytes that announce extensions.</summary>
        const int SmallestVoxelOffset = 352;

        /// <summary>Reads a file.</summary>
        /// <param name="path">The file.</param>
        /// <param name="cancellation">Cancels the work.</param>
        /// <param name="progress">Told the share done, 0 to 1; may be null.</param>
        /// <exception cref="VolumeFormatException">The file can't be read; says what stands where, and what was expected.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public static VolumeData Read(string path, CancellationToken cancellation = default, IProgress<float> progress = null) =>
            VolumeFile.Read(path, stream => Read(stream, path, cancellation, progress));

        /// <summary>Reads from a stream, from its position on.</summary>
        /// <param name="stream">Can be read and positioned; stays open.</param>
        /// <param name="name">What messages call it.</param>
        /// <param name="cancellation">Cancels the work.</param>
        /// <param name="progress">Told the share done, 0 to 1; may be null.</param>
        /// <exception cref="VolumeFormatException">The data can't be read; says what stands where, and what was expected.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public static VolumeData Read(Stream stream, string name, CancellationToken cancellation = default, IProgress<float> progress = null)
        {
            VolumeFile.CheckStream(stream);
            var context = new ReadContext(name, "NIfTI-1", cancellation, progress);
            if (!GzipData.StartsAt(stream))
                return Read(stream, stream.Length - stream.Position, false, context);
            try
            {
                long largest = GzipData.LargestInflatedSize(stream);
                using (Stream inflated = GzipData.Open(stream))
                    return Read(inflated, largest, true, context);
            }
            catch (InvalidDataException problem)
            {
                throw GzipData.Damaged(context, problem);
            }
        }

        /// <summary>What the header says, whether or not the voxels are there.</summary>
        internal static VolumeFileInfo ReadInfo(Stream stream, ReadContext context)
        {
            bool compressed = GzipData.StartsAt(stream);
            try
            {
                using (Stream inflated = compressed ? GzipData.Open(stream) : null)
                {
                    NiftiHeader header = ReadHeader(inflated ?? stream, context);
                    Grid grid = ReadGrid(header, context);
                    Count(grid.Geometry, grid.Components, context);
                    return new VolumeFileInfo(grid.Geometry, grid.Type, grid.Components, compressed, context.Description);
                }
            }
            catch (InvalidDataException problem)
            {
                throw GzipData.Damaged(context, problem);
            }
        }

        static VolumeData Read(Stream stream, long largestSize, bool compressed, ReadContext context)
        {
            NiftiHeader header = ReadHeader(stream, context);
            Grid grid = ReadGrid(header, context);
            (double slope, double intercept) = grid.Channels > 1 ? (1, 0) : Scaling(header, context);
            long offset = VoxelOffset(header, context);
            if (offset > largestSize || !VolumeFile.Skip(stream, offset - NiftiHeader.Size, context))
                throw context.Refusal("vox_offset", $"{offset}", "a place inside the file");
            Array voxels = VoxelBlocks.Read(
                stream, grid.Type, Count(grid.Geometry, grid.Components, context), header.BigEndian, largestSize - offset, !compressed, context);
            if (compressed)
                GzipData.CheckEnd(stream, context);
            bool isSeries = grid.Channels == 1 && header.Dim(0) > 3;
            ComponentOrder order = isSeries ? ComponentOrder.Slowest : ComponentOrder.Fastest;
            return new VolumeData(grid.Geometry, voxels, (int)grid.Components, order, slope, intercept, context.Description);
        }

        static Grid ReadGrid(NiftiHeader header, ReadContext context)
        {
            int[] sizes = Sizes(header, context, out long volumes);
            (VoxelType type, int channels) = NumberType(header, context);
            if (channels > 1 && volumes > 1)
                throw context.Refusal("dim", $"{volumes} volumes of colours", "one volume where voxels are colours");
            return new Grid { Geometry = NiftiGeometry.Of(header, sizes, context), Type = type, Channels = channels, Components = Math.Max(channels, volumes) };
        }

        static NiftiHeader ReadHeader(Stream stream, ReadContext context)
        {
            var bytes = new byte[NiftiHeader.Size];
            int read = VolumeFile.ReadFully(stream, bytes);
            int size = read < 4 ? 0 : NiftiHeader.SizeOf(bytes);
            if (size == NiftiHeader.Size2)
                throw context.Refusal("sizeof_hdr", $"540 (NIfTI-2)", "348: NIfTI-2 is not read yet, only NIfTI-1");
            if (read >= 4 && size != NiftiHeader.Size)
                throw context.Refusal("sizeof_hdr", $"{size}", "348 in either byte order, as NIfTI-1 has");
            if (read < bytes.Length)
                throw context.Refusal("the header", $"cut off after {read} bytes", "348 bytes");
            NiftiHeader header = NiftiHeader.Parse(bytes);
            if (header.Magic.StartsWith("ni1", StringComparison.Ordinal))
                throw context.Refusal("magic", $"ni1 (a pair of .hdr and .img)", "n+1: pairs are not read yet, only single files");
            if (!header.Magic.StartsWith("n+1", StringComparison.Ordinal))
                throw context.Refusal("magic", $"\"{Printable(header.Magic)}\"", "n+1, as NIfTI-1 in one file has");
            return header;
        }

        /// <summary>The three spatial sizes, and how many volumes follow each other in the file.</summary>
        static int[] Sizes(NiftiHeader header, ReadContext context, out long volumes)
        {
            int rank = header.Dim(0);
            if (rank < 1 || rank > 7)
                throw context.Refusal("dim[0]", $"{rank}", "1 to 7");
            var sizes = new[] { 1, 1, 1 };
            volumes = 1;
            for (int n = 1; n <= rank; n++)
            {
                int size = header.Dim(n);
                if (size < 0 || (size == 0 && n <= 3))
                    throw context.Refusal(FormattableString.Invariant($"dim[{n}]"), $"{size}", "a size of at least 1");
                if (n <= 3)
                {
                    sizes[n - 1] = size;
                }
                else
                {
                    // Trailing sizes of 0 occur and mean 1. Four sizes of 16 bits can't overflow a long.
                    volumes *= Math.Max(1, size);
                }
            }

            return sizes;
        }

        static long Count(VolumeGeometry geometry, long components, ReadContext context)
        {
            // At most 2^45 voxels and 2^60 components: doubles tell whether the product is a number of voxels at all.
            if ((double)geometry.VoxelCount * components > VoxelBlocks.LargestCount)
                throw context.Refusal("dim", $"{geometry.SizeI} x {geometry.SizeJ} x {geometry.SizeK} voxels x {components}", FormattableString.Invariant($"at most {VoxelBlocks.LargestCount} values"));
            return geometry.VoxelCount * components;
        }

        static (VoxelType Type, int Channels) NumberType(NiftiHeader header, ReadContext context)
        {
            (VoxelType, int)? found = NiftiDatatype.Find(header.Datatype);
            if (!found.HasValue)
                throw context.Refusal("datatype", $"{NiftiDatatype.Name(header.Datatype)}", "an integer or floating-point number of 8 to 64 bits, RGB24 or RGBA32");
            (VoxelType type, int channels) = found.Value;
            if (header.BitsPerVoxel != type.SizeOf() * channels * 8)
                context.Warn($"bitpix is {header.BitsPerVoxel}, but datatype {header.Datatype} has {type.SizeOf() * channels * 8} bits; the datatype is used.");
            return found.Value;
        }

        static (double Slope, double Intercept) Scaling(NiftiHeader header, ReadContext context)
        {
            if (header.Slope == 0 || !float.IsFinite(header.Slope))
                return (1, 0);
            if (float.IsFinite(header.Intercept))
                return (header.Slope, header.Intercept);
            context.Warn($"scl_inter is {header.Intercept}; 0 is used.");
            return (header.Slope, 0);
        }

        static long VoxelOffset(NiftiHeader header, ReadContext context)
        {
            float offset = header.VoxelOffset;

            // Written so that NaN fails too.
            if (!(offset >= 0 && offset <= LargestVoxelOffset) || Math.Floor(offset) != offset)
                throw context.Refusal("vox_offset", $"{offset}", "a whole number of bytes, 352 or more");
            if (offset < SmallestVoxelOffset)
            {
                context.Warn($"vox_offset is {offset}, inside the header; the voxels are read from byte {SmallestVoxelOffset}.");
                return SmallestVoxelOffset;
            }

            return (long)offset;
        }

        static string Printable(string magic)
        {
            var text = new StringBuilder();
            foreach (char letter in magic.TrimEnd('\0'))
                text.Append(letter >= ' ' && letter < '\u007F' ? letter : '?');
            return text.ToString();
        }

        struct Grid
        {
            internal VolumeGeometry Geometry;
            internal VoxelType Type;
            internal int Channels;
            internal long Components;
        }
    }
}
