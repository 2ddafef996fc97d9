using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.Shaders
{
    /// <summary>
    /// glslang gives every random-write texture a 32-bit format, but Unity lets a kernel write any format. So textures that are only
    /// written lose their format here, which the capability StorageImageWriteWithoutFormat makes valid. Textures that are read keep it:
    /// those must be of one 32-bit channel anyway.
    /// </summary>
    sealed class SpirvRewriter
    {
        const uint CapabilityWriteWithoutFormat = 56;
        const uint FormatUnknown = 0;
        const uint Storage = 2;

        readonly SpirvModule m_Module;
        readonly Dictionary<uint, SpirvInstruction> m_Images = new();
        readonly Dictionary<uint, SpirvInstruction> m_Pointers = new();
        readonly Dictionary<uint, uint> m_ImageOfVariable = new();
        readonly Dictionary<uint, uint> m_VariableOfValue = new();
        readonly HashSet<uint> m_Kept = new();
        readonly Dictionary<uint, (uint Image, uint Pointer)> m_NewTypes = new();
        uint m_Bound;

        SpirvRewriter(SpirvModule module)
        {
            m_Module = module;
            m_Bound = module.Bound;
        }

        internal static SpirvModule WithoutFormats(SpirvModule module)
        {
            var rewriter = new SpirvRewriter(module);
            foreach (var instruction in module.Instructions())
                rewriter.Scan(instruction);
            var free = rewriter.m_ImageOfVariable.Where(v => !rewriter.m_Kept.Contains(v.Key)).ToDictionary(v => v.Key, v => v.Value);
            return free.Count == 0 ? module : rewriter.Rewrite(free);
        }

        void Scan(SpirvInstruction i)
        {
            switch (i.Op)
            {
                case SpirvOp.TypeImage when i[7] == Storage && i[8] != FormatUnknown:
                    m_Images[i[1]] = i;
                    break;
                case SpirvOp.TypePointer:
                    m_Pointers[i[1]] = i;
                    break;
                case SpirvOp.Variable when m_Pointers.TryGetValue(i[1], out var pointer) && m_Images.ContainsKey(pointer[3]):
                    m_ImageOfVariable[i[2]] = pointer[3];
                    break;
                case SpirvOp.Load when m_ImageOfVariable.ContainsKey(i[3]):
                    m_VariableOfValue[i[2]] = i[3];
                    break;
                case SpirvOp.FunctionCall or SpirvOp.ImageTexelPointer or SpirvOp.AccessChain or SpirvOp.CopyObject
                    or SpirvOp.ImageRead or SpirvOp.Select or SpirvOp.Phi:
                    // These need the format: loads and atomics themselves, and uses that are not followed any further here.
                    for (var w = 1; w < i.Length; w++)
                    {
                        if (m_ImageOfVariable.ContainsKey(i[w]))
                            m_Kept.Add(i[w]);
                        else if (m_VariableOfValue.TryGetValue(i[w], out var variable))
                            m_Kept.Add(variable);
                    }
                    break;
            }
        }

        SpirvModule Rewrite(Dictionary<uint, uint> free)
        {
            var output = new List<uint>(m_Module.Words.Length + 64);
            output.AddRange(m_Module.Words.Take(SpirvModule.HeaderLength));
            var capability = true;
            foreach (var i in m_Module.Instructions())
            {
                if (capability && i.Op == SpirvOp.Capability)
                {
                    output.Add((2u << 16) | (uint)SpirvOp.Capability);
                    output.Add(CapabilityWriteWithoutFormat);
                    capability = false;
                }
                var start = output.Count;
                if (i.Op == SpirvOp.Variable && free.TryGetValue(i[2], out var image))
                {
                    var types = NewTypes(output, image);
                    start = output.Count;
                    Copy(output, i);
                    output[start + 1] = types.Pointer;
                    continue;
                }
                Copy(output, i);
                if (i.Op == SpirvOp.Load && free.TryGetValue(i[3], out image))
                    output[start + 1] = m_NewTypes[image].Image;
            }
            output[3] = m_Bound;
            return new SpirvModule(output.ToArray());
        }

        (uint Image, uint Pointer) NewTypes(List<uint> output, uint image)
        {
            var old = m_Images[image];
            // Two formats of the same shape become the same type, and a module may declare it only once.
            foreach (var (key, types) in m_NewTypes)
                if (SameShape(m_Images[key], old))
                    return m_NewTypes[image] = types;
            var added = (Image: m_Bound++, Pointer: m_Bound++);
            var start = output.Count;
            Copy(output, old);
            output[start + 1] = added.Image;
            output[start + 8] = FormatUnknown;
            output.Add((4u << 16) | (uint)SpirvOp.TypePointer);
            output.Add(added.Pointer);
            output.Add(0); // UniformConstant
            output.Add(added.Image);
            return m_NewTypes[image] = added;
        }

        static bool SameShape(SpirvInstruction a, SpirvInstruction b) =>
            a[2] == b[2] && a[3] == b[3] && a[4] == b[4] && a[5] == b[5] && a[6] == b[6];

        void Copy(List<uint> output, SpirvInstruction i) =>
            output.AddRange(new ArraySegment<uint>(m_Module.Words, i.Position, i.Length));
    }
}
