using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>Which passes a pipeline draws, by their LightMode.</summary>
    sealed class PassRules
    {
        /// <summary>The Built-in pipeline's forward path: every pass that is meant for all, or for the main light.</summary>
        internal static readonly PassRules BuiltIn = new(false, "", "Always", "ForwardBase");

        /// <summary>URP's: the first pass of each kind. What has passes of the Built-in pipeline's light only is an error.</summary>
        internal static readonly PassRules Universal = new(true, "", "SRPDefaultUnlit", "UniversalForward", "UniversalForwardOnly")
        {
            m_ShowsErrorFor = new[] { "Always", "ForwardBase", "PrepassBase", "Vertex", "VertexLMRGBM", "VertexLM" },
            m_Batches = true,
        };

        internal static readonly PassRules ShadowCasters = new(true, "ShadowCaster");

        readonly HashSet<string> m_Modes;
        string[] m_ShowsErrorFor = Array.Empty<string>();
        readonly bool m_FirstOnly;
        bool m_Batches;

        PassRules(bool firstOnly, params string[] modes)
        {
            m_FirstOnly = firstOnly;
            m_Modes = new HashSet<string>(modes, StringComparer.OrdinalIgnoreCase);
        }

        /// <summary>Draws what of a material is to be drawn.</summary>
        internal void Draw(in DrawItem item)
        {
            if (item.Material == null || item.Material.shader == null || item.Material.shader.Chosen == null)
            {
                DrawError(item);
                return;
            }
            var drawn = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
            var passes = item.Material.Passes;
            foreach (var pass in passes)
            {
                var mode = pass.Pass.LightMode;
                if (m_Modes.Contains(mode) && item.Material.GetShaderPassEnabled(mode) && (drawn.Add(Kind(mode)) || !m_FirstOnly))
                    Drawer.Draw(item, pass, m_Batches);
            }
            if (drawn.Count == 0 && Array.Exists(m_ShowsErrorFor, mode => passes.Any(p => p.Pass.LightMode == mode)))
                DrawError(item);
        }

        // Unity shows in magenta what has no shader that works, but not in passes that are no picture.
        void DrawError(in DrawItem item)
        {
            if (this != ShadowCasters && BuiltinShaders.TryReplace(item, out var replaced, out var error))
                Drawer.Draw(replaced, error);
        }

        // A pass without a tag is one of SRPDefaultUnlit.
        static string Kind(string mode) => mode.Length == 0 ? "SRPDefaultUnlit" : mode;
    }
}
