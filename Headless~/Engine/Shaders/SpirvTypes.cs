using System;
using System.Collections.Generic;

namespace UnityEngine.Shaders
{
    /// <summary>Types, constants and decorations of a module.</summary>
    sealed class SpirvTypes
    {
        const uint DecorationMatrixStride = 7;
        const uint DecorationArrayStride = 6;
        const uint DecorationRowMajor = 4;
        const uint DecorationOffset = 35;

        readonly Dictionary<uint, SpirvInstruction> m_Types = new();
        readonly Dictionary<uint, uint> m_Constants = new();
        readonly Dictionary<(uint Id, uint Decoration), uint> m_Decorations = new();
        readonly Dictionary<(uint Id, uint Member, uint Decoration), uint> m_MemberDecorations = new();
        readonly Dictionary<(uint Id, uint Member), string> m_MemberNames = new();

        internal SpirvInstruction this[uint id] => m_Types[id];

        internal void Visit(SpirvInstruction i)
        {
            switch (i.Op)
            {
                case >= SpirvOp.TypeBool and <= SpirvOp.TypePointer:
                    m_Types[i[1]] = i;
                    break;
                case SpirvOp.Constant:
                    m_Constants[i[2]] = i[3];
                    break;
                case SpirvOp.Decorate:
                    m_Decorations[(i[1], i[2])] = i.Length > 3 ? i[3] : 0;
                    break;
                case SpirvOp.MemberDecorate:
                    m_MemberDecorations[(i[1], i[2], i[3])] = i.Length > 4 ? i[4] : 0;
                    break;
                case SpirvOp.MemberName:
                    m_MemberNames[(i[1], i[2])] = i.Text(3);
                    break;
            }
        }

        internal bool HasDecoration(uint id, uint decoration) => m_Decorations.ContainsKey((id, decoration));

        internal bool TryDecoration(uint id, uint decoration, out uint value) => m_Decorations.TryGetValue((id, decoration), out value);

        internal bool HasMemberDecoration(uint id, uint member, uint decoration) => m_MemberDecorations.ContainsKey((id, member, decoration));

        /// <summary>The members of a block. Members of structs inside it are named "outer.inner" and cannot be set by name.</summary>
        internal List<ConstantMember> Members(SpirvInstruction block)
        {
            var members = new List<ConstantMember>();
            AddMembers(members, block, "", 0);
            return members;
        }

        internal NumberKind Number(uint type)
        {
            var t = m_Types[type];
            return t.Op switch
            {
                SpirvOp.TypeFloat => NumberKind.Float,
                SpirvOp.TypeInt => t[3] == 1 ? NumberKind.Int : NumberKind.UInt,
                SpirvOp.TypeBool => NumberKind.UInt,
                SpirvOp.TypeVector or SpirvOp.TypeMatrix or SpirvOp.TypeArray => Number(t[2]),
                _ => throw new NotSupportedException($"A constant of type {t.Op}"),
            };
        }

        void AddMembers(List<ConstantMember> members, SpirvInstruction block, string prefix, int start)
        {
            for (uint m = 0; m < block.Length - 2; m++)
            {
                var type = m_Types[block[(int)m + 2]];
                var offset = start + (int)m_MemberDecorations[(block[1], m, DecorationOffset)];
                var name = prefix + (m_MemberNames.TryGetValue((block[1], m), out var own) ? own : "");
                if (type.Op == SpirvOp.TypeStruct)
                    AddMembers(members, type, name + ".", offset);
                else if (type.Op == SpirvOp.TypeArray && m_Types[type[2]].Op == SpirvOp.TypeStruct)
                    throw new NotSupportedException($"'{name}' is an array of structs in a constant buffer, which cannot be set by name.");
                else
                    members.Add(new ConstantMember(name, offset, Size(type, block[1], m), Number(type[1])));
            }
        }

        int Size(SpirvInstruction type, uint block, uint member)
        {
            switch (type.Op)
            {
                case SpirvOp.TypeInt:
                case SpirvOp.TypeFloat:
                    return (int)type[2] / 8;
                case SpirvOp.TypeVector:
                    return (int)type[3] * Size(m_Types[type[2]], block, member);
                case SpirvOp.TypeMatrix:
                    // HLSL's column-major matrices are SPIR-V's row-major ones, turned over: the stride runs over whole vectors in memory.
                    var stride = (int)m_MemberDecorations[(block, member, DecorationMatrixStride)];
                    var column = m_Types[type[2]];
                    var rowMajor = m_MemberDecorations.ContainsKey((block, member, DecorationRowMajor));
                    var (vectors, length) = rowMajor ? ((int)column[3], (int)type[3]) : ((int)type[3], (int)column[3]);
                    return (vectors - 1) * stride + length * Size(m_Types[column[2]], block, member);
                case SpirvOp.TypeArray:
                    var count = (int)m_Constants[type[3]];
                    var step = (int)m_Decorations[(type[1], DecorationArrayStride)];
                    return (count - 1) * step + Size(m_Types[type[2]], block, member);
                default:
                    throw new NotSupportedException($"A constant of type {type.Op}");
            }
        }
    }
}
