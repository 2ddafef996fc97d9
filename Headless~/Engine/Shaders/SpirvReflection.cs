using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Rendering;

namespace UnityEngine.Shaders
{
    /// <summary>Reads a kernel's resources out of its SPIR-V.</summary>
    sealed class SpirvReflection
    {
        const uint DecorationBlock = 2;
        const uint DecorationBufferBlock = 3;
        const uint DecorationArrayStride = 6;
        const uint DecorationNonWritable = 24;
        const uint DecorationBinding = 33;
        const uint ModeLocalSize = 17;
        const uint DimBuffer = 5;
        const string CounterSuffix = "@count";

        readonly SpirvTypes m_Types = new();
        readonly Dictionary<uint, string> m_Names = new();
        readonly Dictionary<uint, uint> m_Loaded = new();
        readonly HashSet<uint> m_Read = new();
        readonly HashSet<uint> m_Written = new();
        readonly List<SpirvInstruction> m_Variables = new();
        int m_X = 1, m_Y = 1, m_Z = 1;

        SpirvReflection()
        {
        }

        internal static KernelLayout Reflect(SpirvModule module)
        {
            var reflection = new SpirvReflection();
            foreach (var instruction in module.Instructions())
                reflection.Visit(instruction);
            var bindings = reflection.m_Variables.Select(reflection.Binding).Where(b => b != null).OrderBy(b => b.Index).ToList();
            return new KernelLayout(reflection.m_X, reflection.m_Y, reflection.m_Z, bindings);
        }

        void Visit(SpirvInstruction i)
        {
            switch (i.Op)
            {
                case SpirvOp.Name:
                    m_Names[i[1]] = i.Text(2);
                    break;
                case SpirvOp.ExecutionMode when i[2] == ModeLocalSize:
                    (m_X, m_Y, m_Z) = ((int)i[3], (int)i[4], (int)i[5]);
                    break;
                case SpirvOp.Variable:
                    m_Variables.Add(i);
                    break;
                case SpirvOp.Load:
                    m_Loaded[i[2]] = i[3];
                    break;
                case SpirvOp.CopyObject when m_Loaded.TryGetValue(i[3], out var variable):
                    m_Loaded[i[2]] = variable;
                    break;
                case SpirvOp.ImageRead when m_Loaded.TryGetValue(i[3], out var variable):
                    m_Read.Add(variable);
                    break;
                case SpirvOp.ImageWrite when m_Loaded.TryGetValue(i[1], out var variable):
                    m_Written.Add(variable);
                    break;
                case SpirvOp.ImageTexelPointer:
                    m_Read.Add(i[3]);
                    m_Written.Add(i[3]);
                    break;
                default:
                    m_Types.Visit(i);
                    break;
            }
        }

        /// <summary>Why a Buffer or RWBuffer, of numbers and not of structs, cannot be.</summary>
        internal static string TypedBuffer(string name) => $"'{name}' is a typed buffer; use a StructuredBuffer.";

        KernelBinding Binding(SpirvInstruction variable)
        {
            var id = variable[2];
            if (!m_Types.TryDecoration(id, DecorationBinding, out var index))
                return null;
            var type = m_Types[m_Types[variable[1]][3]];
            var binding = new KernelBinding { Index = index, Variable = m_Names.TryGetValue(id, out var name) ? name : "" };
            binding.Name = binding.Variable;
            switch (type.Op)
            {
                case SpirvOp.TypeSampler:
                    binding.Kind = BindingKind.Sampler;
                    break;
                case SpirvOp.TypeImage:
                    Image(binding, type, id);
                    break;
                case SpirvOp.TypeSampledImage:
                    Image(binding, m_Types[type[2]], id);
                    binding.Kind = BindingKind.SampledTexture;
                    break;
                case SpirvOp.TypeStruct when m_Types.HasDecoration(type[1], DecorationBufferBlock):
                    StorageBlock(binding, type);
                    break;
                case SpirvOp.TypeStruct when m_Types.HasDecoration(type[1], DecorationBlock):
                    binding.Kind = BindingKind.ConstantBuffer;
                    binding.Name = m_Names.TryGetValue(type[1], out var block) ? block : binding.Variable;
                    binding.Members = m_Types.Members(type);
                    binding.Size = (binding.Members.Select(m => m.Offset + m.Size).DefaultIfEmpty(0).Max() + 15) / 16 * 16;
                    break;
                default:
                    throw new NotSupportedException($"'{binding.Name}' is an array of resources or of a type ({type.Op}) that kernels cannot have here.");
            }
            binding.NameId = Shader.PropertyToID(binding.Name);
            return binding;
        }

        void Image(KernelBinding binding, SpirvInstruction type, uint variable)
        {
            var storage = type[7] == 2;
            binding.Number = m_Types.Number(type[2]);
            binding.Reads = m_Read.Contains(variable);
            binding.Writes = m_Written.Contains(variable);
            binding.ImageFormat = type[8];
            binding.Kind = storage ? BindingKind.RandomWriteTexture : type[3] == DimBuffer ? BindingKind.TexelBuffer : BindingKind.Texture;
            if (type[3] == DimBuffer && storage)
                throw new NotSupportedException(TypedBuffer(binding.Name));
            binding.Dimension = (type[3], type[5]) switch
            {
                (1, 0) => TextureDimension.Tex2D,
                (1, _) => TextureDimension.Tex2DArray,
                (2, _) => TextureDimension.Tex3D,
                (3, 0) => TextureDimension.Cube,
                (3, _) => TextureDimension.CubeArray,
                _ => TextureDimension.Unknown,
            };
        }

        void StorageBlock(KernelBinding binding, SpirvInstruction type)
        {
            binding.Kind = m_Types.HasMemberDecoration(type[1], 0, DecorationNonWritable) ? BindingKind.Buffer : BindingKind.RandomWriteBuffer;
            if (binding.Name.EndsWith(CounterSuffix, StringComparison.Ordinal))
            {
                binding.IsCounter = true;
                binding.Name = binding.Name.Substring(0, binding.Name.Length - CounterSuffix.Length);
                binding.Stride = 4;
                return;
            }
            binding.Stride = m_Types.TryDecoration(type[2], DecorationArrayStride, out var stride) ? (int)stride : 4;
        }
    }
}
