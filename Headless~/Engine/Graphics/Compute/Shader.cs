namespace UnityEngine
{
    /// <summary>Names of shader properties, and values that all shaders see unless they have their own.</summary>
    public sealed partial class Shader : Object
    {
        Shader()
        {
        }

        /// <summary>A number for a property's name. Any thread.</summary>
        public static int PropertyToID(string name) => ShaderGlobals.Id(name);

        public static void EnableKeyword(string keyword)
        {
            MainThread.Check("EnableKeyword");
            ShaderGlobals.Keywords.Add(keyword);
        }

        public static void DisableKeyword(string keyword)
        {
            MainThread.Check("DisableKeyword");
            ShaderGlobals.Keywords.Remove(keyword);
        }

        public static bool IsKeywordEnabled(string keyword) => ShaderGlobals.Keywords.Contains(keyword);

        public static void SetGlobalTexture(string name, Texture value) => SetGlobalTexture(PropertyToID(name), value);

        /// <summary>Sets or, with null, unsets a texture.</summary>
        public static void SetGlobalTexture(int nameID, Texture value)
        {
            MainThread.Check("SetGlobalTexture");
            if (value == null)
                ShaderGlobals.Resources.Textures.Remove(nameID);
            else
                ShaderGlobals.Resources.Textures[nameID] = new TextureValue(value, 0);
        }

        public static Texture GetGlobalTexture(string name) => GetGlobalTexture(PropertyToID(name));

        public static Texture GetGlobalTexture(int nameID) => ShaderGlobals.Resources.Textures.TryGetValue(nameID, out var value) ? value.Texture : null;

        public static void SetGlobalBuffer(string name, GraphicsBuffer value) => SetGlobalBuffer(PropertyToID(name), value);

        public static void SetGlobalBuffer(int nameID, GraphicsBuffer value) => SetGlobalBuffer(nameID, value?.Native);

        public static void SetGlobalBuffer(string name, ComputeBuffer value) => SetGlobalBuffer(PropertyToID(name), value);

        public static void SetGlobalBuffer(int nameID, ComputeBuffer value) => SetGlobalBuffer(nameID, value?.Native);

        public static void SetGlobalConstantBuffer(string name, GraphicsBuffer value, int offset, int size) =>
            SetGlobalConstantBuffer(PropertyToID(name), value, offset, size);

        public static void SetGlobalConstantBuffer(int nameID, GraphicsBuffer value, int offset, int size)
        {
            MainThread.Check("SetGlobalConstantBuffer");
            ShaderGlobals.Values.ConstantBuffers[nameID] = ConstantBuffers.Checked(value?.Native, offset, size);
        }

        internal static void SetGlobalBuffer(int nameID, GpuBuffer value)
        {
            MainThread.Check("SetGlobalBuffer");
            if (value == null)
                ShaderGlobals.Resources.Buffers.Remove(nameID);
            else
                ShaderGlobals.Resources.Buffers[nameID] = value;
        }
    }
}
