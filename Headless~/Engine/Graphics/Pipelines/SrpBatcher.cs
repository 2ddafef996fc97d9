using System;
using System.Linq;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>
    /// URP draws shaders that are compatible with its SRP Batcher without setting each material's numbers anew: only those that the shader declares as
    /// properties are kept per material. A shader is compatible if all declared numbers lie in the constant buffer UnityPerMaterial; one that declares none
    /// is. This host sets all numbers for every draw, so it has to say where Unity would mix them up.
    /// </summary>
    static class SrpBatcher
    {
        const string PerMaterial = "UnityPerMaterial";

        static readonly string[] s_OfTextures = { "_ST", "_TexelSize", "_HDR" };

        /// <summary>Logs an error, once per material, where a number is set to a material of a compatible shader that does not declare it.</summary>
        internal static void Check(Material material, PassVariant variant)
        {
            var blocks = variant.VertexBindings.Concat(variant.FragmentBindings).Where(b => b.Kind == BindingKind.ConstantBuffer).ToList();
            bool IsDeclared(ConstantMember member) => material.shader.FindProperty(Property(member.Name)) != null;
            if (blocks.Exists(block => block.Name != PerMaterial && block.Members.Any(IsDeclared)))
                return;
            foreach (var member in blocks.SelectMany(block => block.Members))
                if (!IsDeclared(member) && material.Values.HasNumber(member.NameId))
                    material.ErrorOnce($"'{member.Name}' is set to the material, but the shader does not declare it as a property: URP's SRP Batcher may draw "
                        + "with another material's value");
        }

        /// <summary>The property that a number belongs to: that of its name, or a texture.</summary>
        static int Property(string name)
        {
            var texture = Array.Find(s_OfTextures, suffix => name.EndsWith(suffix, StringComparison.Ordinal));
            return Shader.PropertyToID(texture == null ? name : name.Substring(0, name.Length - texture.Length));
        }
    }
}
