using System;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Shaders;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>Finds what is set for each binding of a kernel, says what is wrong with it, and writes the descriptor set.</summary>
    sealed unsafe class KernelBinder
    {
        readonly GpuContext m_Context;
        readonly ComputeShader m_Shader;
        readonly int m_Kernel;
        readonly KernelLayout m_Layout;
        readonly BindingSlot[] m_Slots;

        internal KernelBinder(GpuContext context, ComputeShader shader, int kernel, KernelLayout layout)
        {
            m_Context = context;
            m_Shader = shader;
            m_Kernel = kernel;
            m_Layout = layout;
            m_Slots = new BindingSlot[layout.Bindings.Count];
        }

        /// <summary>Finds everything; logs the first error and answers false.</summary>
        internal bool Resolve()
        {
            // Constants come last: finding a texture may upload it and start a new submission, which constants must not outlive.
            return Resolve(constants: false) && CheckAliases() && Resolve(constants: true);
        }

        bool Resolve(bool constants)
        {
            for (var i = 0; i < m_Slots.Length; i++)
            {
                var binding = m_Layout.Bindings[i];
                if (binding.Kind == BindingKind.ConstantBuffer != constants)
                    continue;
                var error = binding.Kind switch
                {
                    BindingKind.Texture or BindingKind.RandomWriteTexture => ResolveTexture(binding, ref m_Slots[i]),
                    BindingKind.Buffer or BindingKind.RandomWriteBuffer or BindingKind.TexelBuffer => ResolveBuffer(binding, ref m_Slots[i]),
                    BindingKind.Sampler => ResolveSampler(binding, ref m_Slots[i]),
                    _ => ResolveConstants(binding, ref m_Slots[i]),
                };
                if (error == null)
                    continue;
                Debug.LogError($"Compute shader ({m_Shader.NameForMessages}): {error}");
                return false;
            }
            return true;
        }

        /// <summary>Writes the set and announces all uses to the stream.</summary>
        internal void Write(ulong set)
        {
            BindingSlot.Write(m_Context, set, m_Layout.Bindings, m_Slots);
            for (var i = 0; i < m_Slots.Length; i++)
                Announce(m_Layout.Bindings[i].Kind, m_Slots[i]);
        }

        void Announce(BindingKind kind, in BindingSlot slot)
        {
            switch (kind)
            {
                case BindingKind.Texture:
                    m_Context.Stream.Read(slot.Texture.Image, Vk.VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
                    break;
                case BindingKind.RandomWriteTexture:
                    m_Context.Stream.Write(slot.Texture.Image, Vk.VK_IMAGE_LAYOUT_GENERAL);
                    break;
                case BindingKind.Sampler:
                    break;
                case BindingKind.RandomWriteBuffer:
                    m_Context.Stream.Write(slot.Buffer);
                    break;
                default:
                    m_Context.Stream.Read(slot.Buffer);
                    break;
            }
        }

        string ResolveTexture(KernelBinding binding, ref BindingSlot slot)
        {
            if (!m_Shader.Resources(m_Kernel).Textures.TryGetValue(binding.NameId, out var value)
                && !ShaderGlobals.Resources.Textures.TryGetValue(binding.NameId, out value))
                return NotSet(binding);
            if (value.Texture == null)
                return NotSet(binding) + " (the texture was destroyed)";
            var native = value.Native;
            if (native == null)
                return NotSet(binding) + $" (RenderTexture '{value.Texture.NameForMessages}' is not created)";
            if (value.Texture.dimension != binding.Dimension)
                return $"Property ({binding.Name}) at kernel index ({m_Kernel}) has mismatching texture dimension (expected {(int)binding.Dimension}, got "
                    + $"{(int)value.Texture.dimension})";
            var number = native.Format.Kind switch { ChannelKind.UInt => NumberKind.UInt, ChannelKind.SInt => NumberKind.Int, _ => NumberKind.Float };
            if (number != binding.Number)
                return $"Property ({binding.Name}) at kernel index ({m_Kernel}) is of {binding.Number}, but texture '{value.Texture.NameForMessages}' has "
                    + $"the format {native.Format.Format}";
            if (binding.Kind == BindingKind.RandomWriteTexture)
            {
                if (!native.IsRandomWrite)
                    return $"Property ({binding.Name}) at kernel index ({m_Kernel}): Attempting to bind texture '{value.Texture.NameForMessages}' as UAV "
                        + "but the texture wasn't created with the UAV usage flag set!";
                if (binding.Reads && native.Format is not { Channels: 1, Bits: 32 })
                    return $"Property ({binding.Name}) at kernel index ({m_Kernel}) is read and written, so its texture must have one 32-bit channel, not "
                        + $"{native.Format.Format}";
                if (value.Mip < 0 || value.Mip >= native.Image.Shape.Mips)
                    return $"Property ({binding.Name}) at kernel index ({m_Kernel}): texture '{value.Texture.NameForMessages}' has no mip level {value.Mip}";
            }
            slot.Texture = native;
            slot.Mip = value.Mip;
            return null;
        }

        string ResolveBuffer(KernelBinding binding, ref BindingSlot slot)
        {
            if (!m_Shader.Resources(m_Kernel).Buffers.TryGetValue(binding.NameId, out var buffer)
                && !ShaderGlobals.Resources.Buffers.TryGetValue(binding.NameId, out buffer))
                return NotSet(binding);
            if (!buffer.IsAlive)
                return NotSet(binding) + $" (buffer '{buffer.Name}' was released)";
            if (binding.IsCounter && buffer.Counter == null)
                return $"Property ({binding.Name}) at kernel index ({m_Kernel}) counts, but buffer '{buffer.Name}' was not made with the target Append or "
                    + "Counter";
            var raw = (buffer.Target & GraphicsBuffer.Target.Raw) != 0;
            var structured = (buffer.Target & (GraphicsBuffer.Target.Structured | GraphicsBuffer.Target.Append | GraphicsBuffer.Target.Counter)) != 0;
            if (!raw && !structured)
                return $"Property ({binding.Name}) at kernel index ({m_Kernel}): buffer '{buffer.Name}' has the target {buffer.Target}, which kernels "
                    + "cannot bind";
            if (!binding.IsCounter && !raw && buffer.Stride != binding.Stride)
                return $"Property ({binding.Name}) at kernel index ({m_Kernel}): the stride of the shader's struct is {binding.Stride} bytes, that of "
                    + $"buffer '{buffer.Name}' {buffer.Stride}";
            slot.Buffer = binding.IsCounter ? buffer.Counter : buffer.Storage;
            slot.Range = Vk.VK_WHOLE_SIZE;
            return null;
        }

        string ResolveSampler(KernelBinding binding, ref BindingSlot slot)
        {
            const string prefix = "sampler";
            if (!InlineSampler.TryParse(binding.Name, out var state))
            {
                var texture = binding.Name.StartsWith(prefix, StringComparison.Ordinal) ? Shader.PropertyToID(binding.Name.Substring(prefix.Length)) : 0;
                if (!m_Shader.Resources(m_Kernel).Textures.TryGetValue(texture, out var value)
                    && !ShaderGlobals.Resources.Textures.TryGetValue(texture, out value))
                    return $"Sampler '{binding.Name}' at kernel index ({m_Kernel}) is neither 'sampler' with the name of a texture that is set, nor an "
                        + "inline sampler (a filter and a wrap mode)";
                if (value.Texture == null)
                    return NotSet(binding) + " (the texture was destroyed)";
                state = value.Sampler;
            }
            slot.Sampler = m_Context.Samplers.Get(state);
            return null;
        }

        string ResolveConstants(KernelBinding binding, ref BindingSlot slot)
        {
            if (m_Shader.Values.ConstantBuffers.TryGetValue(binding.NameId, out var bound)
                || ShaderGlobals.Values.ConstantBuffers.TryGetValue(binding.NameId, out bound))
            {
                if (!bound.Buffer.IsAlive)
                    return NotSet(binding) + " (the constant buffer was released)";
                if (bound.Size < binding.Size)
                    return $"Constant buffer ({binding.Name}) at kernel index ({m_Kernel}) needs {binding.Size} bytes, {bound.Size} are bound";
                slot.Buffer = bound.Buffer.Storage;
                slot.Offset = (ulong)bound.Offset;
                slot.Range = (ulong)bound.Size;
                return null;
            }
            var slice = m_Context.Stream.Uniforms((ulong)Math.Max(binding.Size, 16));
            ConstantWriter.Write(m_Shader, binding, new Span<byte>(slice.Pointer, binding.Size));
            slot.Buffer = slice.Buffer;
            slot.Offset = slice.Offset;
            slot.Range = (ulong)Math.Max(binding.Size, 16);
            return null;
        }

        // Direct3D silently unbinds a texture that is read while it is written, and layouts could not fit both either.
        bool CheckAliases()
        {
            for (var i = 0; i < m_Slots.Length; i++)
            {
                if (m_Layout.Bindings[i].Kind != BindingKind.RandomWriteTexture)
                    continue;
                for (var j = 0; j < m_Slots.Length; j++)
                {
                    if (m_Layout.Bindings[j].Kind != BindingKind.Texture || m_Slots[j].Texture != m_Slots[i].Texture)
                        continue;
                    Debug.LogError($"Compute shader ({m_Shader.NameForMessages}): texture '{m_Slots[i].Texture.Name}' is bound at kernel index "
                        + $"({m_Kernel}) both for reading ({m_Layout.Bindings[j].Name}) and for writing ({m_Layout.Bindings[i].Name})");
                    return false;
                }
            }
            return true;
        }

        string NotSet(KernelBinding binding) => $"Property ({binding.Name}) at kernel index ({m_Kernel}) is not set";
    }
}
