using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace UnityEngine.Vulkan
{
    /// <summary>Chooses the physical device: the first GPU, otherwise a driver on the CPU, unless the environment names one.</summary>
    static unsafe class PhysicalDevices
    {
        /// <exception cref="VulkanException">There is none, or none fits the name.</exception>
        internal static nint Choose(VulkanInstance instance, string wanted)
        {
            uint count = 0;
            VulkanException.Check(instance.Api.vkEnumeratePhysicalDevices(instance.Handle, &count, null), "vkEnumeratePhysicalDevices");
            var devices = new nint[count];
            fixed (nint* p = devices)
                VulkanException.Check(instance.Api.vkEnumeratePhysicalDevices(instance.Handle, &count, p), "vkEnumeratePhysicalDevices");
            var usable = devices.Where(d => QueueFamily(instance, d) >= 0).ToList();
            if (usable.Count == 0)
                throw new VulkanException("No Vulkan device that computes was found. Debian's package mesa-vulkan-drivers has one that needs no GPU.");
            if (!string.IsNullOrEmpty(wanted))
                return Named(instance, usable, wanted);
            return usable.OrderBy(d => Rank(Properties(instance, d).deviceType)).First();
        }

        /// <summary>The first queue family that computes and draws, or computes alone; -1 if there is none.</summary>
        internal static int QueueFamily(VulkanInstance instance, nint device)
        {
            var families = Families(instance, device);
            const uint both = Vk.VK_QUEUE_GRAPHICS_BIT | Vk.VK_QUEUE_COMPUTE_BIT;
            var index = Array.FindIndex(families, f => (f.queueFlags & both) == both);
            return index >= 0 ? index : Array.FindIndex(families, f => (f.queueFlags & Vk.VK_QUEUE_COMPUTE_BIT) != 0);
        }

        /// <summary>Whether a queue family takes draws.</summary>
        internal static bool Draws(VulkanInstance instance, nint device, uint family) =>
            (Families(instance, device)[family].queueFlags & Vk.VK_QUEUE_GRAPHICS_BIT) != 0;

        internal static VkPhysicalDeviceProperties Properties(VulkanInstance instance, nint device)
        {
            VkPhysicalDeviceProperties properties;
            instance.Api.vkGetPhysicalDeviceProperties(device, &properties);
            return properties;
        }

        internal static string Name(in VkPhysicalDeviceProperties properties)
        {
            fixed (byte* name = properties.deviceName)
                return NativeText.Read(name);
        }

        static VkQueueFamilyProperties[] Families(VulkanInstance instance, nint device)
        {
            uint count = 0;
            instance.Api.vkGetPhysicalDeviceQueueFamilyProperties(device, &count, null);
            var families = new VkQueueFamilyProperties[count];
            fixed (VkQueueFamilyProperties* p = families)
                instance.Api.vkGetPhysicalDeviceQueueFamilyProperties(device, &count, p);
            return families;
        }

        static nint Named(VulkanInstance instance, List<nint> devices, string wanted)
        {
            if (int.TryParse(wanted, NumberStyles.None, CultureInfo.InvariantCulture, out var number) && number < devices.Count)
                return devices[number];
            var names = devices.Select(d => Name(Properties(instance, d))).ToList();
            var index = names.FindIndex(n => n.IndexOf(wanted, StringComparison.OrdinalIgnoreCase) >= 0);
            if (index >= 0)
                return devices[index];
            throw new VulkanException($"{GpuOptions.DeviceVariable} asks for the Vulkan device '{wanted}'; there are: {string.Join(", ", names)}.");
        }

        static int Rank(uint type) => type switch
        {
            Vk.VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU => 0,
            Vk.VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU => 1,
            Vk.VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU => 2,
            _ => 3,
        };
    }
}
