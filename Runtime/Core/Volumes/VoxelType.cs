using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>The number type that a file stores its voxels in.</summary>
    public enum VoxelType
    {
        /// <summary>Signed, 8 bits (<see cref="sbyte"/>).</summary>
        Int8,

        /// <summary>Unsigned, 8 bits (<see cref="byte"/>).</summary>
        UInt8,

        /// <summary>Signed, 16 bits (<see cref="short"/>).</summary>
        Int16,

        /// <summary>Unsigned, 16 bits (<see cref="ushort"/>).</summary>
        UInt16,

        /// <summary>Signed, 32 bits (<see cref="int"/>).</summary>
        Int32,

        /// <summary>Unsigned, 32 bits (<see cref="uint"/>).</summary>
        UInt32,

        /// <summary>Signed, 64 bits (<see cref="long"/>).</summary>
        Int64,

        /// <summary>Unsigned, 64 bits (<see cref="ulong"/>).</summary>
        UInt64,

        /// <summary>IEEE 754, 32 bits (<see cref="float"/>).</summary>
        Float32,

        /// <summary>IEEE 754, 64 bits (<see cref="double"/>).</summary>
        Float64,
    }

    /// <summary>Where the values of one voxel lie in a file.</summary>
    public enum ComponentOrder
    {
        /// <summary>Side by side: the component index runs before i.</summary>
        Fastest,

        /// <summary>A whole grid after the other: the component index runs after k.</summary>
        Slowest,
    }

    /// <summary>Facts about voxel types.</summary>
    public static class VoxelTypes
    {
        /// <summary>Bytes per value: 1, 2, 4 or 8.</summary>
        public static int SizeOf(this VoxelType type)
        {
            switch (type)
            {
                case VoxelType.Int8:
                case VoxelType.UInt8:
                    return 1;
                case VoxelType.Int16:
                case VoxelType.UInt16:
                    return 2;
                case VoxelType.Int32:
                case VoxelType.UInt32:
                case VoxelType.Float32:
                    return 4;
                default:
                    return 8;
            }
        }

        /// <summary>True for Float32 and Float64.</summary>
        public static bool IsFloat(this VoxelType type) => type == VoxelType.Float32 || type == VoxelType.Float64;

        /// <summary>The type of the elements of an array of voxels.</summary>
        /// <exception cref="ArgumentException">The array's elements are none of the ten types.</exception>
        public static VoxelType Of(Array voxels)
        {
            // By element type and not by type pattern: sbyte[] and byte[] (and their wider kin) match each other's patterns.
            Type element = (voxels ?? throw new ArgumentNullException(nameof(voxels))).GetType().GetElementType();
            for (var type = VoxelType.Int8; type <= VoxelType.Float64; type++)
                if (ElementType(type) == element)
                    return type;
            throw new ArgumentException("Voxels are integers or floating-point numbers of 8 to 64 bits, not " + element + ".", nameof(voxels));
        }

        /// <summary>The .NET type of a value.</summary>
        public static Type ElementType(this VoxelType type)
        {
            switch (type)
            {
                case VoxelType.Int8:
                    return typeof(sbyte);
                case VoxelType.UInt8:
                    return typeof(byte);
                case VoxelType.Int16:
                    return typeof(short);
                case VoxelType.UInt16:
                    return typeof(ushort);
                case VoxelType.Int32:
                    return typeof(int);
                case VoxelType.UInt32:
                    return typeof(uint);
                case VoxelType.Int64:
                    return typeof(long);
                case VoxelType.UInt64:
                    return typeof(ulong);
                case VoxelType.Float32:
                    return typeof(float);
                case VoxelType.Float64:
                    return typeof(double);
                default:
                    throw new ArgumentOutOfRangeException(nameof(type), type, "Not a voxel type.");
            }
        }
    }
}
