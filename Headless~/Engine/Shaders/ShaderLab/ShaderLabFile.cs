using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine.Shaders
{
    /// <summary>What a .shader file says.</summary>
    sealed class ShaderLabFile
    {
        internal ShaderLabFile(string path, string name)
        {
            Path = path;
            Name = name;
        }

        /// <summary>Where the text came from; for messages, #line and #include.</summary>
        internal string Path { get; }

        internal string Name { get; }

        internal List<ShaderLabProperty> Properties { get; } = new();

        internal List<ShaderLabSubShader> SubShaders { get; } = new();

        /// <summary>The shader that is used if no SubShader fits; null if there is none.</summary>
        internal string Fallback { get; set; }

        internal string CustomEditor { get; set; }

        internal Dictionary<string, string> Dependencies { get; } = new(StringComparer.Ordinal);
    }

    /// <summary>A property of a shader, which materials have values for.</summary>
    sealed class ShaderLabProperty
    {
        internal string Name;
        internal int NameId;
        internal string Description;
        internal ShaderPropertyType Type;
        internal List<string> Attributes = new();
        internal Vector2 Range;

        /// <summary>Of numbers: in x.</summary>
        internal Vector4 Default;
        internal string DefaultTexture = "";
        internal TextureDimension Dimension = TextureDimension.None;
        internal int Line;

        internal ShaderPropertyFlags Flags
        {
            get
            {
                var flags = ShaderPropertyFlags.None;
                foreach (var attribute in Attributes)
                    flags |= attribute switch
                    {
                        "HideInInspector" => ShaderPropertyFlags.HideInInspector,
                        "PerRendererData" => ShaderPropertyFlags.PerRendererData,
                        "NoScaleOffset" => ShaderPropertyFlags.NoScaleOffset,
                        "Normal" => ShaderPropertyFlags.Normal,
                        "HDR" => ShaderPropertyFlags.HDR,
                        "Gamma" => ShaderPropertyFlags.Gamma,
                        "NonModifiableTextureData" => ShaderPropertyFlags.NonModifiableTextureData,
                        "MainTexture" => ShaderPropertyFlags.MainTexture,
                        "MainColor" => ShaderPropertyFlags.MainColor,
                        _ => ShaderPropertyFlags.None,
                    };
                return flags;
            }
        }
    }

    /// <summary>A version of a package that a SubShader asks for.</summary>
    readonly struct PackageRequirement
    {
        internal PackageRequirement(string package, string version)
        {
            Package = package;
            Version = version;
        }

        internal readonly string Package;

        /// <summary>A lowest version or an interval in Unity's notation; null for any.</summary>
        internal readonly string Version;
    }

    /// <summary>One way to draw a shader.</summary>
    sealed class ShaderLabSubShader
    {
        internal List<PackageRequirement> Requirements { get; } = new();

        internal Dictionary<string, string> Tags { get; } = new(StringComparer.OrdinalIgnoreCase);

        internal int Lod { get; set; }

        internal List<ShaderLabPass> Passes { get; } = new();

        internal string Tag(string name) => Tags.TryGetValue(name, out var value) ? value : "";
    }

    /// <summary>One pass: fixed states, and the code of its stages.</summary>
    sealed class ShaderLabPass
    {
        internal string Name { get; set; } = "";

        internal Dictionary<string, string> Tags { get; } = new(StringComparer.OrdinalIgnoreCase);

        internal ShaderLabState State { get; set; }

        internal ShaderLabCode Code { get; set; }

        internal int Line { get; set; }

        internal string LightMode => Tags.TryGetValue("LightMode", out var mode) ? mode : "";
    }

    /// <summary>A block of HLSL as it stands in the file.</summary>
    readonly struct ShaderLabBlock
    {
        internal ShaderLabBlock(string text, int line)
        {
            Text = text;
            Line = line;
        }

        internal readonly string Text;

        /// <summary>Of the line before the first one of the text, where the block opens.</summary>
        internal readonly int Line;
    }

    /// <summary>All the code of a pass.</summary>
    sealed class ShaderLabCode
    {
        /// <summary>HLSLINCLUDE blocks around the program, from the outside in, then the program.</summary>
        internal List<ShaderLabBlock> Blocks { get; } = new();

        /// <summary>CGPROGRAM, which Unity gives its own include files to unasked.</summary>
        internal bool IsCg { get; set; }
    }
}
