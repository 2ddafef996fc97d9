using System.Runtime.InteropServices;

#pragma warning disable CS0649 // filled by the driver, or zero

namespace UnityEngine.Vulkan
{
    // Command buffers, barriers and copies. Names and layouts as in vulkan_core.h; enums are plain integers, handles nint or ulong.

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkCommandPoolCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint queueFamilyIndex;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkCommandBufferAllocateInfo
    {
        public uint sType;
        public void* pNext;
        public ulong commandPool;
        public uint level;
        public uint commandBufferCount;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkCommandBufferBeginInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public void* pInheritanceInfo;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkFenceCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkSubmitInfo
    {
        public uint sType;
        public void* pNext;
        public uint waitSemaphoreCount;
        public ulong* pWaitSemaphores;
        public uint* pWaitDstStageMask;
        public uint commandBufferCount;
        public nint* pCommandBuffers;
        public uint signalSemaphoreCount;
        public ulong* pSignalSemaphores;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkMemoryBarrier
    {
        public uint sType;
        public void* pNext;
        public uint srcAccessMask;
        public uint dstAccessMask;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkImageMemoryBarrier
    {
        public uint sType;
        public void* pNext;
        public uint srcAccessMask;
        public uint dstAccessMask;
        public uint oldLayout;
        public uint newLayout;
        public uint srcQueueFamilyIndex;
        public uint dstQueueFamilyIndex;
        public ulong image;
        public VkImageSubresourceRange subresourceRange;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkBufferMemoryBarrier
    {
        public uint sType;
        public void* pNext;
        public uint srcAccessMask;
        public uint dstAccessMask;
        public uint srcQueueFamilyIndex;
        public uint dstQueueFamilyIndex;
        public ulong buffer;
        public ulong offset;
        public ulong size;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkBufferCopy
    {
        public ulong srcOffset;
        public ulong dstOffset;
        public ulong size;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkOffset3D
    {
        public int x;
        public int y;
        public int z;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkImageSubresourceLayers
    {
        public uint aspectMask;
        public uint mipLevel;
        public uint baseArrayLayer;
        public uint layerCount;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkBufferImageCopy
    {
        public ulong bufferOffset;
        public uint bufferRowLength;
        public uint bufferImageHeight;
        public VkImageSubresourceLayers imageSubresource;
        public VkOffset3D imageOffset;
        public VkExtent3D imageExtent;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkImageCopy
    {
        public VkImageSubresourceLayers srcSubresource;
        public VkOffset3D srcOffset;
        public VkImageSubresourceLayers dstSubresource;
        public VkOffset3D dstOffset;
        public VkExtent3D extent;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkImageBlit
    {
        public VkImageSubresourceLayers srcSubresource;
        public VkOffset3D srcOffsets0;
        public VkOffset3D srcOffsets1;
        public VkImageSubresourceLayers dstSubresource;
        public VkOffset3D dstOffsets0;
        public VkOffset3D dstOffsets1;
    }

    [StructLayout(LayoutKind.Explicit)]
    unsafe struct VkClearColorValue
    {
        [FieldOffset(0)] public fixed float float32[4];
        [FieldOffset(0)] public fixed int int32[4];
        [FieldOffset(0)] public fixed uint uint32[4];
    }
}
