using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.Shaders
{
    /// <summary>Makes a vertex stage say that points have the size of a pixel, which Vulkan wants to be told and HLSL cannot say.</summary>
    static class PointSize
    {
        const uint DecorationBuiltIn = 11;
        const uint BuiltInPointSize = 1;
        const uint StorageOutput = 3;

        internal static byte[] Add(byte[] code)
        {
            var module = SpirvModule.Parse(code);
            var instructions = module.Instructions().ToList();
            var (pointer, size, one) = (module.Bound, module.Bound + 1, module.Bound + 2);
            var number = instructions.First(i => i.Op == SpirvOp.TypeFloat && i[2] == 32)[1];
            var entry = instructions.First(i => i.Op == SpirvOp.EntryPoint)[2];
            var output = new List<uint>(module.Words.Length + 24);
            output.AddRange(module.Words.Take(SpirvModule.HeaderLength));
            output[3] = module.Bound + 3;
            bool decorated = false, declared = false, inEntry = false, begun = false;
            foreach (var i in instructions)
            {
                if (!decorated && i.Op is >= SpirvOp.TypeVoid and <= SpirvOp.TypePointer)
                {
                    Append(output, SpirvOp.Decorate, size, DecorationBuiltIn, BuiltInPointSize);
                    decorated = true;
                }
                if (i.Op == SpirvOp.Function)
                {
                    if (!declared)
                    {
                        Append(output, SpirvOp.TypePointer, pointer, StorageOutput, number);
                        Append(output, SpirvOp.Variable, pointer, size, StorageOutput);
                        Append(output, SpirvOp.Constant, number, one, (uint)BitConverter.SingleToInt32Bits(1f));
                        declared = true;
                    }
                    inEntry = i[2] == entry;
                }
                // Local variables come first in a function.
                if (inEntry && begun && i.Op != SpirvOp.Variable)
                {
                    Append(output, SpirvOp.Store, size, one);
                    inEntry = begun = false;
                }
                begun |= inEntry && i.Op == SpirvOp.Label;
                var start = output.Count;
                output.AddRange(new ArraySegment<uint>(module.Words, i.Position, i.Length));
                if (i.Op != SpirvOp.EntryPoint)
                    continue;
                output.Add(size);
                output[start] += 1u << 16;
            }
            var bytes = new byte[output.Count * 4];
            Buffer.BlockCopy(output.ToArray(), 0, bytes, 0, bytes.Length);
            return bytes;
        }

        static void Append(List<uint> output, SpirvOp op, params uint[] operands)
        {
            output.Add(((uint)(operands.Length + 1) << 16) | (uint)op);
            output.AddRange(operands);
        }
    }
}
