using System;
using UnityEngine.Shaders;

namespace UnityEngine
{
    public sealed partial class ComputeShader
    {
        public void SetFloat(string name, float val) => SetFloat(Shader.PropertyToID(name), val);

        public void SetFloat(int nameID, float val) => Set(nameID, val, NumberKind.Float);

        public void SetInt(string name, int val) => SetInt(Shader.PropertyToID(name), val);

        public void SetInt(int nameID, int val) => Set(nameID, val, NumberKind.Int);

        public void SetBool(string name, bool val) => SetBool(Shader.PropertyToID(name), val);

        /// <summary>Sets an int to 0 or 1.</summary>
        public void SetBool(int nameID, bool val) => SetInt(nameID, val ? 1 : 0);

        public void SetVector(string name, Vector4 val) => SetVector(Shader.PropertyToID(name), val);

        public void SetVector(int nameID, Vector4 val) => Set(nameID, val, NumberKind.Float);

        public void SetMatrix(string name, Matrix4x4 val) => SetMatrix(Shader.PropertyToID(name), val);

        /// <summary>mul(M, v) in the shader is M * v here.</summary>
        public void SetMatrix(int nameID, Matrix4x4 val) => Set(nameID, val, NumberKind.Float);

        public void SetFloats(string name, params float[] values) => SetFloats(Shader.PropertyToID(name), values);

        /// <summary>Raw copy: array elements start at every fourth value.</summary>
        public void SetFloats(int nameID, params float[] values) => SetArray(nameID, values, NumberKind.Float);

        public void SetInts(string name, params int[] values) => SetInts(Shader.PropertyToID(name), values);

        /// <summary>Raw copy: array elements start at every fourth value.</summary>
        public void SetInts(int nameID, params int[] values) => SetArray(nameID, values, NumberKind.Int);

        public void SetVectorArray(string name, Vector4[] values) => SetVectorArray(Shader.PropertyToID(name), values);

        public void SetVectorArray(int nameID, Vector4[] values) => SetArray(nameID, values, NumberKind.Float);

        public void SetMatrixArray(string name, Matrix4x4[] values) => SetMatrixArray(Shader.PropertyToID(name), values);

        public void SetMatrixArray(int nameID, Matrix4x4[] values) => SetArray(nameID, values, NumberKind.Float);

        void Set<T>(int name, T value, NumberKind number) where T : unmanaged
        {
            Use("Set value");
            WarnIfUnknown(name);
            m_Values.Set(name, value, number);
        }

        void SetArray<T>(int name, T[] values, NumberKind number) where T : unmanaged
        {
            Use("Set array");
            if (values == null)
                throw new ArgumentNullException(nameof(values));
            WarnIfUnknown(name);
            m_Values.Set(name, new ReadOnlySpan<T>(values), number);
        }

        void WarnIfUnknown(int id)
        {
            var name = ShaderGlobals.Name(id);
            if (name == null)
                WarnOnce($"there is no property with ID {id}; Unity ignores that silently");
            else if (!Program.Source.Mentions(name))
                WarnOnce($"it has no property '{name}'; Unity ignores that silently");
        }
    }
}
