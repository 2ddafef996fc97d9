using System;
using System.Collections.Generic;

namespace UnityEngine.Vulkan
{
    /// <summary>The shape of an image.</summary>
    readonly struct ImageShape
    {
        internal ImageShape(int width, int height, int depth, int layers, int mips, bool volume, bool array)
        {
            Width = width;
            Height = height;
            Depth = depth;
            Layers = layers;
            Mips = mips;
            IsVolume = volume;
            IsArray = array;
        }

        internal readonly int Width;
        internal readonly int Height;
        internal readonly int Depth;
        internal readonly int Layers;
        internal readonly int Mips;
        internal readonly bool IsVolume;
        internal readonly bool IsArray;

        /// <summary>Width, height and depth of a mip level; depth is 1 unless it is a volume.</summary>
        internal (int Width, int Height, int Depth) Mip(int level) =>
            (Math.Max(1, Width >> level), Math.Max(1, Height >> level), Math.Max(1, Depth >> level));
    }

    /// <summary>An image with memory of its own, its views, and the layout that it is in.</summary>
    sealed unsafe class VulkanImage : VulkanResource, IDisposable
    {
        readonly VulkanDevice m_Device;
        readonly Dictionary<int, ulong> m_StorageViews = new();
        ulong m_SampledView;
        ulong m_Memory;

        internal VulkanImage(VulkanDevice device, in ImageShape shape, uint format, uint usage)
        {
            m_Device = device;
            Shape = shape;
            Format = format;
            var info = new VkImageCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                imageType = shape.IsVolume ? Vk.VK_IMAGE_TYPE_3D : Vk.VK_IMAGE_TYPE_2D,
                format = format,
                extent = new VkExtent3D { width = (uint)shape.Width, height = (uint)shape.Height, depth = (uint)shape.Depth },
                mipLevels = (uint)shape.Mips,
                arrayLayers = (uint)shape.Layers,
                samples = Vk.VK_SAMPLE_COUNT_1_BIT,
                tiling = Vk.VK_IMAGE_TILING_OPTIMAL,
                usage = usage,
                sharingMode = Vk.VK_SHARING_MODE_EXCLUSIVE,
                initialLayout = Vk.VK_IMAGE_LAYOUT_UNDEFINED,
            };
            ulong handle;
            VulkanException.Check(device.Api.vkCreateImage(device.Handle, &info, null, &handle), "vkCreateImage");
            Handle = handle;
            try
            {
                VkMemoryRequirements needs;
                device.Api.vkGetImageMemoryRequirements(device.Handle, Handle, &needs);
                m_Memory = device.Allocate(needs, Vk.VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0, out _);
                Size = needs.size;
                VulkanException.Check(device.Api.vkBindImageMemory(device.Handle, Handle, m_Memory, 0), "vkBindImageMemory");
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        internal ulong Handle { get; private set; }

        internal ImageShape Shape { get; }

        internal uint Format { get; }

        /// <summary>Bytes of memory it takes.</summary>
        internal ulong Size { get; }

        /// <summary>The layout after all commands recorded so far.</summary>
        internal uint Layout { get; set; } = Vk.VK_IMAGE_LAYOUT_UNDEFINED;

        internal static VkImageSubresourceRange Whole => new()
        {
            aspectMask = Vk.VK_IMAGE_ASPECT_COLOR_BIT,
            levelCount = Vk.VK_REMAINING_MIP_LEVELS,
            layerCount = Vk.VK_REMAINING_ARRAY_LAYERS,
        };

        /// <summary>A view of all mip levels, for reading.</summary>
        internal ulong SampledView
        {
            get
            {
                if (m_SampledView == 0)
                    m_SampledView = CreateView(0, Shape.Mips);
                return m_SampledView;
            }
        }

        /// <summary>A view of one mip level, for writing.</summary>
        internal ulong StorageView(int mip)
        {
            if (!m_StorageViews.TryGetValue(mip, out var view))
            {
                view = CreateView(mip, 1);
                m_StorageViews.Add(mip, view);
            }
            return view;
        }

        public void Dispose()
        {
            if (m_SampledView != 0)
                m_Device.Api.vkDestroyImageView(m_Device.Handle, m_SampledView, null);
            foreach (var view in m_StorageViews.Values)
                m_Device.Api.vkDestroyImageView(m_Device.Handle, view, null);
            if (Handle != 0)
                m_Device.Api.vkDestroyImage(m_Device.Handle, Handle, null);
            if (m_Memory != 0)
                m_Device.Api.vkFreeMemory(m_Device.Handle, m_Memory, null);
            m_StorageViews.Clear();
            m_SampledView = 0;
            Handle = 0;
            m_Memory = 0;
        }

        ulong CreateView(int firstMip, int mips)
        {
            var info = new VkImageViewCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                image = Handle,
                viewType = Shape.IsVolume ? Vk.VK_IMAGE_VIEW_TYPE_3D : Shape.IsArray ? Vk.VK_IMAGE_VIEW_TYPE_2D_ARRAY : Vk.VK_IMAGE_VIEW_TYPE_2D,
                format = Format,
                subresourceRange = new VkImageSubresourceRange
                {
                    aspectMask = Vk.VK_IMAGE_ASPECT_COLOR_BIT,
                    baseMipLevel = (uint)firstMip,
                    levelCount = (uint)mips,
                    layerCount = (uint)Shape.Layers,
                },
            };
            ulong view;
            VulkanException.Check(m_Device.Api.vkCreateImageView(m_Device.Handle, &info, null, &view), "vkCreateImageView");
            return view;
        }
    }
}
