using System;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed partial class ComputeShader
    {
        public void SetTexture(int kernelIndex, string name, Texture texture) => SetTexture(kernelIndex, Shader.PropertyToID(name), texture, 0);

        public void SetTexture(int kernelIndex, int nameID, Texture texture) => SetTexture(kernelIndex, nameID, texture, 0);

        public void SetTexture(int kernelIndex, string name, Texture texture, int mipLevel) =>
            SetTexture(kernelIndex, Shader.PropertyToID(name), texture, mipLevel);

        /// <param name="kernelIndex">The kernel.</param>
        /// <param name="nameID">The property.</param>
        /// <param name="texture">The texture; it must live until the last dispatch.</param>
        /// <param name="mipLevel">The level that a RWTexture writes; textures that are read have all levels.</param>
        /// <exception cref="ArgumentNullException">No texture, or a destroyed one.</exception>
        /// <exception cref="IndexOutOfRangeException">There is no such kernel.</exception>
        public void SetTexture(int kernelIndex, int nameID, Texture texture, int mipLevel)
        {
            Use("SetTexture");
            if (texture == null)
                throw new ArgumentNullException(nameof(texture));
            ThrowUnlessValid(kernelIndex);
            WarnIfUnknown(nameID);
            m_Resources[kernelIndex].Textures[nameID] = new TextureValue(texture, mipLevel);
        }

        public void SetTexture(int kernelIndex, string name, RenderTexture texture, int mipLevel, RenderTextureSubElement element) =>
            SetTexture(kernelIndex, Shader.PropertyToID(name), texture, mipLevel, element);

        /// <exception cref="NotSupportedException">Stencil values are not readable in this host.</exception>
        public void SetTexture(int kernelIndex, int nameID, RenderTexture texture, int mipLevel, RenderTextureSubElement element)
        {
            if (element == RenderTextureSubElement.Stencil)
                throw new NotSupportedException("This host cannot read the stencil part of render textures.");
            SetTexture(kernelIndex, nameID, texture, mipLevel);
            m_Resources[kernelIndex].Textures[nameID] = new TextureValue(texture, mipLevel, element);
        }

        public void SetTextureFromGlobal(int kernelIndex, string name, string globalTextureName) =>
            SetTextureFromGlobal(kernelIndex, Shader.PropertyToID(name), Shader.PropertyToID(globalTextureName));

        public void SetTextureFromGlobal(int kernelIndex, int nameID, int globalTextureNameID)
        {
            if (ShaderGlobals.Resources.Textures.TryGetValue(globalTextureNameID, out var value))
                SetTexture(kernelIndex, nameID, value.Texture, value.Mip);
        }

        public void SetBuffer(int kernelIndex, string name, GraphicsBuffer buffer) => SetBuffer(kernelIndex, Shader.PropertyToID(name), buffer);

        /// <exception cref="ArgumentNullException">No buffer.</exception>
        public void SetBuffer(int kernelIndex, int nameID, GraphicsBuffer buffer) => SetBuffer(kernelIndex, nameID, buffer?.Native);

        public void SetBuffer(int kernelIndex, string name, ComputeBuffer buffer) => SetBuffer(kernelIndex, Shader.PropertyToID(name), buffer);

        /// <exception cref="ArgumentNullException">No buffer.</exception>
        public void SetBuffer(int kernelIndex, int nameID, ComputeBuffer buffer) => SetBuffer(kernelIndex, nameID, buffer?.Native);

        public void SetConstantBuffer(string name, GraphicsBuffer buffer, int offset, int size) =>
            SetConstantBuffer(Shader.PropertyToID(name), buffer, offset, size);

        /// <summary>Binds bytes of a buffer as a whole cbuffer; values set by name then do not count.</summary>
        /// <exception cref="ArgumentException">The range does not fit, or is not aligned.</exception>
        public void SetConstantBuffer(int nameID, GraphicsBuffer buffer, int offset, int size) => SetConstantBuffer(nameID, buffer?.Native, offset, size);

        public void SetConstantBuffer(string name, ComputeBuffer buffer, int offset, int size) =>
            SetConstantBuffer(Shader.PropertyToID(name), buffer, offset, size);

        public void SetConstantBuffer(int nameID, ComputeBuffer buffer, int offset, int size) => SetConstantBuffer(nameID, buffer?.Native, offset, size);

        internal void SetBuffer(int kernelIndex, int nameID, GpuBuffer buffer)
        {
            Use("SetBuffer");
            if (buffer == null)
                throw new ArgumentNullException(nameof(buffer));
            if (!LogUnlessValid(kernelIndex))
                return;
            WarnIfUnknown(nameID);
            m_Resources[kernelIndex].Buffers[nameID] = buffer;
        }

        internal void SetConstantBuffer(int nameID, GpuBuffer buffer, int offset, int size)
        {
            Use("SetConstantBuffer");
            m_Values.ConstantBuffers[nameID] = ConstantBuffers.Checked(buffer, offset, size);
            WarnIfUnknown(nameID);
        }
    }
}
