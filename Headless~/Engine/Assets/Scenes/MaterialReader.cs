using System;
using System.Linq;
using UnityEngine.Rendering;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>Reads materials. Saved values of properties that the shader does not have are passed over: Unity keeps those of shaders used before.</summary>
    static class MaterialReader
    {
        /// <summary>A material needs its shader from the beginning.</summary>
        /// <exception cref="AssetFormatException">It has none, or one that the host does not have.</exception>
        internal static Material Construct(NativeFields fields)
        {
            if (fields.Any("m_Parent") is not null)
                throw fields.Document.Error(fields.Body, "variants of materials are not supported");
            return fields.Any("m_Shader") switch
            {
                Shader shader => new Material(shader),
                DataAsset known => throw fields.Document.Error(fields.Body, $"its shader is '{known.name}', which the host does not have"),
                _ => throw fields.Document.Error(fields.Body, "m_Shader is no shader"),
            };
        }

        internal static void Read(Material material, NativeFields fields)
        {
            material.name = fields.Get("m_Name", "");
            material.renderQueue = fields.Get("m_CustomRenderQueue", -1);
            material.enableInstancing = fields.Get("m_EnableInstancingVariants", false);
            material.doubleSidedGI = fields.Get("m_DoubleSidedGI", false);
            var keywords = fields.Get("m_ValidKeywords", Array.Empty<string>());
            foreach (var keyword in keywords.Concat(fields.Get("m_ShaderKeywords", "").Split(' ', StringSplitOptions.RemoveEmptyEntries)))
                material.EnableKeyword(keyword);
            foreach (var pass in fields.Get("disabledShaderPasses", Array.Empty<string>()))
                material.SetShaderPassEnabled(pass, false);
            foreach (var tag in fields.Part("stringTagMap").Children)
                material.SetOverrideTag(YamlNodes.Key(tag), fields.Document.Scalar(tag.Value));
            ReadValues(material, fields, fields.Part("m_SavedProperties"));
        }

        static void ReadValues(Material material, NativeFields fields, YamlMappingNode saved)
        {
            Each(fields, saved, "m_TexEnvs", (name, item) => SetTexture(material, fields, name, fields.Document.Mapping(item)));
            Each(fields, saved, "m_Ints", (name, item) =>
            {
                if (material.HasInteger(name))
                    material.SetInteger(name, fields.Value<int>(item));
            });
            Each(fields, saved, "m_Floats", (name, item) =>
            {
                if (material.HasFloat(name))
                    material.SetFloat(name, fields.Value<float>(item));
            });
            Each(fields, saved, "m_Colors", (name, item) =>
            {
                var value = fields.Value<Color>(item);
                var index = material.shader.FindPropertyIndex(name);
                if (index < 0)
                    return;
                if (material.shader.GetPropertyType(index) == ShaderPropertyType.Vector)
                    material.SetVector(name, value);
                else
                    material.SetColor(name, value);
            });
        }

        static void SetTexture(Material material, NativeFields fields, string name, YamlMappingNode item)
        {
            if (!material.HasTexture(name))
                return;
            if (fields.Get<Texture>(item, "m_Texture", null) is { } texture)
                material.SetTexture(name, texture);
            material.SetTextureScale(name, fields.Get(item, "m_Scale", Vector2.one));
            material.SetTextureOffset(name, fields.Get(item, "m_Offset", Vector2.zero));
        }

        /// <summary>A list whose items have one field each, named after the property.</summary>
        static void Each(NativeFields fields, YamlMappingNode saved, string key, Action<string, YamlNode> act)
        {
            foreach (var item in fields.Document.List(YamlNodes.Child(saved, key)))
                foreach (var field in fields.Document.Mapping(item).Children)
                    act(YamlNodes.Key(field), field.Value);
        }
    }
}
