using System;
using System.Collections.Generic;
using UnityEngine.Rendering;
using UnityEngine.Shaders;

namespace UnityEngine
{
    public partial class Material
    {
        public void SetFloat(string name, float value) => SetFloat(Shader.PropertyToID(name), value);

        public void SetFloat(int nameID, float value) => Set(nameID, value, NumberKind.Float);

        /// <summary>As in Unity, the value is stored as a float; see <see cref="SetInteger(int, int)"/> for an int.</summary>
        public void SetInt(string name, int value) => SetInt(Shader.PropertyToID(name), value);

        public void SetInt(int nameID, int value) => SetFloat(nameID, value);

        public void SetInteger(string name, int value) => SetInteger(Shader.PropertyToID(name), value);

        public void SetInteger(int nameID, int value) => Set(nameID, value, NumberKind.Int);

        public void SetColor(string name, Color value) => SetColor(Shader.PropertyToID(name), value);

        /// <summary>The shader sees the colour in the project's colour space.</summary>
        public void SetColor(int nameID, Color value)
        {
            Use("SetColor");
            WarnIfUnknown(nameID);
            m_Values.SetColor(nameID, value);
        }

        public void SetVector(string name, Vector4 value) => SetVector(Shader.PropertyToID(name), value);

        public void SetVector(int nameID, Vector4 value) => Set(nameID, value, NumberKind.Float);

        public void SetMatrix(string name, Matrix4x4 value) => SetMatrix(Shader.PropertyToID(name), value);

        /// <summary>mul(M, v) in the shader is M * v here.</summary>
        public void SetMatrix(int nameID, Matrix4x4 value) => Set(nameID, value, NumberKind.Float);

        public void SetFloatArray(string name, float[] values) => SetFloatArray(Shader.PropertyToID(name), values);

        public void SetFloatArray(int nameID, float[] values)
        {
            Use("SetFloatArray");
            WarnIfUnknown(nameID);
            m_Values.SetFloats(nameID, values);
        }

        public void SetFloatArray(string name, List<float> values) => SetFloatArray(name, values?.ToArray());

        public void SetFloatArray(int nameID, List<float> values) => SetFloatArray(nameID, values?.ToArray());

        public void SetVectorArray(string name, Vector4[] values) => SetVectorArray(Shader.PropertyToID(name), values);

        public void SetVectorArray(int nameID, Vector4[] values) => SetArray(nameID, values);

        public void SetVectorArray(string name, List<Vector4> values) => SetVectorArray(name, values?.ToArray());

        public void SetVectorArray(int nameID, List<Vector4> values) => SetVectorArray(nameID, values?.ToArray());

        public void SetColorArray(string name, Color[] values) => SetColorArray(Shader.PropertyToID(name), values);

        /// <summary>Arrays of colours are handed on as they are.</summary>
        public void SetColorArray(int nameID, Color[] values) =>
            SetArray(nameID, Array.ConvertAll(values ?? throw new ArgumentNullException(nameof(values)), c => (Vector4)c));

        public void SetMatrixArray(string name, Matrix4x4[] values) => SetMatrixArray(Shader.PropertyToID(name), values);

        public void SetMatrixArray(int nameID, Matrix4x4[] values) => SetArray(nameID, values);

        public void SetMatrixArray(string name, List<Matrix4x4> values) => SetMatrixArray(name, values?.ToArray());

        public void SetMatrixArray(int nameID, List<Matrix4x4> values) => SetMatrixArray(nameID, values?.ToArray());

        public float GetFloat(string name) => GetFloat(Shader.PropertyToID(name));

        public float GetFloat(int nameID) => Has(nameID, "float") ? m_Values.Numbers.Get<float>(nameID) : 0f;

        public int GetInt(string name) => GetInt(Shader.PropertyToID(name));

        public int GetInt(int nameID) => (int)GetFloat(nameID);

        public int GetInteger(string name) => GetInteger(Shader.PropertyToID(name));

        public int GetInteger(int nameID) => Has(nameID, "integer") ? m_Values.Numbers.Get<int>(nameID) : 0;

        public Color GetColor(string name) => GetColor(Shader.PropertyToID(name));

        public Color GetColor(int nameID) => Has(nameID, "color") ? m_Values.GetColor(nameID) : default;

        public Vector4 GetVector(string name) => GetVector(Shader.PropertyToID(name));

        public Vector4 GetVector(int nameID) => Has(nameID, "vector") ? m_Values.GetVector(nameID) : default;

        public Matrix4x4 GetMatrix(string name) => GetMatrix(Shader.PropertyToID(name));

        public Matrix4x4 GetMatrix(int nameID) => Has(nameID, "matrix") ? m_Values.Numbers.Get<Matrix4x4>(nameID) : Matrix4x4.identity;

        public float[] GetFloatArray(string name) => GetFloatArray(Shader.PropertyToID(name));

        public float[] GetFloatArray(int nameID) => m_Values.GetFloats(nameID);

        public Vector4[] GetVectorArray(string name) => GetVectorArray(Shader.PropertyToID(name));

        public Vector4[] GetVectorArray(int nameID) => m_Values.Numbers.GetArray<Vector4>(nameID);

        public Matrix4x4[] GetMatrixArray(string name) => GetMatrixArray(Shader.PropertyToID(name));

        public Matrix4x4[] GetMatrixArray(int nameID) => m_Values.Numbers.GetArray<Matrix4x4>(nameID);

        /// <summary>Whether the shader declares such a property, or a value was set.</summary>
        public bool HasProperty(string name) => HasProperty(Shader.PropertyToID(name));

        public bool HasProperty(int nameID)
        {
            Use("HasProperty");
            return Declares(nameID) || m_Values.HasNumber(nameID) || m_Values.Resources.Textures.ContainsKey(nameID);
        }

        public bool HasFloat(string name) => HasFloat(Shader.PropertyToID(name));

        public bool HasFloat(int nameID) => HasOf(nameID, 4, ShaderPropertyType.Float, ShaderPropertyType.Range);

        public bool HasInt(string name) => HasFloat(name);

        public bool HasInt(int nameID) => HasFloat(nameID);

        public bool HasInteger(string name) => HasInteger(Shader.PropertyToID(name));

        public bool HasInteger(int nameID) => HasOf(nameID, 0, ShaderPropertyType.Int);

        public bool HasColor(string name) => HasColor(Shader.PropertyToID(name));

        public bool HasColor(int nameID) => HasOf(nameID, 0, ShaderPropertyType.Color) || m_Values.HasColor(nameID);

        public bool HasVector(string name) => HasVector(Shader.PropertyToID(name));

        public bool HasVector(int nameID) => HasOf(nameID, 16, ShaderPropertyType.Vector, ShaderPropertyType.Color);

        public bool HasMatrix(string name) => HasMatrix(Shader.PropertyToID(name));

        public bool HasMatrix(int nameID) => HasOf(nameID, 64);

        public bool HasTexture(string name) => HasTexture(Shader.PropertyToID(name));

        public bool HasTexture(int nameID) => HasOf(nameID, 0, ShaderPropertyType.Texture) || m_Values.Resources.Textures.ContainsKey(nameID);

        void Set<T>(int nameID, T value, NumberKind number) where T : unmanaged
        {
            Use("Set value");
            WarnIfUnknown(nameID);
            m_Values.Set(nameID, value, number);
        }

        void SetArray<T>(int nameID, T[] values) where T : unmanaged
        {
            Use("Set array");
            if (values == null)
                throw new ArgumentNullException(nameof(values));
            WarnIfUnknown(nameID);
            m_Values.Set(nameID, new ReadOnlySpan<T>(values));
        }

        bool Declares(int nameID) => m_Shader.FindProperty(nameID) != null;

        bool HasOf(int nameID, int bytes, params ShaderPropertyType[] types)
        {
            Use("Has");
            if (m_Shader.FindProperty(nameID) is { } property)
                return Array.IndexOf(types, property.Type) >= 0;
            return bytes > 0 && m_Values.Numbers.TryGet(nameID, out var value) && value.Bytes.Length == bytes;
        }

        /// <summary>False, with Unity's error in the log, for what the material does not have.</summary>
        bool Has(int nameID, string kind)
        {
            Use("Get value");
            if (m_Values.HasNumber(nameID))
                return true;
            if (!Declares(nameID))
                Debug.LogError($"Material '{NameForMessages}' with Shader '{m_Shader.NameForMessages}' doesn't have a {kind} property "
                    + $"'{ShaderGlobals.Name(nameID) ?? nameID.ToString(System.Globalization.CultureInfo.InvariantCulture)}'");
            return false;
        }

        void WarnIfUnknown(int nameID)
        {
            if (!GpuOptions.Strict || Declares(nameID) || Passes.Count == 0)
                return;
            var name = ShaderGlobals.Name(nameID);
            if (name == null)
                WarnOnce($"there is no property with ID {nameID}; Unity ignores that silently");
            else if (!Mentions(name))
                WarnOnce($"it has no property '{name}'; Unity ignores that silently");
        }

        bool Mentions(string name)
        {
            foreach (var pass in Passes)
                if (pass.Source == null || pass.Source.Mentions(name))
                    return true;
            return false;
        }
    }
}
