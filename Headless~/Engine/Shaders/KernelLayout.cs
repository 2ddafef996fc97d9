using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine.Shaders
{
    /// <summary>What kind of thing a kernel wants at a binding.</summary>
    enum BindingKind
    {
        Texture,

        /// <summary>A texture with its sampler in one, as sampler2D declares it.</summary>
        SampledTexture,
        RandomWriteTexture,
        Sampler,
        ConstantBuffer,
        Buffer,
        RandomWriteBuffer,

        /// <summary>A buffer that is read as texels of 32 bits.</summary>
        TexelBuffer,
    }

    /// <summary>How the bits of a number are read.</summary>
    enum NumberKind
    {
        Float,
        Int,
        UInt,
    }

    /// <summary>A variable in a constant buffer. Offsets and sizes in bytes.</summary>
    sealed class ConstantMember
    {
        internal ConstantMember(string name, int offset, int size, NumberKind number)
        {
            Name = name;
            NameId = Shader.PropertyToID(name);
            Offset = offset;
            Size = size;
            Number = number;
        }

        internal string Name { get; }

        internal int NameId { get; }

        internal int Offset { get; }

        internal int Size { get; }

        internal NumberKind Number { get; }
    }

    /// <summary>A resource of a kernel.</summary>
    sealed class KernelBinding
    {
        internal string Name;
        internal int NameId;

        /// <summary>What the code calls it, which need not be the source's name.</summary>
        internal string Variable;

        internal uint Index;
        internal BindingKind Kind;

        /// <summary>Of textures.</summary>
        internal TextureDimension Dimension;

        /// <summary>Of textures: what the shader reads or writes.</summary>
        internal NumberKind Number;

        /// <summary>Of random-write textures: loads or atomics occur.</summary>
        internal bool Reads;

        /// <summary>Of random-write textures: stores or atomics occur.</summary>
        internal bool Writes;

        /// <summary>Of random-write textures that are read: the SPIR-V image format.</summary>
        internal uint ImageFormat;

        /// <summary>Of structured buffers: bytes per element; 4 for raw ones.</summary>
        internal int Stride;

        /// <summary>Of the hidden buffer of an append, consume or counter buffer: the counter of the buffer with this name.</summary>
        internal bool IsCounter;

        /// <summary>Of constant buffers: bytes.</summary>
        internal int Size;

        /// <summary>Of constant buffers.</summary>
        internal IReadOnlyList<ConstantMember> Members;
    }

    /// <summary>What a compiled kernel needs.</summary>
    sealed class KernelLayout
    {
        internal KernelLayout(int x, int y, int z, IReadOnlyList<KernelBinding> bindings)
        {
            GroupX = x;
            GroupY = y;
            GroupZ = z;
            Bindings = bindings;
        }

        internal int GroupX { get; }

        internal int GroupY { get; }

        internal int GroupZ { get; }

        internal IReadOnlyList<KernelBinding> Bindings { get; }
    }
}
