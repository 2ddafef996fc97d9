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
        readonly Dictionary<(int Mip, int Layer, int Layers, uint Format), ulong> m_AttachmentViews = new();
        ulong m_SampledView;
        ulong m_Memory;

        internal VulkanImage(VulkanDevice device, in ImageShape shape, uint format, uint usage, int samples = 1)
        {
            m_Device = device;
            Shape = shape;
            Format = format;
            Samples = samples;
            var info = new VkImageCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                // An sRGB target can be written as it is, too.
                flags = LinearFormat != format && (usage & Vk.VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT) != 0 ? Vk.VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT : 0,
                imageType = shape.IsVolume ? Vk.VK_IMAGE_TYPE_3D : Vk.VK_IMAGE_TYPE_2D,
                format = format,
                extent = new VkExtent3D { width = (uint)shape.Width, height = (uint)shape.Height, depth = (uint)shape.Depth },
                mipLevels = (uint)shape.Mips,
                arrayLayers = (uint)shape.Layers,
                samples = (uint)samples,
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

        /// <summary>The same texels without conversion to or from sRGB.</summary>
        internal uint LinearFormat => Format switch
        {
            // R8, RG8, RGB8, BGR8, RGBA8, BGRA8: SRGB comes six after UNORM.
            15 or 22 or 29 or 36 or 43 or 50 => Format - 6,
            _ => Format,
        };

        internal int Samples { get; }

        /// <summary>All aspects of the format.</summary>
        internal uint Aspects => Format switch
        {
            Vk.VK_FORMAT_D16_UNORM or Vk.VK_FORMAT_X8_D24_UNORM_PACK32 or Vk.VK_FORMAT_D32_SFLOAT => Vk.VK_IMAGE_ASPECT_DEPTH_BIT,
            Vk.VK_FORMAT_S8_UINT => Vk.VK_IMAGE_ASPECT_STENCIL_BIT,
            Vk.VK_FORMAT_D16_UNORM_S8_UINT or Vk.VK_FORMAT_D24_UNORM_S8_UINT or Vk.VK_FORMAT_D32_SFLOAT_S8_UINT =>
                Vk.VK_IMAGE_ASPECT_DEPTH_BIT | Vk.VK_IMAGE_ASPECT_STENCIL_BIT,
            _ => Vk.VK_IMAGE_ASPECT_COLOR_BIT,
        };

        internal bool IsDepth => (Aspects & Vk.VK_IMAGE_ASPECT_DEPTH_BIT) != 0;

        /// <summary>The one aspect that is read: depth, or colour.</summary>
        internal uint ReadAspect => IsDepth ? Vk.VK_IMAGE_ASPECT_DEPTH_BIT : Aspects;

        internal VkImageSubresourceRange Whole => new()
        {
            aspectMask = Aspects,
            levelCount = Vk.VK_REMAINING_MIP_LEVELS,
            layerCount = Vk.VK_REMAINING_ARRAY_LAYERS,
        };

        /// <summary>A view of all mip levels, for reading.</summary>
        internal ulong SampledView
        {
            get
            {
                if (m_SampledView == 0)
                    m_SampledView = CreateView(ReadAspect, 0, Shape.Mips, 0, Shape.Layers, Shape.IsArray, Format);
                return m_SampledView;
            }
        }

        /// <summary>A view of one mip level, for writing.</summary>
        internal ulong StorageView(int mip)
        {
            if (!m_StorageViews.TryGetValue(mip, out var view))
            {
                view = CreateView(ReadAspect, mip, 1, 0, Shape.Layers, Shape.IsArray, Format);
                m_StorageViews.Add(mip, view);
            }
            return view;
        }

        /// <summary>A view of some layers of one mip level, for drawing into.</summary>
        internal ulong AttachmentView(int mip, int layer, int layers, uint format)
        {
            var key = (mip, layer, layers, format);
            if (!m_AttachmentViews.TryGetValue(key, out var view))
            {
                view = CreateView(Aspects, mip, 1, layer, layers, layers > 1, format);
                m_AttachmentViews.Add(key, view);
            }
            return view;
        }

        public void Dispose()
        {
            if (m_SampledView != 0)
                m_Device.Api.vkDestroyImageView(m_Device.Handle, m_SampledView, null);
            foreach (var view in m_StorageViews.Values)
                m_Device.Api.vkDestroyImageView(m_Device.Handle, view, null);
            foreach (var view in m_AttachmentViews.Values)
                m_Device.Api.vkDestroyImageView(m_Device.Handle, view, null);
            if (Handle != 0)
                m_Device.Api.vkDestroyImage(m_Device.Handle, Handle, null);
            if (m_Memory != 0)
                m_Device.Api.vkFreeMemory(m_Device.Handle, m_Memory, null);
            m_StorageViews.Clear();
            m_AttachmentViews.Clear();
            m_SampledView = 0;
            Handle = 0;
            m_Memory = 0;
        }

        ulong CreateView(uint aspect, int firstMip, int mips, int firstLayer, int layers, bool array, uint format)
        {
            var info = new VkImageViewCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                image = Handle,
                viewType = Shape.IsVolume ? Vk.VK_IMAGE_VIEW_TYPE_3D : array ? Vk.VK_IMAGE_VIEW_TYPE_2D_ARRAY : Vk.VK_IMAGE_VIEW_TYPE_2D,
                format = format,
                subresourceRange = new VkImageSubresourceRange
                {
                    aspectMask = aspect,
                    baseMipLevel = (uint)firstMip,
                    levelCount = (uint)mips,
                    baseArrayLayer = (uint)firstLayer,
                    layerCount = (uint)layers,
                },
            };
            ulong view;
            VulkanException.Check(m_Device.Api.vkCreateImageView(m_Device.Handle, &info, null, &view), "vkCreateImageView");
            return view;
        }
    }
}
