using System;
using System.Collections.Generic;

namespace UnityEngine.Vulkan
{
    /// <summary>Descriptor sets that live as long as one submission.</summary>
    sealed unsafe class DescriptorArena : IDisposable
    {
        const uint SetsPerPool = 128;

        static readonly (uint Type, uint PerSet)[] s_Kinds =
        {
            (Vk.VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, 8), (Vk.VK_DESCRIPTOR_TYPE_SAMPLER, 4), (Vk.VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, 8),
            (Vk.VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 4), (Vk.VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 12), (Vk.VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 2),
            (Vk.VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, 8),
        };

        readonly VulkanDevice m_Device;
        readonly List<ulong> m_Pools = new();
        int m_Current;

        internal DescriptorArena(VulkanDevice device) => m_Device = device;

        internal ulong Allocate(ulong layout)
        {
            for (; ; m_Current++)
            {
                var fresh = m_Current == m_Pools.Count;
                if (fresh)
                    m_Pools.Add(CreatePool());
                var info = new VkDescriptorSetAllocateInfo
                {
                    sType = Vk.VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                    descriptorPool = m_Pools[m_Current],
                    descriptorSetCount = 1,
                    pSetLayouts = &layout,
                };
                ulong set;
                var result = m_Device.Api.vkAllocateDescriptorSets(m_Device.Handle, &info, &set);
                if (result == Vk.VK_SUCCESS)
                    return set;
                if (fresh)
                    VulkanException.Check(result, "vkAllocateDescriptorSets");
            }
        }

        internal void Reset()
        {
            for (var i = 0; i < m_Pools.Count && i <= m_Current; i++)
                VulkanException.Check(m_Device.Api.vkResetDescriptorPool(m_Device.Handle, m_Pools[i], 0), "vkResetDescriptorPool");
            m_Current = 0;
        }

        public void Dispose()
        {
            foreach (var pool in m_Pools)
                m_Device.Api.vkDestroyDescriptorPool(m_Device.Handle, pool, null);
            m_Pools.Clear();
        }

        ulong CreatePool()
        {
            var sizes = stackalloc VkDescriptorPoolSize[s_Kinds.Length];
            for (var i = 0; i < s_Kinds.Length; i++)
                sizes[i] = new VkDescriptorPoolSize { type = s_Kinds[i].Type, descriptorCount = s_Kinds[i].PerSet * SetsPerPool };
            var info = new VkDescriptorPoolCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                maxSets = SetsPerPool,
                poolSizeCount = (uint)s_Kinds.Length,
                pPoolSizes = sizes,
            };
            ulong pool;
            VulkanException.Check(m_Device.Api.vkCreateDescriptorPool(m_Device.Handle, &info, null, &pool), "vkCreateDescriptorPool");
            return pool;
        }
    }
}
