namespace UnityEngine.Vulkan
{
    /// <summary>Functions of an instance and its physical devices.</summary>
    sealed unsafe class VkInstanceApi
    {
        public readonly delegate* unmanaged[Cdecl]<nint, void*, void> vkDestroyInstance;
        public readonly delegate* unmanaged[Cdecl]<nint, uint*, nint*, int> vkEnumeratePhysicalDevices;
        public readonly delegate* unmanaged[Cdecl]<nint, VkPhysicalDeviceProperties*, void> vkGetPhysicalDeviceProperties;
        public readonly delegate* unmanaged[Cdecl]<nint, VkPhysicalDeviceProperties2*, void> vkGetPhysicalDeviceProperties2;
        public readonly delegate* unmanaged[Cdecl]<nint, VkPhysicalDeviceFeatures*, void> vkGetPhysicalDeviceFeatures;
        public readonly delegate* unmanaged[Cdecl]<nint, VkPhysicalDeviceFeatures2*, void> vkGetPhysicalDeviceFeatures2;
        public readonly delegate* unmanaged[Cdecl]<nint, uint*, VkQueueFamilyProperties*, void> vkGetPhysicalDeviceQueueFamilyProperties;
        public readonly delegate* unmanaged[Cdecl]<nint, VkPhysicalDeviceMemoryProperties*, void> vkGetPhysicalDeviceMemoryProperties;
        public readonly delegate* unmanaged[Cdecl]<nint, uint, VkFormatProperties*, void> vkGetPhysicalDeviceFormatProperties;
        public readonly delegate* unmanaged[Cdecl]<nint, byte*, uint*, VkExtensionProperties*, int> vkEnumerateDeviceExtensionProperties;
        public readonly delegate* unmanaged[Cdecl]<nint, VkDeviceCreateInfo*, void*, nint*, int> vkCreateDevice;
        public readonly delegate* unmanaged[Cdecl]<nint, VkDebugUtilsMessengerCreateInfoEXT*, void*, ulong*, int> vkCreateDebugUtilsMessengerEXT;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroyDebugUtilsMessengerEXT;

        public VkInstanceApi(System.Func<string, nint> load)
        {
            vkDestroyInstance = (delegate* unmanaged[Cdecl]<nint, void*, void>)load("vkDestroyInstance");
            vkEnumeratePhysicalDevices = (delegate* unmanaged[Cdecl]<nint, uint*, nint*, int>)load("vkEnumeratePhysicalDevices");
            vkGetPhysicalDeviceProperties = (delegate* unmanaged[Cdecl]<nint, VkPhysicalDeviceProperties*, void>)load("vkGetPhysicalDeviceProperties");
            vkGetPhysicalDeviceProperties2 = (delegate* unmanaged[Cdecl]<nint, VkPhysicalDeviceProperties2*, void>)load("vkGetPhysicalDeviceProperties2");
            vkGetPhysicalDeviceFeatures = (delegate* unmanaged[Cdecl]<nint, VkPhysicalDeviceFeatures*, void>)load("vkGetPhysicalDeviceFeatures");
            vkGetPhysicalDeviceFeatures2 = (delegate* unmanaged[Cdecl]<nint, VkPhysicalDeviceFeatures2*, void>)load("vkGetPhysicalDeviceFeatures2");
            vkGetPhysicalDeviceQueueFamilyProperties =
                (delegate* unmanaged[Cdecl]<nint, uint*, VkQueueFamilyProperties*, void>)load("vkGetPhysicalDeviceQueueFamilyProperties");
            vkGetPhysicalDeviceMemoryProperties =
                (delegate* unmanaged[Cdecl]<nint, VkPhysicalDeviceMemoryProperties*, void>)load("vkGetPhysicalDeviceMemoryProperties");
            vkGetPhysicalDeviceFormatProperties =
                (delegate* unmanaged[Cdecl]<nint, uint, VkFormatProperties*, void>)load("vkGetPhysicalDeviceFormatProperties");
            vkEnumerateDeviceExtensionProperties =
                (delegate* unmanaged[Cdecl]<nint, byte*, uint*, VkExtensionProperties*, int>)load("vkEnumerateDeviceExtensionProperties");
            vkCreateDevice = (delegate* unmanaged[Cdecl]<nint, VkDeviceCreateInfo*, void*, nint*, int>)load("vkCreateDevice");
            vkCreateDebugUtilsMessengerEXT =
                (delegate* unmanaged[Cdecl]<nint, VkDebugUtilsMessengerCreateInfoEXT*, void*, ulong*, int>)load("vkCreateDebugUtilsMessengerEXT");
            vkDestroyDebugUtilsMessengerEXT = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroyDebugUtilsMessengerEXT");
        }
    }
}
