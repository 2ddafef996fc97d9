using System;
using System.Collections.Generic;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>The shaders that come with the host in place of Unity's, by their names. They are simple: colour, texture, one light.</summary>
    static class BuiltinShaders
    {
        const string ErrorName = "Hidden/InternalErrorShader";
        const string Universal = "Universal Render Pipeline/";

        static readonly Dictionary<string, string> s_Files = new(StringComparer.Ordinal)
        {
            ["Standard"] = "Lit",
            ["Universal Render Pipeline/Lit"] = "UniversalLit",
            ["Universal Render Pipeline/Simple Lit"] = "UniversalLit",
            ["Universal Render Pipeline/Unlit"] = "UniversalUnlit",
            ["Unlit/Color"] = "UnlitColor",
            ["Unlit/Texture"] = "UnlitTexture",
            ["Sprites/Default"] = "Sprites",
            ["Hidden/BlitCopy"] = "BlitCopy",
            [ErrorName] = "Error",
        };

        static readonly Dictionary<string, Shader> s_Loaded = new(StringComparer.Ordinal);
        static Material s_Error;

        /// <summary>Null if there is none of that name.</summary>
        internal static Shader Find(string name)
        {
            if (!s_Files.TryGetValue(name, out var file) || (name.StartsWith(Universal, StringComparison.Ordinal) && !HasUniversal))
                return null;
            if (s_Loaded.TryGetValue(name, out var shader) && shader != null)
                return shader;
            var path = ShaderEnvironment.LibraryPrefix + "Shaders/" + file + ".shader";
            var parsed = ShaderLabParser.Parse(path, ShaderEnvironment.ReadLibrary(path).Replace("@NAME@", name));
            shader = Shader.Create(parsed);
            shader.IsAsset = true;
            ObjectRegistry.Remove(shader);
            return s_Loaded[name] = shader;
        }

        /// <summary>The same draw with the shader that stands for errors; false if that is what failed.</summary>
        internal static bool TryReplace(in DrawItem item, out DrawItem replaced, out PassProgram pass)
        {
            replaced = item;
            pass = null;
            if (s_Error == null)
            {
                s_Error = new Material(Find(ErrorName)) { name = "Error" };
                ObjectRegistry.Remove(s_Error);
            }
            if (ReferenceEquals(item.Material, s_Error))
                return false;
            replaced.Material = s_Error;
            replaced.Block = null;
            pass = s_Error.Passes[0];
            return true;
        }

        static bool HasUniversal => ShaderEnvironment.HasPackage(ShaderEnvironment.UniversalPackage);

        internal static void Clear()
        {
            s_Error?.Kill();
            s_Error = null;
            foreach (var shader in s_Loaded.Values)
                shader.Kill();
            s_Loaded.Clear();
        }
    }

    /// <summary>The package's shaders by the names in their files.</summary>
    static class ShaderAssets
    {
        internal const string Extension = ".shader";

        internal const long FileId = 4800000;

        internal static Shader Find(string name)
        {
            foreach (var path in AssetLibrary.Files(Extension))
                if (AssetLibrary.LoadFile(path).TryGetValue(FileId, out var asset) && asset is Shader shader && shader.File.Name == name)
                    return shader;
            return null;
        }
    }
}
