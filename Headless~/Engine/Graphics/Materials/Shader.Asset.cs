using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using UnityEngine.Rendering;
using UnityEngine.Shaders;

namespace UnityEngine
{
    public sealed partial class Shader
    {
        List<SubShaderProgram> m_SubShaders;
        ShaderKeywords m_Keywords;
        (string Tag, int Lod, int Packages) m_ChosenFor;
        SubShaderProgram m_Chosen;

        /// <summary>The highest level of detail that SubShaders may have; further limited by <see cref="maximumLOD"/>.</summary>
        public static int globalMaximumLOD { get; set; } = int.MaxValue;

        public int maximumLOD { get; set; } = int.MaxValue;

        /// <summary>Whether some SubShader of it or of its fallbacks can be drawn here, and its passes compile.</summary>
        public bool isSupported
        {
            get
            {
                Use("get_isSupported");
                var chosen = Chosen;
                return chosen != null && chosen.Passes.All(p => p.Variant(Array.Empty<string>(), ShaderGlobals.Keywords)?.Compile() == true);
            }
        }

        /// <summary>The queue that its materials are drawn in unless they have their own.</summary>
        public int renderQueue => ShaderQueue.Parse(Chosen?.SubShader.Tag("Queue") ?? "");

        /// <summary>Passes of the SubShader in use.</summary>
        public int passCount => Chosen?.Passes.Count ?? 0;

        public int subshaderCount => m_SubShaders.Count;

        public LocalKeywordSpace keywordSpace => new(KeywordsOfAll);

        internal ShaderLabFile File { get; private set; }

        internal override string NativeName
        {
            get => File?.Name ?? "";

            // A shader is called as its file says.
            set { }
        }

        /// <summary>The SubShader in use: the first one that fits, or a fallback's; null if none fits.</summary>
        internal SubShaderProgram Chosen
        {
            get
            {
                var tag = RenderPipelines.ShaderTag;
                var key = (tag, Math.Min(maximumLOD, globalMaximumLOD), ShaderEnvironment.Revision);
                if (m_ChosenFor == key)
                    return m_Chosen;
                m_ChosenFor = key;
                m_Keywords = null;
                m_Chosen = m_SubShaders.Find(s => s.Fits(tag, key.Item2, Renderer));
                if (m_Chosen == null && File.Fallback != null)
                    m_Chosen = Find(File.Fallback)?.Chosen;
                return m_Chosen;
            }
        }

        /// <summary>The graphics API as pragmas call it.</summary>
        static string Renderer => GpuOptions.DeviceType switch
        {
            GraphicsDeviceType.Direct3D11 or GraphicsDeviceType.Direct3D12 => "d3d11",
            GraphicsDeviceType.OpenGLCore => "glcore",
            GraphicsDeviceType.OpenGLES3 => "gles3",
            GraphicsDeviceType.Metal => "metal",
            GraphicsDeviceType.WebGPU => "webgpu",
            _ => "vulkan",
        };

        internal ShaderKeywords KeywordsOfAll => m_Keywords ??= new ShaderKeywords((Chosen?.Passes ?? Array.Empty<PassProgram>()).ToList());

        /// <summary>A shader by the name in its file: one of the package, or of those that come with the host. Null if there is none.</summary>
        public static Shader Find(string name)
        {
            MainThread.Check("Shader.Find");
            return BuiltinShaders.Find(name) ?? ShaderAssets.Find(name);
        }

        public int GetPassCountInSubshader(int subshaderIndex) => m_SubShaders[subshaderIndex].Passes.Count;

        public ShaderTagId FindPassTagValue(int passIndex, ShaderTagId tagName)
        {
            if (passIndex < 0 || passIndex >= passCount)
                throw new ArgumentOutOfRangeException(nameof(passIndex));
            return Chosen.Passes[passIndex].Pass.Tags.TryGetValue(tagName.name, out var value) ? new ShaderTagId(value) : ShaderTagId.none;
        }

        public ShaderTagId FindSubshaderTagValue(int subshaderIndex, ShaderTagId tagName) =>
            m_SubShaders[subshaderIndex].SubShader.Tags.TryGetValue(tagName.name, out var value) ? new ShaderTagId(value) : ShaderTagId.none;

        public Shader GetDependency(string name) => File.Dependencies.TryGetValue(name, out var shader) ? Find(shader) : null;

        /// <summary>Loads a file. Its passes are compiled later.</summary>
        /// <exception cref="ShaderCompileException">It cannot be read, or is no ShaderLab.</exception>
        internal static Shader Load(string path)
        {
            try
            {
                return Create(ShaderLabParser.Parse(Path.GetFullPath(path), System.IO.File.ReadAllText(path, Encoding.UTF8)));
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                throw new ShaderCompileException($"{path} cannot be read: {e.Message}", e);
            }
        }

        internal static Shader Create(ShaderLabFile file) => new()
        {
            File = file,
            m_SubShaders = file.SubShaders.Select(s => new SubShaderProgram(file, s)).ToList(),
        };
    }

    /// <summary>Queues as tags write them: "Geometry", "Transparent+10".</summary>
    static class ShaderQueue
    {
        internal static int Parse(string tag)
        {
            var text = tag.Trim();
            var sign = text.LastIndexOfAny(new[] { '+', '-' });
            var word = (sign > 0 ? text.Substring(0, sign) : text).Trim();
            var offset = sign > 0 && int.TryParse(text.Substring(sign).Replace(" ", ""), System.Globalization.NumberStyles.AllowLeadingSign,
                System.Globalization.CultureInfo.InvariantCulture, out var number) ? number : 0;
            return offset + word.ToLowerInvariant() switch
            {
                "background" => (int)RenderQueue.Background,
                "alphatest" => (int)RenderQueue.AlphaTest,
                "geometrylast" => (int)RenderQueue.GeometryLast,
                "transparent" => (int)RenderQueue.Transparent,
                "overlay" => (int)RenderQueue.Overlay,
                _ => (int)RenderQueue.Geometry,
            };
        }
    }
}
