using System;
using System.Collections.Generic;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>What is read where no texture is set: by the default's name in the shader, of any kind that a shader can ask for.</summary>
    static class DefaultTextures
    {
        static readonly Dictionary<(string Name, TextureDimension Dimension, NumberKind Number), Texture> s_Made = new();

        internal static Vulkan.SamplerState Sampler => new(FilterMode.Bilinear, TextureWrapMode.Repeat, TextureWrapMode.Repeat, TextureWrapMode.Repeat);

        /// <exception cref="NotSupportedException">A cube map.</exception>
        internal static Texture Of(string name, TextureDimension dimension, NumberKind number)
        {
            var key = (Color(name).Name, dimension, number);
            if (!s_Made.TryGetValue(key, out var texture) || texture == null)
                s_Made[key] = texture = Create(key.Name, dimension, number);
            return texture;
        }

        internal static void Clear()
        {
            foreach (var texture in s_Made.Values)
                if (texture != null)
                    Object.DestroyImmediate(texture, true);
            s_Made.Clear();
        }

        static (string Name, Color Value) Color(string name) => name switch
        {
            "white" => ("white", new Color(1, 1, 1, 1)),
            "black" => ("black", new Color(0, 0, 0, 0)),
            "red" => ("red", new Color(1, 0, 0, 0)),
            "bump" => ("bump", new Color(0.5f, 0.5f, 1f, 0.5f)),
            "linearGray" or "linearGrey" => ("linearGray", new Color(0.5f, 0.5f, 0.5f, 0.5f)),
            _ => ("gray", new Color(0.5f, 0.5f, 0.5f, 0.5f)),
        };

        static Texture Create(string name, TextureDimension dimension, NumberKind number)
        {
            // "gray" is half as bright as white for people, so it is stored as sRGB; data-like defaults are not.
            var format = number switch
            {
                NumberKind.UInt => GraphicsFormat.R32_UInt,
                NumberKind.Int => GraphicsFormat.R32_SInt,
                _ => name == "gray" ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm,
            };
            var bytes = number == NumberKind.Float ? Bytes(Color(name).Value) : new byte[4];
            Texture texture;
            switch (dimension)
            {
                case TextureDimension.Tex2D:
                    var flat = new Texture2D(1, 1, format, TextureCreationFlags.None);
                    flat.SetPixelData(bytes, 0);
                    flat.Apply(false, true);
                    texture = flat;
                    break;
                case TextureDimension.Tex3D:
                    var volume = new Texture3D(1, 1, 1, format, TextureCreationFlags.None);
                    volume.SetPixelData(bytes, 0);
                    volume.Apply(false, true);
                    texture = volume;
                    break;
                case TextureDimension.Tex2DArray:
                    var array = new Texture2DArray(1, 1, 2, format, TextureCreationFlags.None);
                    array.SetPixelData(bytes, 0, 0);
                    array.SetPixelData(bytes, 0, 1);
                    array.Apply(false, true);
                    texture = array;
                    break;
                default:
                    throw new NotSupportedException($"a shader reads a texture of the dimension {dimension}, which this host does not have");
            }
            texture.name = "Unity's " + name;
            ObjectRegistry.Remove(texture);
            return texture;
        }

        static byte[] Bytes(Color color)
        {
            var c = (Color32)color;
            return new[] { c.r, c.g, c.b, c.a };
        }
    }
}
