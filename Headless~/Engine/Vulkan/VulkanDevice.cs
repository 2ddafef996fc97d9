using System;
using System.Collections.Generic;

namespace UnityEngine.Vulkan
{
    /// <summary>A device with one queue, its limits, and memory from it.</summary>
    sealed unsafe class VulkanDevice : IDisposable
    {
        readonly VkPhysicalDeviceMemoryProperties m_Memory;
        readonly Dictionary<uint, uint> m_FormatFeatures = new();

        internal VulkanDevice(VulkanInstance instance, string wanted)
        {
            Instance = instance;
            Physical = PhysicalDevices.Choose(instance, wanted);
            QueueFamily = (uint)PhysicalDevices.QueueFamily(instance, Physical);
            Properties = PhysicalDevices.Properties(instance, Physical);
            Name = PhysicalDevices.Name(Properties);
            VkPhysicalDeviceMemoryProperties memory;
            instance.Api.vkGetPhysicalDeviceMemoryProperties(Physical, &memory);
            m_Memory = memory;
            SubgroupSize = QuerySubgroupSize(instance);
            Abilities = new DeviceAbilities(instance, Physical, PhysicalDevices.Draws(instance, Physical, QueueFamily));
            Handle = Create(instance);
            (Api, Draw) = instance.LoadDevice(Handle);
            nint queue;
            Api.vkGetDeviceQueue(Handle, QueueFamily, 0, &queue);
            Queue = queue;
        }

        internal VulkanInstance Instance { get; }

        internal nint Physical { get; }

        internal nint Handle { get; private set; }

        internal nint Queue { get; }

        internal uint QueueFamily { get; }

        internal VkDeviceApi Api { get; }

        internal VkDrawApi Draw { get; }

        internal DeviceAbilities Abilities { get; }

        internal VkPhysicalDeviceProperties Properties { get; }

        internal string Name { get; }

        internal int SubgroupSize { get; }

        /// <summary>Bytes of device-local memory.</summary>
        internal ulong LocalMemory
        {
            get
            {
                ulong sum = 0;
                for (var i = 0; i < m_Memory.memoryHeapCount; i++)
                {
                    var heap = Heap(i);
                    if ((heap.flags & Vk.VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) != 0)
                        sum += heap.size;
                }
                return sum;
            }
        }

        /// <summary>The VK_FORMAT_FEATURE bits of a format with optimal tiling.</summary>
        internal uint FormatFeatures(uint format)
        {
            if (m_FormatFeatures.TryGetValue(format, out var features))
                return features;
            VkFormatProperties properties;
            Instance.Api.vkGetPhysicalDeviceFormatProperties(Physical, format, &properties);
            m_FormatFeatures.Add(format, properties.optimalTilingFeatures);
            return properties.optimalTilingFeatures;
        }

        /// <summary>Allocates memory of a type that has all required properties and as many of the preferred ones as there are.</summary>
        /// <exception cref="VulkanException">Out of memory, or no such type.</exception>
        internal ulong Allocate(in VkMemoryRequirements needs, uint required, uint preferred, out uint properties)
        {
            var type = FindType(needs.memoryTypeBits, required, preferred);
            properties = Type(type).propertyFlags;
            var info = new VkMemoryAllocateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                allocationSize = needs.size,
                memoryTypeIndex = (uint)type,
            };
            ulong memory;
            var result = Api.vkAllocateMemory(Handle, &info, null, &memory);
            if (result is Vk.VK_ERROR_OUT_OF_DEVICE_MEMORY or Vk.VK_ERROR_OUT_OF_HOST_MEMORY)
                throw new VulkanException($"Out of GPU memory: {needs.size:N0} bytes were asked for on {Name}.");
            VulkanException.Check(result, "vkAllocateMemory");
            return memory;
        }

        internal void SetName(uint objectType, ulong handle, string name)
        {
            if (!Instance.Validation || string.IsNullOrEmpty(name) || Api.vkSetDebugUtilsObjectNameEXT == null)
                return;
            using var text = new NativeText();
            var info = new VkDebugUtilsObjectNameInfoEXT
            {
                sType = Vk.VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
                objectType = objectType,
                objectHandle = handle,
                pObjectName = text.Add(name),
            };
            VulkanException.Check(Api.vkSetDebugUtilsObjectNameEXT(Handle, &info), "vkSetDebugUtilsObjectNameEXT");
        }

        public void Dispose()
        {
            if (Handle == 0)
                return;
            Api.vkDestroyDevice(Handle, null);
            Handle = 0;
        }

        nint Create(VulkanInstance instance)
        {
            if (!Abilities.WritesWithoutFormat)
                throw new VulkanException($"{Name} lacks shaderStorageImageWriteWithoutFormat, which kernels that write textures need.");
            using var text = new NativeText();
            var features = Abilities.Features;
            var multiview = new VkPhysicalDeviceMultiviewFeatures { sType = Vk.VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MULTIVIEW_FEATURES, multiview = 1 };
            var priority = 1f;
            var queue = new VkDeviceQueueCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                queueFamilyIndex = QueueFamily,
                queueCount = 1,
                pQueuePriorities = &priority,
            };
            var info = new VkDeviceCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                pNext = Abilities.HasMultiview ? &multiview : null,
                queueCreateInfoCount = 1,
                pQueueCreateInfos = &queue,
                enabledExtensionCount = (uint)Abilities.Extensions.Count,
                ppEnabledExtensionNames = text.AddAll(Abilities.Extensions),
                pEnabledFeatures = &features,
            };
            nint device;
            VulkanException.Check(instance.Api.vkCreateDevice(Physical, &info, null, &device), "vkCreateDevice");
            return device;
        }

        int QuerySubgroupSize(VulkanInstance instance)
        {
            var subgroup = new VkPhysicalDeviceSubgroupProperties { sType = Vk.VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES };
            var properties = new VkPhysicalDeviceProperties2 { sType = Vk.VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, pNext = &subgroup };
            instance.Api.vkGetPhysicalDeviceProperties2(Physical, &properties);
            return (int)subgroup.subgroupSize;
        }

        int FindType(uint allowed, uint required, uint preferred)
        {
            var best = -1;
            var bestScore = -1;
            for (var i = 0; i < m_Memory.memoryTypeCount; i++)
            {
                var flags = Type(i).propertyFlags;
                if ((allowed & (1u << i)) == 0 || (flags & required) != required)
                    continue;
                var score = CountBits(flags & preferred);
                if (score <= bestScore)
                    continue;
                best = i;
                bestScore = score;
            }
            if (best < 0)
                throw new VulkanException($"{Name} has no memory type with properties 0x{required:X}.");
            return best;
        }

        VkMemoryType Type(int index)
        {
            fixed (VkMemoryType* types = &m_Memory.memoryTypes0)
                return types[index];
        }

        VkMemoryHeap Heap(int index)
        {
            fixed (VkMemoryHeap* heaps = &m_Memory.memoryHeaps0)
                return heaps[index];
        }

        static int CountBits(uint value)
        {
            var count = 0;
            for (; value != 0; value &= value - 1)
                count++;
            return count;
        }
    }
}
