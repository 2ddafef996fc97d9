using System.Collections.Generic;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>The names that NRRD has for number types.</summary>
    static class NrrdType
    {
        static readonly Dictionary<string, VoxelType> Names = new Dictionary<string, VoxelType>
        {
            { "signed char", VoxelType.Int8 }, { "int8", VoxelType.Int8 }, { "int8_t", VoxelType.Int8 },
            { "uchar", VoxelType.UInt8 }, { "unsigned char", VoxelType.UInt8 }, { "uint8", VoxelType.UInt8 }, { "uint8_t", VoxelType.UInt8 },
            { "short", VoxelType.Int16 }, { "short int", VoxelType.Int16 }, { "signed short", VoxelType.Int16 },
            { "signed short int", VoxelType.Int16 }, { "int16", VoxelType.Int16 }, { "int16_t", VoxelType.Int16 },
            { "ushort", VoxelType.UInt16 }, { "unsigned short", VoxelType.UInt16 }, { "unsigned short int", VoxelType.UInt16 },
            { "uint16", VoxelType.UInt16 }, { "uint16_t", VoxelType.UInt16 },
            { "int", VoxelType.Int32 }, { "signed int", VoxelType.Int32 }, { "int32", VoxelType.Int32 }, { "int32_t", VoxelType.Int32 },
            { "uint", VoxelType.UInt32 }, { "unsigned int", VoxelType.UInt32 }, { "uint32", VoxelType.UInt32 }, { "uint32_t", VoxelType.UInt32 },
            { "longlong", VoxelType.Int64 }, { "long long", VoxelType.Int64 }, { "long long int", VoxelType.Int64 },
            { "signed long long", VoxelType.Int64 }, { "signed long long int", VoxelType.Int64 }, { "int64", VoxelType.Int64 }, { "int64_t", VoxelType.Int64 },
            { "ulonglong", VoxelType.UInt64 }, { "unsigned long long", VoxelType.UInt64 }, { "unsigned long long int", VoxelType.UInt64 },
            { "uint64", VoxelType.UInt64 }, { "uint64_t", VoxelType.UInt64 },
            { "float", VoxelType.Float32 }, { "double", VoxelType.Float64 },
        };

        /// <summary>The type that the header names.</summary>
        internal static VoxelType Of(NrrdHeader header, ReadContext context)
        {
            string name = header.Require("type");
            string usual = string.Join(" ", NrrdText.Words(name.ToLowerInvariant()));
            return Names.TryGetValue(usual, out VoxelType type)
                ? type
                : throw context.Refusal("type", $"\"{NrrdHeader.Excerpt(name)}\"", "an integer or floating-point type of 8 to 64 bits, such as short or float");
        }
    }
}
