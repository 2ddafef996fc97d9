using System.Runtime.InteropServices;

#pragma warning disable CS0649 // filled by the driver, or zero

namespace UnityEngine.Vulkan
{
    // Descriptors and compute pipelines. Names and layouts as in vulkan_core.h; enums are plain integers, handles nint or ulong.

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkDescriptorSetLayoutBinding
    {
        public uint binding;
        public uint descriptorType;
        public uint descriptorCount;
        public uint stageFlags;
        public ulong* pImmutableSamplers;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkDescriptorSetLayoutCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint bindingCount;
        public VkDescriptorSetLayoutBinding* pBindings;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkDescriptorPoolSize
    {
        public uint type;
        public uint descriptorCount;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkDescriptorPoolCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint maxSets;
        public uint poolSizeCount;
        public VkDescriptorPoolSize* pPoolSizes;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkDescriptorSetAllocateInfo
    {
        public uint sType;
        public void* pNext;
        public ulong descriptorPool;
        public uint descriptorSetCount;
        public ulong* pSetLayouts;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkDescriptorImageInfo
    {
        public ulong sampler;
        public ulong imageView;
        public uint imageLayout;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkDescriptorBufferInfo
    {
        public ulong buffer;
        public ulong offset;
        public ulong range;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkWriteDescriptorSet
    {
        public uint sType;
        public void* pNext;
        public ulong dstSet;
        public uint dstBinding;
        public uint dstArrayElement;
        public uint descriptorCount;
        public uint descriptorType;
        public VkDescriptorImageInfo* pImageInfo;
        public VkDescriptorBufferInfo* pBufferInfo;
        public ulong* pTexelBufferView;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPipelineLayoutCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint setLayoutCount;
        public ulong* pSetLayouts;
        public uint pushConstantRangeCount;
        public VkPushConstantRange* pPushConstantRanges;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkShaderModuleCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public nuint codeSize;
        public uint* pCode;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkSpecializationInfo
    {
        public uint mapEntryCount;
        public void* pMapEntries;
        public nuint dataSize;
        public void* pData;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPipelineShaderStageCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint stage;
        public ulong module;
        public byte* pName;
        public VkSpecializationInfo* pSpecializationInfo;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkComputePipelineCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public VkPipelineShaderStageCreateInfo stage;
        public ulong layout;
        public ulong basePipelineHandle;
        public int basePipelineIndex;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPipelineCacheCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public nuint initialDataSize;
        public void* pInitialData;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPushConstantRange
    {
        public uint stageFlags;
        public uint offset;
        public uint size;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkMappedMemoryRange
    {
        public uint sType;
        public void* pNext;
        public ulong memory;
        public ulong offset;
        public ulong size;
    }
}
