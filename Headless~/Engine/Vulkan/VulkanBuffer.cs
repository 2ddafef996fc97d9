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
        ulong m_WordView;

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

        /// <summary>A view of all of it as texels of 32 bits.</summary>
        /// <exception cref="VulkanException">The device has no views as large.</exception>
        internal ulong WordView
        {
            get
            {
                if (m_WordView != 0)
                    return m_WordView;
                var most = m_Device.Properties.limits.maxTexelBufferElements;
                if (Size / sizeof(uint) > most)
                    throw new VulkanException($"A buffer of {Size:N0} bytes cannot be read as texels on {m_Device.Name}, which has views of {most:N0} of 4 bytes.");
                var info = new VkBufferViewCreateInfo
                {
                    sType = Vk.VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO,
                    buffer = Handle,
                    format = Vk.VK_FORMAT_R32_UINT,
                    range = Vk.VK_WHOLE_SIZE,
                };
                ulong view;
                VulkanException.Check(m_Device.Api.vkCreateBufferView(m_Device.Handle, &info, null, &view), "vkCreateBufferView");
                return m_WordView = view;
            }
        }

        public void Dispose()
        {
            if (m_WordView != 0)
                m_Device.Api.vkDestroyBufferView(m_Device.Handle, m_WordView, null);
            m_WordView = 0;
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
