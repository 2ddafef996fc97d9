using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Rendering;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>A shader with values for its properties. Destroy it: nobody else does.</summary>
    public partial class Material : Object
    {
        readonly ShaderValues m_Values = new();
        readonly HashSet<string> m_Keywords = new(StringComparer.Ordinal);
        readonly HashSet<string> m_DisabledPasses = new(StringComparer.Ordinal);
        readonly Dictionary<string, string> m_OverrideTags = new(StringComparer.OrdinalIgnoreCase);
        readonly HashSet<string> m_Warned = new(StringComparer.Ordinal);
        Shader m_Shader;
        int m_Queue = -1;

        /// <exception cref="ArgumentNullException">No shader.</exception>
        public Material(Shader shader)
        {
            MainThread.Check("Material constructor");
            if (shader == null)
            {
                Kill();
                throw new ArgumentNullException(nameof(shader));
            }
            m_Shader = shader;
            NativeName = shader.name;
            AddDefaults();
        }

        /// <exception cref="ArgumentNullException">No material.</exception>
        public Material(Material source)
        {
            MainThread.Check("Material constructor");
            if (source == null)
            {
                Kill();
                throw new ArgumentNullException(nameof(source));
            }
            NativeName = source.NativeName;
            m_Shader = source.m_Shader;
            CopyPropertiesFromMaterial(source);
        }

        /// <summary>Setting another one keeps the values of properties that it has too.</summary>
        public Shader shader
        {
            get { Use("get_shader"); return m_Shader; }
            set
            {
                Use("set_shader");
                m_Shader = value != null ? value : throw new ArgumentNullException(nameof(value));
                AddDefaults();
            }
        }

        /// <summary>The order in which it is drawn; -1 goes back to the shader's.</summary>
        public int renderQueue
        {
            get { Use("get_renderQueue"); return m_Queue >= 0 ? m_Queue : m_Shader != null ? m_Shader.renderQueue : (int)RenderQueue.Geometry; }
            set { Use("set_renderQueue"); m_Queue = value; }
        }

        /// <summary>The queue that was set; -1 if none was.</summary>
        public int rawRenderQueue => m_Queue;

        public bool enableInstancing { get; set; }

        public bool doubleSidedGI { get; set; }

        public int passCount
        {
            get { Use("get_passCount"); return m_Shader != null ? m_Shader.passCount : 0; }
        }

        /// <summary>The property with the attribute [MainColor], or _Color.</summary>
        public Color color { get => GetColor(MainColorName); set => SetColor(MainColorName, value); }

        /// <summary>The property with the attribute [MainTexture], or _MainTex.</summary>
        public Texture mainTexture { get => GetTexture(MainTextureName); set => SetTexture(MainTextureName, value); }

        public Vector2 mainTextureOffset { get => GetTextureOffset(MainTextureName); set => SetTextureOffset(MainTextureName, value); }

        public Vector2 mainTextureScale { get => GetTextureScale(MainTextureName); set => SetTextureScale(MainTextureName, value); }

        internal ShaderValues Values => m_Values;

        internal ICollection<string> KeywordSet => m_Keywords;

        /// <summary>-1 if there is none of that name.</summary>
        public int FindPass(string passName)
        {
            Use("FindPass");
            var passes = Passes;
            for (var i = 0; i < passes.Count; i++)
                if (string.Equals(passes[i].Pass.Name, passName, StringComparison.OrdinalIgnoreCase))
                    return i;
            return -1;
        }

        public string GetPassName(int pass)
        {
            Use("GetPassName");
            return pass >= 0 && pass < Passes.Count ? Passes[pass].Pass.Name : "";
        }

        /// <summary>A tag of the material itself, or of its SubShader.</summary>
        public string GetTag(string tag, bool searchFallbacks) => GetTag(tag, searchFallbacks, "");

        public string GetTag(string tag, bool searchFallbacks, string defaultValue)
        {
            Use("GetTag");
            if (m_OverrideTags.TryGetValue(tag, out var value) || (m_Shader.Chosen?.SubShader.Tags.TryGetValue(tag, out value) ?? false))
                return value;
            return defaultValue;
        }

        public void SetOverrideTag(string tag, string val)
        {
            Use("SetOverrideTag");
            if (string.IsNullOrEmpty(val))
                m_OverrideTags.Remove(tag);
            else
                m_OverrideTags[tag] = val;
        }

        /// <summary>Whether passes with that LightMode are drawn.</summary>
        public bool GetShaderPassEnabled(string passName) => !m_DisabledPasses.Contains(passName);

        public void SetShaderPassEnabled(string passName, bool enabled)
        {
            Use("SetShaderPassEnabled");
            if (enabled)
                m_DisabledPasses.Remove(passName);
            else
                m_DisabledPasses.Add(passName);
        }

        /// <summary>Makes a pass the one that Graphics.DrawMeshNow draws with. False if it cannot be drawn.</summary>
        public bool SetPass(int pass)
        {
            Use("SetPass");
            return ImmediateDrawing.SetPass(this, pass);
        }

        /// <summary>Takes over all values, keywords and the queue.</summary>
        public void CopyPropertiesFromMaterial(Material mat)
        {
            Use("CopyPropertiesFromMaterial");
            if (mat == null)
                throw new ArgumentNullException(nameof(mat));
            m_Values.Clear();
            mat.m_Values.CopyTo(m_Values);
            m_Keywords.Clear();
            m_Keywords.UnionWith(mat.m_Keywords);
            m_DisabledPasses.UnionWith(mat.m_DisabledPasses);
            foreach (var (tag, value) in mat.m_OverrideTags)
                m_OverrideTags[tag] = value;
            m_Queue = mat.m_Queue;
            enableInstancing = mat.enableInstancing;
            AddDefaults();
        }

        internal override Object CloneNative() => new Material(this);

        internal IReadOnlyList<PassProgram> Passes =>
            m_Shader != null && m_Shader.Chosen is { } chosen ? chosen.Passes : Array.Empty<PassProgram>();

        /// <summary>Logs a warning once per material, in strict mode only.</summary>
        internal void WarnOnce(string message)
        {
            if (GpuOptions.Strict && m_Warned.Add(message))
                Debug.LogWarning($"Material '{NameForMessages}' with shader '{m_Shader.NameForMessages}': {message}");
        }

        /// <summary>Logs an error once per material.</summary>
        internal void ErrorOnce(string message)
        {
            if (m_Warned.Add(message))
                Debug.LogError($"Material '{NameForMessages}' with shader '{m_Shader.NameForMessages}': {message}");
        }

        string MainColorName => MainName(ShaderPropertyFlags.MainColor, "_Color");

        string MainTextureName => MainName(ShaderPropertyFlags.MainTexture, "_MainTex");

        string MainName(ShaderPropertyFlags flag, string otherwise) => m_Shader.File.Properties.FirstOrDefault(p => (p.Flags & flag) != 0)?.Name ?? otherwise;

        /// <summary>What was not set has the value that the shader's file gives it.</summary>
        void AddDefaults()
        {
            foreach (var property in m_Shader.File.Properties)
            {
                if (property.Type == ShaderPropertyType.Texture)
                {
                    AddDefault(property.Name + "_ST", new Vector4(1, 1, 0, 0));
                    continue;
                }
                if (m_Values.HasNumber(property.NameId))
                    continue;
                if (property.Type == ShaderPropertyType.Color)
                    m_Values.SetColor(property.NameId, property.Default);
                else if (property.Type == ShaderPropertyType.Vector)
                    m_Values.Set(property.NameId, property.Default, NumberKind.Float);
                else if (property.Type == ShaderPropertyType.Int)
                    m_Values.Set(property.NameId, (int)property.Default.x, NumberKind.Int);
                else
                    m_Values.Set(property.NameId, property.Default.x, NumberKind.Float);
            }
        }

        void AddDefault(string name, Vector4 value)
        {
            var id = Shader.PropertyToID(name);
            if (!m_Values.HasNumber(id))
                m_Values.Set(id, value, NumberKind.Float);
        }
    }
}
