using System;
using UnityEngine.Shaders;

namespace UnityEngine
{
    public sealed partial class Shader
    {
        public static void SetGlobalFloat(string name, float value) => SetGlobalFloat(PropertyToID(name), value);

        public static void SetGlobalFloat(int nameID, float value) => Set(nameID, value, NumberKind.Float);

        /// <summary>As in Unity, the value is stored as a float; see <see cref="SetGlobalInteger(int, int)"/> for an int.</summary>
        public static void SetGlobalInt(string name, int value) => SetGlobalInt(PropertyToID(name), value);

        public static void SetGlobalInt(int nameID, int value) => SetGlobalFloat(nameID, value);

        public static void SetGlobalInteger(string name, int value) => SetGlobalInteger(PropertyToID(name), value);

        public static void SetGlobalInteger(int nameID, int value) => Set(nameID, value, NumberKind.Int);

        public static void SetGlobalVector(string name, Vector4 value) => SetGlobalVector(PropertyToID(name), value);

        public static void SetGlobalVector(int nameID, Vector4 value) => Set(nameID, value, NumberKind.Float);

        public static void SetGlobalColor(string name, Color value) => SetGlobalColor(PropertyToID(name), value);

        public static void SetGlobalColor(int nameID, Color value) => Set(nameID, value, NumberKind.Float);

        public static void SetGlobalMatrix(string name, Matrix4x4 value) => SetGlobalMatrix(PropertyToID(name), value);

        public static void SetGlobalMatrix(int nameID, Matrix4x4 value) => Set(nameID, value, NumberKind.Float);

        public static void SetGlobalFloatArray(string name, float[] values) => SetGlobalFloatArray(PropertyToID(name), values);

        /// <summary>Each value takes a row of 16 bytes, as arrays in constant buffers do.</summary>
        public static void SetGlobalFloatArray(int nameID, float[] values)
        {
            if (values == null)
                throw new ArgumentNullException(nameof(values));
            var rows = new Vector4[values.Length];
            for (var i = 0; i < rows.Length; i++)
                rows[i] = new Vector4(values[i], 0, 0, 0);
            SetGlobalVectorArray(nameID, rows);
        }

        public static void SetGlobalVectorArray(string name, Vector4[] values) => SetGlobalVectorArray(PropertyToID(name), values);

        public static void SetGlobalVectorArray(int nameID, Vector4[] values) => SetArray(nameID, values);

        public static void SetGlobalMatrixArray(string name, Matrix4x4[] values) => SetGlobalMatrixArray(PropertyToID(name), values);

        public static void SetGlobalMatrixArray(int nameID, Matrix4x4[] values) => SetArray(nameID, values);

        public static float GetGlobalFloat(string name) => GetGlobalFloat(PropertyToID(name));

        public static float GetGlobalFloat(int nameID) => ShaderGlobals.Values.Get<float>(nameID);

        public static int GetGlobalInt(string name) => GetGlobalInt(PropertyToID(name));

        public static int GetGlobalInt(int nameID) => (int)GetGlobalFloat(nameID);

        public static int GetGlobalInteger(string name) => GetGlobalInteger(PropertyToID(name));

        public static int GetGlobalInteger(int nameID) => ShaderGlobals.Values.Get<int>(nameID);

        public static Vector4 GetGlobalVector(string name) => GetGlobalVector(PropertyToID(name));

        public static Vector4 GetGlobalVector(int nameID) => ShaderGlobals.Values.Get<Vector4>(nameID);

        public static Color GetGlobalColor(string name) => GetGlobalColor(PropertyToID(name));

        public static Color GetGlobalColor(int nameID) => ShaderGlobals.Values.Get<Color>(nameID);

        public static Matrix4x4 GetGlobalMatrix(string name) => GetGlobalMatrix(PropertyToID(name));

        public static Matrix4x4 GetGlobalMatrix(int nameID) => ShaderGlobals.Values.Get<Matrix4x4>(nameID);

        public static Vector4[] GetGlobalVectorArray(string name) => GetGlobalVectorArray(PropertyToID(name));

        public static Vector4[] GetGlobalVectorArray(int nameID) => ShaderGlobals.Values.GetArray<Vector4>(nameID);

        static void Set<T>(int nameID, T value, NumberKind number) where T : unmanaged
        {
            MainThread.Check("Shader.SetGlobal");
            ShaderGlobals.Values.Set(nameID, value, number);
        }

        static void SetArray<T>(int nameID, T[] values) where T : unmanaged
        {
            MainThread.Check("Shader.SetGlobal");
            if (values == null)
                throw new ArgumentNullException(nameof(values));
            if (values.Length == 0)
                throw new ArgumentException("Zero-sized array is not allowed.");
            ShaderGlobals.Values.Set(nameID, new ReadOnlySpan<T>(values), NumberKind.Float);
        }
    }
}
