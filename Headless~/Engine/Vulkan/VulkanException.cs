using System;

namespace UnityEngine.Vulkan
{
    /// <summary>A Vulkan call failed, or there is nothing to call.</summary>
    sealed class VulkanException : Exception
    {
        internal VulkanException(string message) : base(message)
        {
        }

        internal VulkanException(string message, Exception inner) : base(message, inner)
        {
        }

        /// <summary>Throws unless the result is VK_SUCCESS.</summary>
        internal static void Check(int result, string call)
        {
            if (result == Vk.VK_SUCCESS)
                return;
            throw new VulkanException($"{call} failed: {Name(result)}.");
        }

        static string Name(int result) => result switch
        {
            Vk.VK_NOT_READY => "VK_NOT_READY",
            Vk.VK_TIMEOUT => "VK_TIMEOUT",
            Vk.VK_ERROR_OUT_OF_HOST_MEMORY => "VK_ERROR_OUT_OF_HOST_MEMORY",
            Vk.VK_ERROR_OUT_OF_DEVICE_MEMORY => "VK_ERROR_OUT_OF_DEVICE_MEMORY",
            Vk.VK_ERROR_INITIALIZATION_FAILED => "VK_ERROR_INITIALIZATION_FAILED",
            Vk.VK_ERROR_DEVICE_LOST => "VK_ERROR_DEVICE_LOST",
            Vk.VK_ERROR_LAYER_NOT_PRESENT => "VK_ERROR_LAYER_NOT_PRESENT",
            Vk.VK_ERROR_EXTENSION_NOT_PRESENT => "VK_ERROR_EXTENSION_NOT_PRESENT",
            Vk.VK_ERROR_FEATURE_NOT_PRESENT => "VK_ERROR_FEATURE_NOT_PRESENT",
            Vk.VK_ERROR_INCOMPATIBLE_DRIVER => "VK_ERROR_INCOMPATIBLE_DRIVER",
            _ => "VkResult " + result.ToString(System.Globalization.CultureInfo.InvariantCulture),
        };
    }
}
