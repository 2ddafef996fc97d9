using System.Runtime.InteropServices;

#pragma warning disable CS0649 // filled by the driver, or zero

namespace UnityEngine.Vulkan
{
    // Memory, buffers, images, views and samplers. Names and layouts as in vulkan_core.h; enums are plain integers, handles nint or ulong.

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkMemoryAllocateInfo
    {
        public uint sType;
        public void* pNext;
        public ulong allocationSize;
        public uint memoryTypeIndex;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkMemoryRequirements
    {
        public ulong size;
        public ulong alignment;
        public uint memoryTypeBits;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkBufferCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public ulong size;
        public uint usage;
        public uint sharingMode;
        public uint queueFamilyIndexCount;
        public uint* pQueueFamilyIndices;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkImageCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint imageType;
        public uint format;
        public VkExtent3D extent;
        public uint mipLevels;
        public uint arrayLayers;
        public uint samples;
        public uint tiling;
        public uint usage;
        public uint sharingMode;
        public uint queueFamilyIndexCount;
        public uint* pQueueFamilyIndices;
        public uint initialLayout;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkComponentMapping
    {
        public uint r;
        public uint g;
        public uint b;
        public uint a;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkImageSubresourceRange
    {
        public uint aspectMask;
        public uint baseMipLevel;
        public uint levelCount;
        public uint baseArrayLayer;
        public uint layerCount;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkImageViewCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public ulong image;
        public uint viewType;
        public uint format;
        public VkComponentMapping components;
        public VkImageSubresourceRange subresourceRange;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkBufferViewCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public ulong buffer;
        public uint format;
        public ulong offset;
        public ulong range;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkSamplerCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint magFilter;
        public uint minFilter;
        public uint mipmapMode;
        public uint addressModeU;
        public uint addressModeV;
        public uint addressModeW;
        public float mipLodBias;
        public uint anisotropyEnable;
        public float maxAnisotropy;
        public uint compareEnable;
        public uint compareOp;
        public float minLod;
        public float maxLod;
        public uint borderColor;
        public uint unnormalizedCoordinates;
    }
}
