using System;

namespace UnityEngine.Vulkan
{
    /// <summary>Where a buffer's memory should be.</summary>
    enum BufferPlace
    {
        /// <summary>On the device; also mapped where the device's memory is the host's.</summary>
        Device,

        /// <summary>Mapped, written by the host.</summary>
        Upload,

        /// <summary>Mapped and cached, read by the host.</summary>
        Readback,
    }

    /// <summary>A buffer with memory of its own.</summary>
    sealed unsafe class VulkanBuffer : VulkanResource, IDisposable
    {
        readonly VulkanDevice m_Device;
        ulong m_Memory;

        internal VulkanBuffer(VulkanDevice device, ulong size, uint usage, BufferPlace place)
        {
            m_Device = device;
            Size = size;
            var info = new VkBufferCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                size = size,
                usage = usage,
                sharingMode = Vk.VK_SHARING_MODE_EXCLUSIVE,
            };
            ulong handle;
            VulkanException.Check(device.Api.vkCreateBuffer(device.Handle, &info, null, &handle), "vkCreateBuffer");
            Handle = handle;
            try
            {
                AllocateMemory(place);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        internal ulong Handle { get; private set; }

        internal ulong Size { get; }

        /// <summary>The bytes in the host's address space, or null.</summary>
        internal byte* Mapped { get; private set; }

        public void Dispose()
        {
            if (Handle != 0)
                m_Device.Api.vkDestroyBuffer(m_Device.Handle, Handle, null);
            if (m_Memory != 0)
                m_Device.Api.vkFreeMemory(m_Device.Handle, m_Memory, null);
            Handle = 0;
            m_Memory = 0;
            Mapped = null;
        }

        void AllocateMemory(BufferPlace place)
        {
            const uint host = Vk.VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | Vk.VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
            var (required, preferred) = place switch
            {
                BufferPlace.Upload => (host, 0u),
                BufferPlace.Readback => (host, Vk.VK_MEMORY_PROPERTY_HOST_CACHED_BIT),
                _ => (Vk.VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0u),
            };
            VkMemoryRequirements needs;
            m_Device.Api.vkGetBufferMemoryRequirements(m_Device.Handle, Handle, &needs);
            m_Memory = m_Device.Allocate(needs, required, preferred, out var properties);
            VulkanException.Check(m_Device.Api.vkBindBufferMemory(m_Device.Handle, Handle, m_Memory, 0), "vkBindBufferMemory");
            if ((properties & host) != host)
                return;
            void* mapped;
            VulkanException.Check(m_Device.Api.vkMapMemory(m_Device.Handle, m_Memory, 0, Vk.VK_WHOLE_SIZE, 0, &mapped), "vkMapMemory");
            Mapped = (byte*)mapped;
        }
    }
}
