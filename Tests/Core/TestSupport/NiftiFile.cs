using System;
using System.Text;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Tests.TestSupport
{
    /// <summary>Writes a NIfTI-1 file in memory, field by field, so that tests can make odd ones too. The sform is in RAS millimetres.</summary>
    public sealed class NiftiFile
    {
        /// <summary>Makes a file of three sizes and the voxels' array (i fastest).</summary>
        public NiftiFile(int sizeI, int sizeJ, int sizeK, Array voxels)
        {
            Dim = new short[] { 3, (short)sizeI, (short)sizeJ, (short)sizeK, 1, 1, 1, 1 };
            Voxels = voxels;
            Datatype = DatatypeOf(VoxelTypes.Of(voxels));
        }

        /// <summary>dim[0] to dim[7].</summary>
        public short[] Dim { get; set; }

        /// <summary>pixdim[0] to pixdim[7].</summary>
        public float[] Pixdim { get; set; } = { 1, 1, 1, 1, 1, 1, 1, 1 };

        /// <summary>The voxels; written as they are.</summary>
        public Array Voxels { get; set; }

        /// <summary>The datatype code.</summary>
        public short Datatype { get; set; }

        /// <summary>The byte order.</summary>
        public bool BigEndian { get; set; }

        /// <summary>scl_slope.</summary>
        public float Slope { get; set; }

        /// <summary>scl_inter.</summary>
        public float Intercept { get; set; }

        /// <summary>xyzt_units.</summary>
        public byte Units { get; set; } = 2;

        /// <summary>Voxel index to LPS; written as sform in RAS. Null for none.</summary>
        public Affine? Sform { get; set; } = Affine.Identity;

        /// <summary>qform_code.</summary>
        public short QformCode { get; set; }

        /// <summary>quatern_b, c, d and qoffset_x, y, z.</summary>
        public float[] Quaternion { get; set; } = new float[6];

        /// <summary>vox_offset; bytes between header and voxels are zero.</summary>
        public int VoxelOffset { get; set; } = 352;

        /// <summary>The file's bytes.</summary>
        public byte[] ToBytes()
        {
            var header = new byte[Math.Max(352, VoxelOffset)];
            Put(header, 0, 348);
            for (int n = 0; n < 8; n++)
            {
                Put(header, 40 + (2 * n), Dim[n]);
                Put(header, 76 + (4 * n), Pixdim[n]);
            }

            Put(header, 70, Datatype);
            Put(header, 72, (short)(8 * Buffer.ByteLength(Voxels) / Math.Max(1, Voxels.Length) * (Datatype == 128 ? 3 : Datatype == 2304 ? 4 : 1)));
            Put(header, 108, (float)VoxelOffset);
            Put(header, 112, Slope);
            Put(header, 116, Intercept);
            header[123] = Units;
            Put(header, 252, QformCode);
            Put(header, 254, (short)(Sform.HasValue ? 1 : 0));
            for (int n = 0; n < 6; n++)
                Put(header, 256 + (4 * n), Quaternion[n]);
            for (int element = 0; Sform.HasValue && element < 12; element++)
            {
                double lps = Sform.Value[element / 4, element % 4];
                Put(header, 280 + (4 * element), (float)(element < 8 ? -lps : lps));
            }

            Encoding.ASCII.GetBytes("n+1").CopyTo(header, 344);
            return VoxelBytes.Join(header, VoxelBytes.Of(Voxels, BigEndian));
        }

        static short DatatypeOf(VoxelType type)
        {
            var codes = new short[] { 256, 2, 4, 512, 8, 768, 1024, 1280, 16, 64 };
            return codes[(int)type];
        }

        void Put(byte[] header, int offset, int value) => Put(header, offset, BitConverter.GetBytes(value));

        void Put(byte[] header, int offset, short value) => Put(header, offset, BitConverter.GetBytes(value));

        void Put(byte[] header, int offset, float value) => Put(header, offset, BitConverter.GetBytes(value));

        void Put(byte[] header, int offset, byte[] value)
        {
            if (BigEndian == BitConverter.IsLittleEndian)
                Array.Reverse(value);
            value.CopyTo(header, offset);
        }
    }
}
