using System;
using System.Runtime.InteropServices;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>Fills a constant buffer of a draw with the values set by name; what was never set is zero.</summary>
    static class DrawConstants
    {
        const string TexelSize = "_TexelSize";

        internal static void Write(in DrawSource source, KernelBinding block, Span<byte> target)
        {
            target.Clear();
            foreach (var member in block.Members)
            {
                if (source.TryNumber(member.NameId, out var value))
                {
                    Check(source.Material, member, value);
                    Write(member, value, target.Slice(member.Offset));
                }
                else if (member.Name.EndsWith(TexelSize, StringComparison.Ordinal) && member.Size == 16)
                {
                    var texel = Texel(source, member.Name.Substring(0, member.Name.Length - TexelSize.Length));
                    MemoryMarshal.Write(target.Slice(member.Offset), ref texel);
                }
            }
        }

        // A property that the shader declares as Float may be an int in its code: Unity converts those of materials.
        static void Write(ConstantMember member, ConstantValue value, Span<byte> target)
        {
            if (member.Size == 4 && value.Bytes.Length == 4 && value.Number == NumberKind.Float && member.Number != NumberKind.Float)
            {
                var number = (int)BitConverter.ToSingle(value.Bytes, 0);
                MemoryMarshal.Write(target, ref number);
                return;
            }
            if (member.Size == 4 && value.Bytes.Length == 4 && value.Number != NumberKind.Float && member.Number == NumberKind.Float)
            {
                var number = (float)BitConverter.ToInt32(value.Bytes, 0);
                MemoryMarshal.Write(target, ref number);
                return;
            }
            value.Bytes.AsSpan(0, Math.Min(value.Bytes.Length, member.Size)).CopyTo(target);
        }

        static void Check(Material material, ConstantMember member, ConstantValue value)
        {
            if (value.Bytes.Length < member.Size && member.Size > 16)
                material.WarnOnce($"'{member.Name}' has {member.Size} bytes but {value.Bytes.Length} were set");
        }

        /// <summary>One texel in texture coordinates, and the size; a default texture has 4 x 4.</summary>
        static Vector4 Texel(in DrawSource source, string texture)
        {
            if (!source.TryTexture(Shader.PropertyToID(texture), out var value) || value.Texture == null)
                return new Vector4(0.25f, 0.25f, 4, 4);
            float width = value.Texture.width, height = value.Texture.height;
            return new Vector4(1 / width, 1 / height, width, height);
        }
    }
}
