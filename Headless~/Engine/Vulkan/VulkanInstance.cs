using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace UnityEngine.Vulkan
{
    /// <summary>The Vulkan loader and one instance, watched by the validation layer if asked for.</summary>
    sealed unsafe class VulkanInstance : IDisposable
    {
        const string ValidationLayer = "VK_LAYER_KHRONOS_validation";
        const string DebugUtils = "VK_EXT_debug_utils";
        const uint Version11 = (1u << 22) | (1u << 12);

        readonly VulkanMessages m_Messages;
        ulong m_Messenger;

        /// <exception cref="VulkanException">No loader, no driver, or no validation layer although it was asked for.</exception>
        internal VulkanInstance(bool validation, VulkanMessages messages)
        {
            m_Messages = messages;
            var global = LoadGlobal();
            using var text = new NativeText();
            var layers = new List<string>();
            var extensions = new List<string>();
            if (validation)
            {
                if (!Layers(global).Contains(ValidationLayer))
                    throw new VulkanException($"Vulkan's layer {ValidationLayer} is not installed (Debian: vulkan-validationlayers).");
                layers.Add(ValidationLayer);
                extensions.Add(DebugUtils);
            }
            var application = new VkApplicationInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_APPLICATION_INFO,
                pApplicationName = text.Add("AnatomyCarve"),
                pEngineName = text.Add("AnatomyCarve headless"),
                apiVersion = Version11,
            };
            var messenger = messages.CreateInfo();
            var info = new VkInstanceCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                pNext = validation ? &messenger : null,
                pApplicationInfo = &application,
                enabledLayerCount = (uint)layers.Count,
                ppEnabledLayerNames = text.AddAll(layers),
                enabledExtensionCount = (uint)extensions.Count,
                ppEnabledExtensionNames = text.AddAll(extensions),
            };
            nint created;
            var result = global.vkCreateInstance(&info, null, &created);
            if (result == Vk.VK_ERROR_INCOMPATIBLE_DRIVER)
                throw new VulkanException("No Vulkan driver is installed. Debian's package mesa-vulkan-drivers has one that needs no GPU.");
            VulkanException.Check(result, "vkCreateInstance");
            Handle = created;
            Validation = validation;
            Api = new VkInstanceApi(name => Load(Handle, name, required: !name.EndsWith("EXT", StringComparison.Ordinal)));
            if (!validation)
                return;
            ulong messengerHandle;
            VulkanException.Check(Api.vkCreateDebugUtilsMessengerEXT(Handle, &messenger, null, &messengerHandle), "vkCreateDebugUtilsMessengerEXT");
            m_Messenger = messengerHandle;
        }

        internal nint Handle { get; private set; }

        internal bool Validation { get; }

        internal VkInstanceApi Api { get; }

        internal (VkDeviceApi Api, VkDrawApi Draw) LoadDevice(nint device)
        {
            using var text = new NativeText();
            var getAddress = (delegate* unmanaged[Cdecl]<nint, byte*, nint>)Load(Handle, "vkGetDeviceProcAddr", required: true);
            nint Get(string name)
            {
                var address = getAddress(device, text.Add(name));
                if (address == 0 && !name.EndsWith("EXT", StringComparison.Ordinal))
                    throw new VulkanException($"The Vulkan driver lacks {name}.");
                return address;
            }

            return (new VkDeviceApi(Get), new VkDrawApi(Get));
        }

        public void Dispose()
        {
            if (Handle == 0)
                return;
            if (m_Messenger != 0)
                Api.vkDestroyDebugUtilsMessengerEXT(Handle, m_Messenger, null);
            m_Messenger = 0;
            Api.vkDestroyInstance(Handle, null);
            Handle = 0;
            GC.KeepAlive(m_Messages);
        }

        static VkGlobalApi LoadGlobal()
        {
            try
            {
                return new VkGlobalApi(name => Load(0, name, required: true));
            }
            catch (DllNotFoundException e)
            {
                throw new VulkanException("Vulkan's loader libvulkan.so.1 is not installed. Debian: apt install libvulkan1 mesa-vulkan-drivers.", e);
            }
        }

        static HashSet<string> Layers(VkGlobalApi api)
        {
            uint count = 0;
            VulkanException.Check(api.vkEnumerateInstanceLayerProperties(&count, null), "vkEnumerateInstanceLayerProperties");
            var properties = new VkLayerProperties[count];
            var names = new HashSet<string>();
            fixed (VkLayerProperties* p = properties)
            {
                VulkanException.Check(api.vkEnumerateInstanceLayerProperties(&count, p), "vkEnumerateInstanceLayerProperties");
                for (var i = 0; i < count; i++)
                    names.Add(NativeText.Read(p[i].layerName));
            }
            return names;
        }

        static nint Load(nint instance, string name, bool required)
        {
            using var text = new NativeText();
            var address = vkGetInstanceProcAddr(instance, text.Add(name));
            if (address == 0 && required)
                throw new VulkanException($"The Vulkan loader lacks {name}.");
            return address;
        }

        [DllImport("libvulkan.so.1", CallingConvention = CallingConvention.Cdecl)]
        [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
        static extern nint vkGetInstanceProcAddr(nint instance, byte* name);
    }
}
