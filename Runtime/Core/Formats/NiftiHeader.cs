using System;
using System.Buffers.Binary;
using System.Text;

namespace AnatomyCarve.Formats
{
    /// <summary>The fields of a NIfTI-1 header (348 bytes) that place and scale the voxels, in the file's own terms.</summary>
    sealed class NiftiHeader
    {
        /// <summary>Bytes of a NIfTI-1 header.</summary>
        internal const int Size = 348;

        /// <summary>Bytes of a NIfTI-2 header.</summary>
        internal const int Size2 = 540;

        readonly byte[] bytes;

        NiftiHeader(byte[] bytes, bool bigEndian)
        {
            this.bytes = bytes;
            BigEndian = bigEndian;
            Magic = Encoding.ASCII.GetString(bytes, 344, 4);
            Datatype = Short(70);
            BitsPerVoxel = Short(72);
            VoxelOffset = Float(108);
            Slope = Float(112);
            Intercept = Float(116);
            Units = bytes[123];
            QformCode = Short(252);
            SformCode = Short(254);
        }

        /// <summary>True when the most significant byte comes first.</summary>
        internal bool BigEndian { get; }

        /// <summary>"n+1\0" for one file, "ni1\0" for a pair.</summary>
        internal string Magic { get; }

        internal short Datatype { get; }

        internal short BitsPerVoxel { get; }

        internal float VoxelOffset { get; }

        internal float Slope { get; }

        internal float Intercept { get; }

        /// <summary>xyzt_units; the lowest three bits are the unit of length.</summary>
        internal byte Units { get; }

        internal short QformCode { get; }

        internal short SformCode { get; }

        /// <summary>Reads the fields.</summary>
        /// <param name="bytes">348 bytes that start with the header's size in either byte order.</param>
        internal static NiftiHeader Parse(byte[] bytes) =>
            new NiftiHeader(bytes, BinaryPrimitives.ReadInt32BigEndian(bytes) == Size);

        /// <summary>The header's size as the first four bytes say, in whichever byte order makes it 348 or 540; else as little-endian.</summary>
        internal static int SizeOf(ReadOnlySpan<byte> bytes)
        {
            int big = BinaryPrimitives.ReadInt32BigEndian(bytes);
            return big == Size || big == Size2 ? big : BinaryPrimitives.ReadInt32LittleEndian(bytes);
        }

        /// <summary>dim[n], n = 0 to 7.</summary>
        internal short Dim(int n) => Short(40 + (2 * n));

        /// <summary>pixdim[n], n = 0 to 7.</summary>
        internal float Pixdim(int n) => Float(76 + (4 * n));

        /// <summary>quatern_b, _c, _d: n = 0 to 2.</summary>
        internal float Quaternion(int n) => Float(256 + (4 * n));

        /// <summary>qoffset_x, _y, _z: n = 0 to 2.</summary>
        internal float QuaternionOffset(int n) => Float(268 + (4 * n));

        /// <summary>An element of srow_x, srow_y, srow_z.</summary>
        internal float Srow(int row, int col) => Float(280 + (16 * row) + (4 * col));

        short Short(int offset)
        {
            ReadOnlySpan<byte> bytes = this.bytes.AsSpan(offset, 2);
            return BigEndian ? BinaryPrimitives.ReadInt16BigEndian(bytes) : BinaryPrimitives.ReadInt16LittleEndian(bytes);
        }

        float Float(int offset)
        {
            ReadOnlySpan<byte> bytes = this.bytes.AsSpan(offset, 4);
            return BitConverter.Int32BitsToSingle(BigEndian ? BinaryPrimitives.ReadInt32BigEndian(bytes) : BinaryPrimitives.ReadInt32LittleEndian(bytes));
        }
    }
}
