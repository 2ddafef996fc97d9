using System.Collections.Generic;

namespace UnityEngine.Vulkan
{
    /// <summary>What a physical device can do beyond Vulkan 1.1's minimum, as far as this host uses it; all of that is switched on.</summary>
    sealed unsafe class DeviceAbilities
    {
        const string LayerExtension = "VK_EXT_shader_viewport_index_layer";

        internal DeviceAbilities(VulkanInstance instance, nint physical, bool draws)
        {
            CanDraw = draws;
            VkPhysicalDeviceFeatures available;
            instance.Api.vkGetPhysicalDeviceFeatures(physical, &available);
            var multiview = new VkPhysicalDeviceMultiviewFeatures { sType = Vk.VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MULTIVIEW_FEATURES };
            var all = new VkPhysicalDeviceFeatures2 { sType = Vk.VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, pNext = &multiview };
            instance.Api.vkGetPhysicalDeviceFeatures2(physical, &all);
            HasMultiview = draws && multiview.multiview != 0;
            VkPhysicalDeviceProperties properties;
            instance.Api.vkGetPhysicalDeviceProperties(physical, &properties);
            DrawsOneViewOnly = properties.deviceType == Vk.VK_PHYSICAL_DEVICE_TYPE_CPU;
            WritesWithoutFormat = available.shaderStorageImageWriteWithoutFormat != 0;
            Features = new VkPhysicalDeviceFeatures
            {
                shaderStorageImageWriteWithoutFormat = available.shaderStorageImageWriteWithoutFormat,
                shaderStorageImageExtendedFormats = available.shaderStorageImageExtendedFormats,
                robustBufferAccess = available.robustBufferAccess,
                shaderInt64 = available.shaderInt64,
                shaderFloat64 = available.shaderFloat64,
                shaderInt16 = available.shaderInt16,
                imageCubeArray = available.imageCubeArray,
                fullDrawIndexUint32 = available.fullDrawIndexUint32,
                // A fragment shader that reads the layer it is drawn to declares this capability.
                geometryShader = available.geometryShader,
                multiViewport = available.multiViewport,
                depthClamp = available.depthClamp,
                shaderClipDistance = available.shaderClipDistance,
                shaderCullDistance = available.shaderCullDistance,
            };
            HasVertexLayer = draws && available.geometryShader != 0 && available.multiViewport != 0
                && ExtensionsOf(instance, physical).Contains(LayerExtension);
            if (HasVertexLayer)
                Extensions.Add(LayerExtension);
        }

        /// <summary>Whether the queue takes draws, not only dispatches.</summary>
        internal bool CanDraw { get; }

        /// <summary>Whether one draw can go to several layers by views.</summary>
        internal bool HasMultiview { get; }

        /// <summary>
        /// Whether a pass must have one view at a time. Mesa's software device gathers the triangles that it clips, and draws them with the view that is the
        /// present one when they are enough: those of one view land in the other one's layer.
        /// </summary>
        internal bool DrawsOneViewOnly { get; }

        /// <summary>Whether a vertex shader can choose the layer.</summary>
        internal bool HasVertexLayer { get; }

        internal bool WritesWithoutFormat { get; }

        internal bool HasDepthClamp => Features.depthClamp != 0;

        internal VkPhysicalDeviceFeatures Features { get; }

        internal List<string> Extensions { get; } = new();

        static HashSet<string> ExtensionsOf(VulkanInstance instance, nint physical)
        {
            uint count = 0;
            VulkanException.Check(instance.Api.vkEnumerateDeviceExtensionProperties(physical, null, &count, null), "vkEnumerateDeviceExtensionProperties");
            var properties = new VkExtensionProperties[count];
            var names = new HashSet<string>();
            fixed (VkExtensionProperties* p = properties)
            {
                VulkanException.Check(instance.Api.vkEnumerateDeviceExtensionProperties(physical, null, &count, p), "vkEnumerateDeviceExtensionProperties");
                for (var i = 0; i < count; i++)
                    names.Add(NativeText.Read(p[i].extensionName));
            }
            return names;
        }
    }
}
