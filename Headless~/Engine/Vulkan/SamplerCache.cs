using System;
using System.Collections.Generic;

namespace UnityEngine.Vulkan
{
    /// <summary>How a sampler filters and wraps.</summary>
    readonly struct SamplerState : IEquatable<SamplerState>
    {
        internal SamplerState(FilterMode filter, TextureWrapMode u, TextureWrapMode v, TextureWrapMode w)
        {
            Filter = filter;
            U = u;
            V = v;
            W = w;
        }

        internal readonly FilterMode Filter;
        internal readonly TextureWrapMode U;
        internal readonly TextureWrapMode V;
        internal readonly TextureWrapMode W;

        public bool Equals(SamplerState other) => Filter == other.Filter && U == other.U && V == other.V && W == other.W;

        public override bool Equals(object obj) => obj is SamplerState other && Equals(other);

        public override int GetHashCode() => ((int)Filter << 12) | ((int)U << 8) | ((int)V << 4) | (int)W;
    }

    /// <summary>One Vulkan sampler per kind of sampling.</summary>
    sealed unsafe class SamplerCache : IDisposable
    {
        const float AllMips = 1000f;

        readonly VulkanDevice m_Device;
        readonly Dictionary<SamplerState, ulong> m_Samplers = new();

        internal SamplerCache(VulkanDevice device) => m_Device = device;

        internal ulong Get(in SamplerState state)
        {
            if (m_Samplers.TryGetValue(state, out var sampler))
                return sampler;
            var filter = state.Filter == FilterMode.Point ? Vk.VK_FILTER_NEAREST : Vk.VK_FILTER_LINEAR;
            var info = new VkSamplerCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                magFilter = filter,
                minFilter = filter,
                mipmapMode = state.Filter == FilterMode.Trilinear ? Vk.VK_SAMPLER_MIPMAP_MODE_LINEAR : Vk.VK_SAMPLER_MIPMAP_MODE_NEAREST,
                addressModeU = Address(state.U),
                addressModeV = Address(state.V),
                addressModeW = Address(state.W),
                maxLod = AllMips,
            };
            VulkanException.Check(m_Device.Api.vkCreateSampler(m_Device.Handle, &info, null, &sampler), "vkCreateSampler");
            m_Samplers.Add(state, sampler);
            return sampler;
        }

        public void Dispose()
        {
            foreach (var sampler in m_Samplers.Values)
                m_Device.Api.vkDestroySampler(m_Device.Handle, sampler, null);
            m_Samplers.Clear();
        }

        static uint Address(TextureWrapMode mode) => mode switch
        {
            TextureWrapMode.Clamp => Vk.VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
            TextureWrapMode.Mirror => Vk.VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT,
            TextureWrapMode.MirrorOnce => throw new NotSupportedException("The wrap mode MirrorOnce needs a Vulkan extension that this host does not ask for."),
            _ => Vk.VK_SAMPLER_ADDRESS_MODE_REPEAT,
        };
    }
}
