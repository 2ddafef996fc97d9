using System;
using System.Collections.Generic;

namespace UnityEngine.Vulkan
{
    /// <summary>One command buffer with its fence, and what must stay alive until the device has run it.</summary>
    sealed unsafe class Submission : IDisposable
    {
        readonly VulkanDevice m_Device;
        readonly ulong m_Pool;
        readonly ulong m_Fence;

        internal Submission(VulkanDevice device)
        {
            m_Device = device;
            Descriptors = new DescriptorArena(device);
            var poolInfo = new VkCommandPoolCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                flags = Vk.VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
                queueFamilyIndex = device.QueueFamily,
            };
            ulong pool;
            VulkanException.Check(device.Api.vkCreateCommandPool(device.Handle, &poolInfo, null, &pool), "vkCreateCommandPool");
            m_Pool = pool;
            var allocateInfo = new VkCommandBufferAllocateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                commandPool = pool,
                level = Vk.VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                commandBufferCount = 1,
            };
            nint commands;
            VulkanException.Check(device.Api.vkAllocateCommandBuffers(device.Handle, &allocateInfo, &commands), "vkAllocateCommandBuffers");
            Commands = commands;
            var fenceInfo = new VkFenceCreateInfo { sType = Vk.VK_STRUCTURE_TYPE_FENCE_CREATE_INFO };
            ulong fence;
            VulkanException.Check(device.Api.vkCreateFence(device.Handle, &fenceInfo, null, &fence), "vkCreateFence");
            m_Fence = fence;
        }

        internal nint Commands { get; }

        internal ulong Serial { get; private set; }

        internal DescriptorArena Descriptors { get; }

        internal List<VulkanBuffer> StagingChunks { get; } = new();

        internal List<VulkanBuffer> UniformChunks { get; } = new();

        /// <summary>Resources to free when this has run.</summary>
        internal List<IDisposable> Garbage { get; } = new();

        internal void Begin(ulong serial)
        {
            Serial = serial;
            var info = new VkCommandBufferBeginInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                flags = Vk.VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT,
            };
            VulkanException.Check(m_Device.Api.vkBeginCommandBuffer(Commands, &info), "vkBeginCommandBuffer");
        }

        internal void Submit()
        {
            VulkanException.Check(m_Device.Api.vkEndCommandBuffer(Commands), "vkEndCommandBuffer");
            var commands = Commands;
            var info = new VkSubmitInfo { sType = Vk.VK_STRUCTURE_TYPE_SUBMIT_INFO, commandBufferCount = 1, pCommandBuffers = &commands };
            VulkanException.Check(m_Device.Api.vkQueueSubmit(m_Device.Queue, 1, &info, m_Fence), "vkQueueSubmit");
        }

        internal bool IsDone()
        {
            var result = m_Device.Api.vkGetFenceStatus(m_Device.Handle, m_Fence);
            if (result == Vk.VK_NOT_READY)
                return false;
            VulkanException.Check(result, "vkGetFenceStatus");
            return true;
        }

        internal void Wait()
        {
            var fence = m_Fence;
            VulkanException.Check(m_Device.Api.vkWaitForFences(m_Device.Handle, 1, &fence, 1, ulong.MaxValue), "vkWaitForFences");
        }

        /// <summary>Makes it ready to record again; the garbage is freed.</summary>
        internal void Recycle()
        {
            var fence = m_Fence;
            VulkanException.Check(m_Device.Api.vkResetFences(m_Device.Handle, 1, &fence), "vkResetFences");
            VulkanException.Check(m_Device.Api.vkResetCommandPool(m_Device.Handle, m_Pool, 0), "vkResetCommandPool");
            Descriptors.Reset();
            FreeGarbage();
        }

        public void Dispose()
        {
            FreeGarbage();
            Descriptors.Dispose();
            m_Device.Api.vkDestroyFence(m_Device.Handle, m_Fence, null);
            m_Device.Api.vkDestroyCommandPool(m_Device.Handle, m_Pool, null);
        }

        void FreeGarbage()
        {
            foreach (var item in Garbage)
                item.Dispose();
            Garbage.Clear();
        }
    }
}
