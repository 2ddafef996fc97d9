using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace UnityEngine.Shaders.Direct3D
{
    /// <summary>What a resource is to Direct3D: D3D_SHADER_INPUT_TYPE.</summary>
    enum DxbcKind
    {
        ConstantBuffer = 0,
        TextureBuffer = 1,
        Texture = 2,
        Sampler = 3,
        RandomWriteTyped = 4,
        Structured = 5,
        RandomWriteStructured = 6,
        ByteAddress = 7,
        RandomWriteByteAddress = 8,
        Append = 9,
        Consume = 10,
        RandomWriteStructuredWithCounter = 11,
    }

    /// <summary>A resource that a kernel uses.</summary>
    sealed class DxbcResource
    {
        internal string Name;
        internal DxbcKind Kind;

        /// <summary>The number of its first register; the kind has its own count of constant buffers, samplers, textures and random-write resources.</summary>
        internal uint Register;

        /// <summary>How many registers.</summary>
        internal uint Count;

        /// <summary>A Buffer or RWBuffer of numbers.</summary>
        internal bool IsTypedBuffer;

        /// <summary>Of structured buffers: bytes per element; 4 for raw ones.</summary>
        internal int Stride;

        /// <summary>Of constant buffers: bytes.</summary>
        internal int Size;

        /// <summary>Of constant buffers. Members of structs are named "outer.inner" and cannot be set by name.</summary>
        internal IReadOnlyList<ConstantMember> Members = Array.Empty<ConstantMember>();

        /// <summary>What vkd3d calls its register: cb0, s0, t0, u0.</summary>
        internal string RegisterName => Kind switch
        {
            DxbcKind.ConstantBuffer => "cb",
            DxbcKind.Sampler => "s",
            DxbcKind.TextureBuffer or DxbcKind.Texture or DxbcKind.Structured or DxbcKind.ByteAddress => "t",
            _ => "u",
        } + Register;
    }

    /// <summary>Reads the table of resources in Direct3D bytecode (chunk RDEF of shader model 5), which D3DReflect reads too.</summary>
    sealed class DxbcResources
    {
        const int TypedBufferDimension = 1;
        const int BindingLength = 32, BlockLength = 24, VariableLength = 40, MemberLength = 12;
        const int Row = 16, Word = 4;

        readonly byte[] m_Bytes;
        readonly int m_Start;

        DxbcResources(byte[] bytes, int start)
        {
            m_Bytes = bytes;
            m_Start = start;
        }

        /// <exception cref="FormatException">Not bytecode, or not of shader model 5.</exception>
        /// <exception cref="NotSupportedException">A constant buffer has what cannot be set by name.</exception>
        internal static IReadOnlyList<DxbcResource> Read(byte[] bytecode)
        {
            try
            {
                var table = new DxbcResources(bytecode, ChunkStart(bytecode, "RDEF"));
                return table.Resources();
            }
            catch (ArgumentException e)
            {
                throw new FormatException("broken Direct3D bytecode", e); // an offset that leads out of the file
            }
        }

        static int ChunkStart(byte[] bytes, string name)
        {
            const int countAt = 28;
            if (bytes.Length < countAt + Word || Encoding.ASCII.GetString(bytes, 0, 4) != "DXBC")
                throw new FormatException("not Direct3D bytecode");
            var count = BitConverter.ToInt32(bytes, countAt);
            for (var i = 0; i < count; i++)
            {
                var chunk = BitConverter.ToInt32(bytes, countAt + Word + Word * i);
                if (Encoding.ASCII.GetString(bytes, chunk, 4) == name)
                    return chunk + 8;
            }
            throw new FormatException($"Direct3D bytecode without {name}");
        }

        List<DxbcResource> Resources()
        {
            if (m_Bytes[m_Start + 17] != 5)
                throw new FormatException($"Direct3D bytecode of shader model {m_Bytes[m_Start + 17]}, not 5");
            var (count, first) = (Int(8), Int(12));
            return Enumerable.Range(0, count).Select(i => Resource(first + BindingLength * i)).ToList();
        }

        DxbcResource Resource(int at)
        {
            var resource = new DxbcResource
            {
                Name = Text(Int(at)),
                Kind = (DxbcKind)Int(at + 4),
                Register = (uint)Int(at + 20),
                Count = (uint)Int(at + 24),
            };
            resource.IsTypedBuffer = resource.Kind is (DxbcKind.Texture or DxbcKind.RandomWriteTyped) && Int(at + 12) == TypedBufferDimension;
            resource.Stride = resource.Kind switch
            {
                DxbcKind.ByteAddress or DxbcKind.RandomWriteByteAddress => Word,
                DxbcKind.Structured or >= DxbcKind.RandomWriteStructured => Int(at + 16),
                _ => 0, // the field counts samples
            };
            if (resource.Kind == DxbcKind.ConstantBuffer)
                ReadBlock(resource);
            return resource;
        }

        void ReadBlock(DxbcResource resource)
        {
            var (count, first) = (Int(0), Int(4));
            for (var i = 0; i < count; i++)
            {
                var at = first + BlockLength * i;
                // Structured buffers describe their elements in blocks of the buffers' names, of another kind than 0.
                if (Int(at + 20) != 0 || Text(Int(at)) != resource.Name)
                    continue;
                resource.Size = Int(at + 12);
                var members = new List<ConstantMember>();
                for (var v = 0; v < Int(at + 4); v++)
                {
                    var variable = Int(at + 8) + VariableLength * v;
                    Add(members, Text(Int(variable)), Int(variable + 4), Int(variable + 16));
                }
                resource.Members = members;
                return;
            }
            throw new FormatException($"Direct3D bytecode without the constant buffer '{resource.Name}'");
        }

        void Add(List<ConstantMember> members, string name, int offset, int type)
        {
            var (shape, number, rows, columns) = (Short(type), Short(type + 2), Short(type + 4), Short(type + 6));
            var (elements, memberCount, firstMember) = (Short(type + 8), Short(type + 10), Int(type + 12));
            const int matrixOfRows = 2, matrixOfColumns = 3, structure = 5;
            if (shape == structure)
            {
                if (elements > 0)
                    throw new NotSupportedException($"'{name}' is an array of structs in a constant buffer, which cannot be set by name.");
                for (var m = 0; m < memberCount; m++)
                {
                    var member = firstMember + MemberLength * m;
                    Add(members, name + "." + Text(Int(member)), offset + Int(member + 8), Int(member + 4));
                }
                return;
            }
            // A matrix lies in memory as rows of 16 bytes, one for each of its columns, or rows if it says so.
            var (lines, length) = shape switch { matrixOfColumns => (columns, rows), matrixOfRows => (rows, columns), _ => (1, columns) };
            var size = Row * (lines - 1) + Word * length;
            if (elements > 1)
                size += (elements - 1) * ((size + Row - 1) / Row * Row);
            members.Add(new ConstantMember(name, offset, size, Number(number, name)));
        }

        static NumberKind Number(int type, string name)
        {
            const int boolean = 1, integer = 2, real = 3, unsigned = 19;
            return type switch
            {
                real => NumberKind.Float,
                integer => NumberKind.Int,
                unsigned or boolean => NumberKind.UInt,
                _ => throw new NotSupportedException($"'{name}' is a constant of a type that kernels cannot have here (D3D_SHADER_VARIABLE_TYPE {type})."),
            };
        }

        int Int(int at) => BitConverter.ToInt32(m_Bytes, m_Start + at);

        int Short(int at) => BitConverter.ToUInt16(m_Bytes, m_Start + at);

        string Text(int at)
        {
            var start = m_Start + at;
            return Encoding.ASCII.GetString(m_Bytes, start, Array.IndexOf(m_Bytes, (byte)0, start) - start);
        }
    }
}
