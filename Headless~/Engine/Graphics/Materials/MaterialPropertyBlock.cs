using System;
using System.Collections.Generic;
using UnityEngine.Rendering;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>Values for one draw or one renderer, which come before the material's. It is copied where it is handed over.</summary>
    public sealed class MaterialPropertyBlock
    {
        internal ShaderValues Values { get; } = new();

        public bool isEmpty => Values.IsEmpty;

        public void Clear() => Values.Clear();

        public void SetFloat(string name, float value) => SetFloat(Shader.PropertyToID(name), value);

        public void SetFloat(int nameID, float value) => Values.Set(nameID, value, NumberKind.Float);

        /// <summary>As in Unity, the value is stored as a float.</summary>
        public void SetInt(string name, int value) => SetInt(Shader.PropertyToID(name), value);

        public void SetInt(int nameID, int value) => SetFloat(nameID, value);

        public void SetInteger(string name, int value) => SetInteger(Shader.PropertyToID(name), value);

        public void SetInteger(int nameID, int value) => Values.Set(nameID, value, NumberKind.Int);

        public void SetColor(string name, Color value) => SetColor(Shader.PropertyToID(name), value);

        public void SetColor(int nameID, Color value) => Values.SetColor(nameID, value);

        public void SetVector(string name, Vector4 value) => SetVector(Shader.PropertyToID(name), value);

        public void SetVector(int nameID, Vector4 value) => Values.Set(nameID, value, NumberKind.Float);

        public void SetMatrix(string name, Matrix4x4 value) => SetMatrix(Shader.PropertyToID(name), value);

        public void SetMatrix(int nameID, Matrix4x4 value) => Values.Set(nameID, value, NumberKind.Float);

        public void SetFloatArray(string name, float[] values) => SetFloatArray(Shader.PropertyToID(name), values);

        public void SetFloatArray(int nameID, float[] values) => Values.SetFloats(nameID, values);

        public void SetFloatArray(string name, List<float> values) => SetFloatArray(Shader.PropertyToID(name), values);

        public void SetFloatArray(int nameID, List<float> values) => Values.SetFloats(nameID, values);

        public void SetVectorArray(string name, Vector4[] values) => SetVectorArray(Shader.PropertyToID(name), values);

        public void SetVectorArray(int nameID, Vector4[] values) =>
            Values.Set(nameID, new ReadOnlySpan<Vector4>(values ?? throw new ArgumentNullException(nameof(values))));

        public void SetVectorArray(string name, List<Vector4> values) => SetVectorArray(name, values?.ToArray());

        public void SetVectorArray(int nameID, List<Vector4> values) => SetVectorArray(nameID, values?.ToArray());

        public void SetMatrixArray(string name, Matrix4x4[] values) => SetMatrixArray(Shader.PropertyToID(name), values);

        public void SetMatrixArray(int nameID, Matrix4x4[] values) =>
            Values.Set(nameID, new ReadOnlySpan<Matrix4x4>(values ?? throw new ArgumentNullException(nameof(values))));

        public void SetMatrixArray(string name, List<Matrix4x4> values) => SetMatrixArray(name, values?.ToArray());

        public void SetMatrixArray(int nameID, List<Matrix4x4> values) => SetMatrixArray(nameID, values?.ToArray());

        public void SetTexture(string name, Texture value) => SetTexture(Shader.PropertyToID(name), value);

        /// <exception cref="ArgumentNullException">No texture: a block cannot unset one.</exception>
        public void SetTexture(int nameID, Texture value) => SetTexture(nameID, value, RenderTextureSubElement.Default);

        public void SetTexture(string name, RenderTexture value, RenderTextureSubElement element) => SetTexture(Shader.PropertyToID(name), value, element);

        public void SetTexture(int nameID, RenderTexture value, RenderTextureSubElement element) => SetTexture(nameID, (Texture)value, element);

        public void SetBuffer(string name, GraphicsBuffer value) => SetBuffer(Shader.PropertyToID(name), value);

        public void SetBuffer(int nameID, GraphicsBuffer value) =>
            Values.Resources.Buffers[nameID] = value?.Native ?? throw new ArgumentNullException(nameof(value));

        public void SetBuffer(string name, ComputeBuffer value) => SetBuffer(Shader.PropertyToID(name), value);

        public void SetBuffer(int nameID, ComputeBuffer value) =>
            Values.Resources.Buffers[nameID] = value?.Native ?? throw new ArgumentNullException(nameof(value));

        public void SetConstantBuffer(string name, GraphicsBuffer value, int offset, int size) =>
            SetConstantBuffer(Shader.PropertyToID(name), value, offset, size);

        public void SetConstantBuffer(int nameID, GraphicsBuffer value, int offset, int size) =>
            Values.Numbers.ConstantBuffers[nameID] = ConstantBuffers.Checked(value?.Native, offset, size);

        public float GetFloat(string name) => GetFloat(Shader.PropertyToID(name));

        public float GetFloat(int nameID) => Values.Numbers.Get<float>(nameID);

        public int GetInt(string name) => GetInt(Shader.PropertyToID(name));

        public int GetInt(int nameID) => (int)GetFloat(nameID);

        public int GetInteger(string name) => GetInteger(Shader.PropertyToID(name));

        public int GetInteger(int nameID) => Values.Numbers.Get<int>(nameID);

        public Color GetColor(string name) => GetColor(Shader.PropertyToID(name));

        public Color GetColor(int nameID) => Values.GetColor(nameID);

        public Vector4 GetVector(string name) => GetVector(Shader.PropertyToID(name));

        public Vector4 GetVector(int nameID) => Values.GetVector(nameID);

        public Matrix4x4 GetMatrix(string name) => GetMatrix(Shader.PropertyToID(name));

        public Matrix4x4 GetMatrix(int nameID) => Values.Numbers.Get<Matrix4x4>(nameID);

        public float[] GetFloatArray(string name) => GetFloatArray(Shader.PropertyToID(name));

        public float[] GetFloatArray(int nameID) => Values.GetFloats(nameID);

        public Vector4[] GetVectorArray(string name) => GetVectorArray(Shader.PropertyToID(name));

        public Vector4[] GetVectorArray(int nameID) => Values.Numbers.GetArray<Vector4>(nameID);

        public Texture GetTexture(string name) => GetTexture(Shader.PropertyToID(name));

        public Texture GetTexture(int nameID) => Values.Resources.Textures.TryGetValue(nameID, out var value) ? value.Texture : null;

        public bool HasProperty(string name) => HasProperty(Shader.PropertyToID(name));

        public bool HasProperty(int nameID) => Values.HasNumber(nameID) || HasTexture(nameID) || HasBuffer(nameID);

        public bool HasFloat(string name) => HasFloat(Shader.PropertyToID(name));

        public bool HasFloat(int nameID) => HasBytes(nameID, 4);

        public bool HasVector(string name) => HasVector(Shader.PropertyToID(name));

        public bool HasVector(int nameID) => HasBytes(nameID, 16);

        public bool HasColor(string name) => HasVector(name);

        public bool HasColor(int nameID) => HasVector(nameID);

        public bool HasMatrix(string name) => HasMatrix(Shader.PropertyToID(name));

        public bool HasMatrix(int nameID) => HasBytes(nameID, 64);

        public bool HasTexture(string name) => HasTexture(Shader.PropertyToID(name));

        public bool HasTexture(int nameID) => Values.Resources.Textures.ContainsKey(nameID);

        public bool HasBuffer(string name) => HasBuffer(Shader.PropertyToID(name));

        public bool HasBuffer(int nameID) => Values.Resources.Buffers.ContainsKey(nameID);

        internal MaterialPropertyBlock Copy()
        {
            var copy = new MaterialPropertyBlock();
            Values.CopyTo(copy.Values);
            return copy;
        }

        bool HasBytes(int nameID, int bytes) => Values.Numbers.TryGet(nameID, out var value) && value.Bytes.Length == bytes;

        void SetTexture(int nameID, Texture value, RenderTextureSubElement element) =>
            Values.Resources.Textures[nameID] = new TextureValue(value != null ? value : throw new ArgumentNullException(nameof(value)), 0, element);
    }
}
