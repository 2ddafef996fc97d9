using System;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>Fills a kernel's constant buffer with the values set by name; what was never set is zero.</summary>
    static class ConstantWriter
    {
        internal static void Write(ComputeShader shader, KernelBinding block, Span<byte> target)
        {
            target.Clear();
            foreach (var member in block.Members)
            {
                if (!shader.Values.TryGet(member.NameId, out var value) && !ShaderGlobals.Values.TryGet(member.NameId, out value))
                    continue;
                Check(shader, member, value);
                value.Bytes.AsSpan(0, Math.Min(value.Bytes.Length, member.Size)).CopyTo(target.Slice(member.Offset));
            }
        }

        static void Check(ComputeShader shader, ConstantMember member, ConstantValue value)
        {
            if (!GpuOptions.Strict)
                return;
            if ((value.Number == NumberKind.Float) != (member.Number == NumberKind.Float))
                shader.WarnOnce($"'{member.Name}' is of {member.Number} but was set as {value.Number}: Unity copies the bits as they are");
            if (member.Size > 16 && value.Bytes.Length < member.Size && value.Bytes.Length % 16 != 0)
                shader.WarnOnce($"'{member.Name}' has {member.Size} bytes but {value.Bytes.Length} were set: array elements start on rows of 16 bytes");
        }
    }
}
