using System;
using System.Collections.Generic;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Shaders;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>
    /// Finds what is set for each binding of one stage. A texture that is not set has the shader's default, or grey; one that does not fit is
    /// complained about once and replaced; a buffer that is not set makes the draw impossible.
    /// </summary>
    sealed class DrawBinder
    {
        readonly GpuContext m_Context;
        readonly DrawSource m_Source;
        readonly IReadOnlyList<KernelBinding> m_Bindings;
        readonly BindingSlot[] m_Slots;

        internal DrawBinder(GpuContext context, in DrawSource source, IReadOnlyList<KernelBinding> bindings)
        {
            m_Context = context;
            m_Source = source;
            m_Bindings = bindings;
            m_Slots = new BindingSlot[bindings.Count];
        }

        /// <summary>Finds textures, samplers and buffers; making a texture's memory may hand in work, so constants come later.</summary>
        internal bool ResolveResources()
        {
            for (var i = 0; i < m_Slots.Length; i++)
            {
                var binding = m_Bindings[i];
                switch (binding.Kind)
                {
                    case BindingKind.Texture or BindingKind.SampledTexture:
                        var value = Texture(binding);
                        m_Slots[i].Texture = value.Native;
                        m_Slots[i].Sampler = m_Context.Samplers.Get(value.Sampler);
                        break;
                    case BindingKind.Sampler:
                        m_Slots[i].Sampler = m_Context.Samplers.Get(Sampler(binding));
                        break;
                    case BindingKind.Buffer:
                        if (!Buffer(binding, ref m_Slots[i]))
                            return false;
                        break;
                }
            }
            return true;
        }

        /// <summary>Fills the constant buffers for this draw.</summary>
        internal void ResolveConstants()
        {
            for (var i = 0; i < m_Slots.Length; i++)
                if (m_Bindings[i].Kind == BindingKind.ConstantBuffer)
                    Constants(m_Bindings[i], ref m_Slots[i]);
        }

        /// <summary>The texture that is bound although it is drawn into; null if there is none.</summary>
        internal string Feedback(PassTarget target)
        {
            foreach (var slot in m_Slots)
                if (slot.Texture != null && target.Has(slot.Texture.Image))
                    return slot.Texture.Name;
            return null;
        }

        /// <summary>Writes the set and says what the draw reads.</summary>
        internal ulong Write(ulong layout, DrawPass pass)
        {
            var set = m_Context.Stream.DescriptorSet(layout);
            BindingSlot.Write(m_Context, set, m_Bindings, m_Slots);
            var serial = m_Context.Stream.CurrentSerial;
            foreach (var slot in m_Slots)
            {
                if (slot.Texture != null)
                    pass.Read(slot.Texture.Image, serial);
                if (slot.Buffer != null)
                    pass.Read(slot.Buffer, serial);
            }
            return set;
        }

        TextureValue Texture(KernelBinding binding)
        {
            if (m_Source.TryTexture(binding.NameId, out var value) && value.Texture != null)
            {
                var problem = Problem(binding, value);
                if (problem == null)
                    return value;
                m_Source.Material.ErrorOnce(problem);
                return new TextureValue(DefaultTextures.Of("", binding.Dimension, binding.Number), 0);
            }
            var property = m_Source.Material.shader.FindProperty(binding.NameId);
            if (property == null)
                m_Source.Material.WarnOnce($"texture '{binding.Name}' is neither a property of the shader nor set; grey is read instead");
            return new TextureValue(DefaultTextures.Of(property?.DefaultTexture ?? "", binding.Dimension, binding.Number), 0);
        }

        static string Problem(KernelBinding binding, in TextureValue value)
        {
            var native = value.Native;
            if (native == null)
                return $"texture '{binding.Name}': RenderTexture '{value.Texture.NameForMessages}' is not created";
            if (value.Texture.dimension != binding.Dimension)
                return $"texture '{binding.Name}' has mismatching texture dimension (expected {(int)binding.Dimension}, got "
                    + $"{(int)value.Texture.dimension})";
            if (native.Image.Samples > 1)
                return $"texture '{binding.Name}': the depth of the multisampled '{value.Texture.NameForMessages}' cannot be read";
            var number = native.Format.Kind switch { ChannelKind.UInt => NumberKind.UInt, ChannelKind.SInt => NumberKind.Int, _ => NumberKind.Float };
            return number == binding.Number ? null
                : $"texture '{binding.Name}' is of {binding.Number}, but '{value.Texture.NameForMessages}' has the format {native.Format.Format}";
        }

        SamplerState Sampler(KernelBinding binding)
        {
            const string prefix = "sampler";
            if (InlineSampler.TryParse(binding.Name, out var state))
                return state;
            if (binding.Name.StartsWith(prefix, StringComparison.Ordinal))
            {
                var texture = Shader.PropertyToID(binding.Name.Substring(prefix.Length));
                if (m_Source.TryTexture(texture, out var value) && value.Texture != null)
                    return value.Sampler;
                return DefaultTextures.Sampler;
            }
            m_Source.Material.ErrorOnce($"sampler '{binding.Name}' is neither 'sampler' with the name of a texture, nor an inline sampler (a filter and a wrap "
                + "mode)");
            return DefaultTextures.Sampler;
        }

        bool Buffer(KernelBinding binding, ref BindingSlot slot)
        {
            var material = m_Source.Material;
            if (!m_Source.TryBuffer(binding.NameId, out var buffer) || !buffer.IsAlive)
            {
                material.ErrorOnce($"requires a ComputeBuffer or GraphicsBuffer '{binding.Name}' to be bound, but none provided. Skipping draw calls to avoid "
                    + "crashing.");
                return false;
            }
            const GraphicsBuffer.Target bindable = GraphicsBuffer.Target.Structured | GraphicsBuffer.Target.Raw | GraphicsBuffer.Target.Append
                | GraphicsBuffer.Target.Counter;
            var raw = (buffer.Target & GraphicsBuffer.Target.Raw) != 0;
            if ((buffer.Target & bindable) == 0 || (!raw && buffer.Stride != binding.Stride))
            {
                material.ErrorOnce($"buffer '{binding.Name}' has the target {buffer.Target} and a stride of {buffer.Stride} bytes; the shader reads "
                    + $"{binding.Stride} bytes. Skipping draw calls.");
                return false;
            }
            slot.Buffer = buffer.Storage;
            slot.Range = Vk.VK_WHOLE_SIZE;
            return true;
        }

        unsafe void Constants(KernelBinding binding, ref BindingSlot slot)
        {
            if (m_Source.TryConstantBuffer(binding.NameId, out var bound) && bound.Buffer.IsAlive && bound.Size >= binding.Size)
            {
                slot.Buffer = bound.Buffer.Storage;
                slot.Offset = (ulong)bound.Offset;
                slot.Range = (ulong)bound.Size;
                return;
            }
            var size = Math.Max(binding.Size, 16);
            var slice = m_Context.Stream.Uniforms((ulong)size);
            DrawConstants.Write(m_Source, binding, new Span<byte>(slice.Pointer, size));
            slot.Buffer = slice.Buffer;
            slot.Offset = slice.Offset;
            slot.Range = (ulong)size;
        }
    }
}
