using System;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>
    /// Where a draw's values come from, in the order in which they count: what the engine itself sets (object, camera), the property block, the
    /// material, the globals.
    /// </summary>
    readonly struct DrawSource
    {
        internal DrawSource(Material material, MaterialPropertyBlock block, PropertySheet draw, PropertySheet camera)
        {
            Material = material;
            Block = block?.Values;
            Draw = draw;
            Camera = camera;
        }

        internal readonly Material Material;
        internal readonly ShaderValues Block;
        internal readonly PropertySheet Draw;
        internal readonly PropertySheet Camera;

        internal bool TryNumber(int name, out ConstantValue value) =>
            Draw.TryGet(name, out value) || Camera.TryGet(name, out value) || (Block != null && Block.Numbers.TryGet(name, out value))
                || Material.Values.Numbers.TryGet(name, out value) || ShaderGlobals.Values.TryGet(name, out value);

        internal bool TryTexture(int name, out TextureValue value)
        {
            if (Block != null && Block.Resources.Textures.TryGetValue(name, out value))
                return true;
            if (Material.Values.Resources.Textures.TryGetValue(name, out value) && value.Texture != null)
                return true;
            value = default;
            // What the shader declares as a property has a default there; globals are for what it does not declare.
            return Material.shader.FindProperty(name) == null && ShaderGlobals.Resources.Textures.TryGetValue(name, out value);
        }

        internal bool TryBuffer(int name, out GpuBuffer buffer) =>
            (Block != null && Block.Resources.Buffers.TryGetValue(name, out buffer)) || Material.Values.Resources.Buffers.TryGetValue(name, out buffer)
                || ShaderGlobals.Resources.Buffers.TryGetValue(name, out buffer);

        internal bool TryConstantBuffer(int name, out ConstantBufferValue value) =>
            (Block != null && Block.Numbers.ConstantBuffers.TryGetValue(name, out value))
                || Material.Values.Numbers.ConstantBuffers.TryGetValue(name, out value) || ShaderGlobals.Values.ConstantBuffers.TryGetValue(name, out value);

        /// <summary>A property as a float, for fixed states.</summary>
        internal float Float(int name)
        {
            if (!TryNumber(name, out var value) || value.Bytes.Length < 4)
                return 0f;
            return value.Number == NumberKind.Float ? BitConverter.ToSingle(value.Bytes, 0) : BitConverter.ToInt32(value.Bytes, 0);
        }
    }
}
