using System.Collections.Generic;
using System.Linq;
using UnityEngine.Rendering;
using UnityEngine.Shaders;

namespace UnityEngine
{
    public partial class Material
    {
        public void SetTexture(string name, Texture value) => SetTexture(Shader.PropertyToID(name), value);

        /// <summary>Sets or, with null, unsets a texture: then the shader's default counts.</summary>
        public void SetTexture(int nameID, Texture value) => SetTexture(nameID, value, RenderTextureSubElement.Default);

        public void SetTexture(string name, RenderTexture value, RenderTextureSubElement element) => SetTexture(Shader.PropertyToID(name), value, element);

        /// <param name="nameID">The property.</param>
        /// <param name="value">The texture, or null.</param>
        /// <param name="element">Its colour or its depth.</param>
        public void SetTexture(int nameID, RenderTexture value, RenderTextureSubElement element) => SetTexture(nameID, (Texture)value, element);

        public Texture GetTexture(string name) => GetTexture(Shader.PropertyToID(name));

        public Texture GetTexture(int nameID)
        {
            Use("GetTexture");
            if (m_Values.Resources.Textures.TryGetValue(nameID, out var value))
                return value.Texture;
            if (!Declares(nameID))
                Debug.LogError($"Material '{NameForMessages}' with Shader '{m_Shader.NameForMessages}' doesn't have a texture property "
                    + $"'{ShaderGlobals.Name(nameID)}'");
            return null;
        }

        public void SetTextureOffset(string name, Vector2 value)
        {
            var st = GetScaleOffset(name);
            SetScaleOffset(name, new Vector4(st.x, st.y, value.x, value.y));
        }

        public void SetTextureOffset(int nameID, Vector2 value) => SetTextureOffset(ShaderGlobals.Name(nameID), value);

        public void SetTextureScale(string name, Vector2 value)
        {
            var st = GetScaleOffset(name);
            SetScaleOffset(name, new Vector4(value.x, value.y, st.z, st.w));
        }

        public void SetTextureScale(int nameID, Vector2 value) => SetTextureScale(ShaderGlobals.Name(nameID), value);

        public Vector2 GetTextureOffset(string name)
        {
            var st = GetScaleOffset(name);
            return new Vector2(st.z, st.w);
        }

        public Vector2 GetTextureOffset(int nameID) => GetTextureOffset(ShaderGlobals.Name(nameID));

        public Vector2 GetTextureScale(string name) => GetScaleOffset(name);

        public Vector2 GetTextureScale(int nameID) => GetTextureScale(ShaderGlobals.Name(nameID));

        public string[] GetTexturePropertyNames() =>
            m_Shader.File.Properties.Where(p => p.Type == ShaderPropertyType.Texture).Select(p => p.Name).ToArray();

        public void GetTexturePropertyNames(List<string> outNames)
        {
            outNames.Clear();
            outNames.AddRange(GetTexturePropertyNames());
        }

        public void SetBuffer(string name, GraphicsBuffer value) => SetBuffer(Shader.PropertyToID(name), value);

        public void SetBuffer(int nameID, GraphicsBuffer value) => SetBuffer(nameID, value?.Native);

        public void SetBuffer(string name, ComputeBuffer value) => SetBuffer(Shader.PropertyToID(name), value);

        public void SetBuffer(int nameID, ComputeBuffer value) => SetBuffer(nameID, value?.Native);

        public bool HasBuffer(string name) => HasBuffer(Shader.PropertyToID(name));

        public bool HasBuffer(int nameID) => m_Values.Resources.Buffers.ContainsKey(nameID);

        public void SetConstantBuffer(string name, GraphicsBuffer value, int offset, int size) =>
            SetConstantBuffer(Shader.PropertyToID(name), value, offset, size);

        /// <summary>Binds bytes of a buffer as a whole cbuffer; values set by name then do not count.</summary>
        public void SetConstantBuffer(int nameID, GraphicsBuffer value, int offset, int size) => SetConstantBuffer(nameID, value?.Native, offset, size);

        public void SetConstantBuffer(string name, ComputeBuffer value, int offset, int size) =>
            SetConstantBuffer(Shader.PropertyToID(name), value, offset, size);

        public void SetConstantBuffer(int nameID, ComputeBuffer value, int offset, int size) => SetConstantBuffer(nameID, value?.Native, offset, size);

        public bool HasConstantBuffer(string name) => HasConstantBuffer(Shader.PropertyToID(name));

        public bool HasConstantBuffer(int nameID) => m_Values.Numbers.ConstantBuffers.ContainsKey(nameID);

        void SetBuffer(int nameID, GpuBuffer value)
        {
            Use("SetBuffer");
            WarnIfUnknown(nameID);
            if (value == null)
                m_Values.Resources.Buffers.Remove(nameID);
            else
                m_Values.Resources.Buffers[nameID] = value;
        }

        void SetConstantBuffer(int nameID, GpuBuffer value, int offset, int size)
        {
            Use("SetConstantBuffer");
            WarnIfUnknown(nameID);
            if (value == null)
                m_Values.Numbers.ConstantBuffers.Remove(nameID);
            else
                m_Values.Numbers.ConstantBuffers[nameID] = ConstantBuffers.Checked(value, offset, size);
        }

        void SetTexture(int nameID, Texture value, RenderTextureSubElement element)
        {
            Use("SetTexture");
            WarnIfUnknown(nameID);
            if (value == null)
                m_Values.Resources.Textures.Remove(nameID);
            else
                m_Values.Resources.Textures[nameID] = new TextureValue(value, 0, element);
        }

        Vector4 GetScaleOffset(string name)
        {
            Use("GetTextureScaleAndOffset");
            var id = Shader.PropertyToID(name + "_ST");
            return m_Values.HasNumber(id) ? m_Values.GetVector(id) : new Vector4(1, 1, 0, 0);
        }

        void SetScaleOffset(string name, Vector4 value)
        {
            Use("SetTextureScaleAndOffset");
            m_Values.Set(Shader.PropertyToID(name + "_ST"), value, NumberKind.Float);
        }
    }
}
