using System.Runtime.InteropServices;

#pragma warning disable CS0649 // filled by the driver, or zero

namespace UnityEngine.Vulkan
{
    // What describes devices. Names and layouts as in vulkan_core.h; enums are plain integers, handles nint or ulong.

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPhysicalDeviceSparseProperties
    {
        public uint residencyStandard2DBlockShape;
        public uint residencyStandard2DMultisampleBlockShape;
        public uint residencyStandard3DBlockShape;
        public uint residencyAlignedMipSize;
        public uint residencyNonResidentStrict;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPhysicalDeviceProperties
    {
        public uint apiVersion;
        public uint driverVersion;
        public uint vendorID;
        public uint deviceID;
        public uint deviceType;
        public fixed byte deviceName[256];
        public fixed byte pipelineCacheUUID[16];
        public VkPhysicalDeviceLimits limits;
        public VkPhysicalDeviceSparseProperties sparseProperties;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkQueueFamilyProperties
    {
        public uint queueFlags;
        public uint queueCount;
        public uint timestampValidBits;
        public VkExtent3D minImageTransferGranularity;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkExtent3D
    {
        public uint width;
        public uint height;
        public uint depth;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkMemoryType
    {
        public uint propertyFlags;
        public uint heapIndex;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkMemoryHeap
    {
        public ulong size;
        public uint flags;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPhysicalDeviceMemoryProperties
    {
        public uint memoryTypeCount;
        public VkMemoryType memoryTypes0;
        public VkMemoryType memoryTypes1;
        public VkMemoryType memoryTypes2;
        public VkMemoryType memoryTypes3;
        public VkMemoryType memoryTypes4;
        public VkMemoryType memoryTypes5;
        public VkMemoryType memoryTypes6;
        public VkMemoryType memoryTypes7;
        public VkMemoryType memoryTypes8;
        public VkMemoryType memoryTypes9;
        public VkMemoryType memoryTypes10;
        public VkMemoryType memoryTypes11;
        public VkMemoryType memoryTypes12;
        public VkMemoryType memoryTypes13;
        public VkMemoryType memoryTypes14;
        public VkMemoryType memoryTypes15;
        public VkMemoryType memoryTypes16;
        public VkMemoryType memoryTypes17;
        public VkMemoryType memoryTypes18;
        public VkMemoryType memoryTypes19;
        public VkMemoryType memoryTypes20;
        public VkMemoryType memoryTypes21;
        public VkMemoryType memoryTypes22;
        public VkMemoryType memoryTypes23;
        public VkMemoryType memoryTypes24;
        public VkMemoryType memoryTypes25;
        public VkMemoryType memoryTypes26;
        public VkMemoryType memoryTypes27;
        public VkMemoryType memoryTypes28;
        public VkMemoryType memoryTypes29;
        public VkMemoryType memoryTypes30;
        public VkMemoryType memoryTypes31;
        public uint memoryHeapCount;
        public VkMemoryHeap memoryHeaps0;
        public VkMemoryHeap memoryHeaps1;
        public VkMemoryHeap memoryHeaps2;
        public VkMemoryHeap memoryHeaps3;
        public VkMemoryHeap memoryHeaps4;
        public VkMemoryHeap memoryHeaps5;
        public VkMemoryHeap memoryHeaps6;
        public VkMemoryHeap memoryHeaps7;
        public VkMemoryHeap memoryHeaps8;
        public VkMemoryHeap memoryHeaps9;
        public VkMemoryHeap memoryHeaps10;
        public VkMemoryHeap memoryHeaps11;
        public VkMemoryHeap memoryHeaps12;
        public VkMemoryHeap memoryHeaps13;
        public VkMemoryHeap memoryHeaps14;
        public VkMemoryHeap memoryHeaps15;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkFormatProperties
    {
        public uint linearTilingFeatures;
        public uint optimalTilingFeatures;
        public uint bufferFeatures;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPhysicalDeviceFeatures2
    {
        public uint sType;
        public void* pNext;
        public VkPhysicalDeviceFeatures features;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPhysicalDeviceSubgroupProperties
    {
        public uint sType;
        public void* pNext;
        public uint subgroupSize;
        public uint supportedStages;
        public uint supportedOperations;
        public uint quadOperationsInAllStages;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPhysicalDeviceProperties2
    {
        public uint sType;
        public void* pNext;
        public VkPhysicalDeviceProperties properties;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkDeviceQueueCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint queueFamilyIndex;
        public uint queueCount;
        public float* pQueuePriorities;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkDeviceCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint queueCreateInfoCount;
        public VkDeviceQueueCreateInfo* pQueueCreateInfos;
        public uint enabledLayerCount;
        public byte** ppEnabledLayerNames;
        public uint enabledExtensionCount;
        public byte** ppEnabledExtensionNames;
        public VkPhysicalDeviceFeatures* pEnabledFeatures;
    }
}
