using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>The datatype codes of NIfTI-1.</summary>
    static class NiftiDatatype
    {
        /// <summary>The number type of a code and its values per voxel; null for a code that is not read.</summary>
        internal static (VoxelType Type, int Channels)? Find(int code)
        {
            switch (code)
            {
                case 2:
                    return (VoxelType.UInt8, 1);
                case 4:
                    return (VoxelType.Int16, 1);
                case 8:
                    return (VoxelType.Int32, 1);
                case 16:
                    return (VoxelType.Float32, 1);
                case 64:
                    return (VoxelType.Float64, 1);
                case 128:
                    return (VoxelType.UInt8, 3);
                case 256:
                    return (VoxelType.Int8, 1);
                case 512:
                    return (VoxelType.UInt16, 1);
                case 768:
                    return (VoxelType.UInt32, 1);
                case 1024:
                    return (VoxelType.Int64, 1);
                case 1280:
                    return (VoxelType.UInt64, 1);
                case 2304:
                    return (VoxelType.UInt8, 4);
                default:
                    return null;
            }
        }

        /// <summary>A code with the name that the standard gives it, for messages.</summary>
        internal static string Name(int code)
        {
            switch (code)
            {
                case 0:
                    return "0 (unknown)";
                case 1:
                    return "1 (one bit per voxel)";
                case 32:
                    return "32 (complex numbers of 64 bits)";
                case 1536:
                    return "1536 (floating-point numbers of 128 bits)";
                case 1792:
                    return "1792 (complex numbers of 128 bits)";
                case 2048:
                    return "2048 (complex numbers of 256 bits)";
                default:
                    return FormattableString.Invariant($"{code}");
            }
        }
    }
}
