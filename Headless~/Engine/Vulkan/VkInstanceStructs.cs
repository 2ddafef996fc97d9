using System.Runtime.InteropServices;

#pragma warning disable CS0649 // filled by the driver, or zero

namespace UnityEngine.Vulkan
{
    // What describes an instance and its messages. Names and layouts as in vulkan_core.h; enums are plain integers, handles nint or ulong.

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkApplicationInfo
    {
        public uint sType;
        public void* pNext;
        public byte* pApplicationName;
        public uint applicationVersion;
        public byte* pEngineName;
        public uint engineVersion;
        public uint apiVersion;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkInstanceCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public VkApplicationInfo* pApplicationInfo;
        public uint enabledLayerCount;
        public byte** ppEnabledLayerNames;
        public uint enabledExtensionCount;
        public byte** ppEnabledExtensionNames;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkLayerProperties
    {
        public fixed byte layerName[256];
        public uint specVersion;
        public uint implementationVersion;
        public fixed byte description[256];
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkExtensionProperties
    {
        public fixed byte extensionName[256];
        public uint specVersion;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkDebugUtilsMessengerCreateInfoEXT
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint messageSeverity;
        public uint messageType;
        public nint pfnUserCallback;
        public void* pUserData;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkDebugUtilsMessengerCallbackDataEXT
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public byte* pMessageIdName;
        public int messageIdNumber;
        public byte* pMessage;
        public uint queueLabelCount;
        public void* pQueueLabels;
        public uint cmdBufLabelCount;
        public void* pCmdBufLabels;
        public uint objectCount;
        public VkDebugUtilsObjectNameInfoEXT* pObjects;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkDebugUtilsObjectNameInfoEXT
    {
        public uint sType;
        public void* pNext;
        public uint objectType;
        public ulong objectHandle;
        public byte* pObjectName;
    }
}
