namespace UnityEngine.Vulkan
{
    /// <summary>Functions that need no instance.</summary>
    sealed unsafe class VkGlobalApi
    {
        public readonly delegate* unmanaged[Cdecl]<VkInstanceCreateInfo*, void*, nint*, int> vkCreateInstance;
        public readonly delegate* unmanaged[Cdecl]<uint*, VkLayerProperties*, int> vkEnumerateInstanceLayerProperties;
        public readonly delegate* unmanaged[Cdecl]<byte*, uint*, VkExtensionProperties*, int> vkEnumerateInstanceExtensionProperties;

        public VkGlobalApi(System.Func<string, nint> load)
        {
            vkCreateInstance = (delegate* unmanaged[Cdecl]<VkInstanceCreateInfo*, void*, nint*, int>)load("vkCreateInstance");
            vkEnumerateInstanceLayerProperties = (delegate* unmanaged[Cdecl]<uint*, VkLayerProperties*, int>)load("vkEnumerateInstanceLayerProperties");
            vkEnumerateInstanceExtensionProperties =
                (delegate* unmanaged[Cdecl]<byte*, uint*, VkExtensionProperties*, int>)load("vkEnumerateInstanceExtensionProperties");
        }
    }
}
