using System;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>A part of a mip level: texels and slices (depth slices of a volume, layers of an array).</summary>
    readonly struct TexelBox
    {
        internal TexelBox(int x, int y, int z, int width, int height, int depth)
        {
            X = x;
            Y = y;
            Z = z;
            Width = width;
            Height = height;
            Depth = depth;
        }

        internal readonly int X;
        internal readonly int Y;
        internal readonly int Z;
        internal readonly int Width;
        internal readonly int Height;
        internal readonly int Depth;

        internal long Texels => (long)Width * Height * Depth;
    }

    /// <summary>The memory behind a texture.</summary>
    sealed unsafe class GpuTexture : IGpuObject
    {
        const float FillUNorm = 0xCD / 255f;
        const uint FillInteger = 0xCDCDCDCD;

        readonly GpuContext m_Context;
        readonly string m_Kind;

        /// <param name="kind">What the report of leaks calls it.</param>
        /// <param name="name">Its name.</param>
        /// <param name="shape">Its sizes.</param>
        /// <param name="format">Its format; the colours of a project in gamma space are never converted, so sRGB is left out there.</param>
        /// <param name="randomWrite">Whether kernels may write it.</param>
        /// <param name="target">Whether it can be drawn into.</param>
        /// <param name="samples">Per texel.</param>
        internal GpuTexture(string kind, string name, in ImageShape shape, FormatInfo format, bool randomWrite, bool target = false, int samples = 1)
        {
            m_Context = Gpu.Context;
            m_Kind = kind;
            Name = name;
            Format = ColorSpaces.IsLinear ? format : FormatInfo.Of(FormatTables.ToLinear(format.Format));
            IsRandomWrite = randomWrite;
            var usage = Vk.VK_IMAGE_USAGE_TRANSFER_SRC_BIT | Vk.VK_IMAGE_USAGE_TRANSFER_DST_BIT | Vk.VK_IMAGE_USAGE_SAMPLED_BIT;
            if (randomWrite)
                usage |= Vk.VK_IMAGE_USAGE_STORAGE_BIT;
            if (target)
                usage |= format.IsDepth ? Vk.VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT : Vk.VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
            Image = new VulkanImage(m_Context.Device, shape, Format.Vulkan, usage, samples);
            Bytes = (long)Image.Size;
            m_Context.Add(this);
            m_Context.Device.SetName(Vk.VK_OBJECT_TYPE_IMAGE, Image.Handle, name);
        }

        internal VulkanImage Image { get; private set; }

        internal string Name { get; set; }

        internal FormatInfo Format { get; }

        internal bool IsRandomWrite { get; }

        internal bool CanFilter =>
            (m_Context.Device.FormatFeatures(Format.Vulkan) & Vk.VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT) != 0;

        internal bool IsAlive => Image != null && !m_Context.IsDisposed;

        public bool IsTexture => true;

        public long Bytes { get; }

        public string Describe()
        {
            var s = Image.Shape;
            return $"{m_Kind} '{Name}': {s.Width} x {s.Height} x {Math.Max(s.Depth, s.Layers)} {Format.Format}";
        }

        public void FreeNow()
        {
            Image?.Dispose();
            Image = null;
        }

        /// <summary>Frees the memory when the device is done with it.</summary>
        internal void Release()
        {
            if (!IsAlive)
                return;
            m_Context.Remove(this);
            m_Context.Stream.Release(Image, Image.LastUse);
            Image = null;
        }

        /// <summary>Fills all mip levels with the pattern that stands for undefined contents.</summary>
        internal void FillUndefined()
        {
            if (!GpuOptions.FillNewMemory)
                return;
            if (Format.IsDepth)
            {
                FillDepth();
                return;
            }
            var value = default(VkClearColorValue);
            for (var c = 0; c < 4; c++)
            {
                if (Format.IsInteger)
                    value.uint32[c] = FillInteger & (Format.Bits == 32 ? uint.MaxValue : (1u << Format.Bits) - 1);
                else
                    value.float32[c] = Format.Kind == ChannelKind.SFloat ? float.NaN : FillUNorm;
            }
            m_Context.Stream.Write(Image, Vk.VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
            var range = Image.Whole;
            var commands = m_Context.Stream.Command();
            m_Context.Device.Api.vkCmdClearColorImage(commands, Image.Handle, Vk.VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &value, 1, &range);
        }

        void FillDepth()
        {
            var value = new VkClearDepthStencilValue { depth = FillUNorm, stencil = 0xCD };
            m_Context.Stream.Write(Image, Vk.VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
            var range = Image.Whole;
            var commands = m_Context.Stream.Command();
            m_Context.Device.Draw.vkCmdClearDepthStencilImage(commands, Image.Handle, Vk.VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &value, 1, &range);
        }

        /// <summary>Copies tightly packed texels into a part of a mip level, through staging memory in pieces.</summary>
        internal void Upload(int mip, in TexelBox box, byte* texels)
        {
            var stream = m_Context.Stream;
            var row = (long)box.Width * Format.BytesPerTexel;
            var slice = row * box.Height;
            var max = (long)stream.MaxSlice;
            var slices = (int)Math.Min(box.Depth, max / slice);
            if (slices > 0)
            {
                for (var z = 0; z < box.Depth; z += slices)
                    Piece(mip, new TexelBox(box.X, box.Y, box.Z + z, box.Width, box.Height, Math.Min(slices, box.Depth - z)), texels + z * slice);
                return;
            }
            var rows = (int)(max / row);
            for (var z = 0; z < box.Depth; z++)
                for (var y = 0; y < box.Height; y += rows)
                    Piece(mip, new TexelBox(box.X, box.Y + y, box.Z + z, box.Width, Math.Min(rows, box.Height - y), 1), texels + z * slice + y * row);
        }

        /// <summary>Records a copy of a part of a mip level into a buffer, tightly packed.</summary>
        internal void CopyTo(VulkanBuffer buffer, ulong offset, int mip, in TexelBox box)
        {
            m_Context.Stream.Write(buffer);
            m_Context.Stream.Read(Image, Vk.VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
            var region = Region(offset, mip, box);
            var commands = m_Context.Stream.Command();
            m_Context.Device.Api.vkCmdCopyImageToBuffer(commands, Image.Handle, Vk.VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.Handle, 1, &region);
        }

        /// <summary>Records a copy of a part of a mip level into another texture.</summary>
        internal void CopyTo(GpuTexture target, int mip, in TexelBox box, int targetMip, int targetX, int targetY, int targetZ)
        {
            m_Context.Stream.Read(Image, Vk.VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
            m_Context.Stream.Write(target.Image, Vk.VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
            var from = Region(0, mip, box);
            var to = target.Region(0, targetMip, new TexelBox(targetX, targetY, targetZ, box.Width, box.Height, box.Depth));
            var region = new VkImageCopy
            {
                srcSubresource = from.imageSubresource,
                srcOffset = from.imageOffset,
                dstSubresource = to.imageSubresource,
                dstOffset = to.imageOffset,
                extent = from.imageExtent,
            };
            var commands = m_Context.Stream.Command();
            m_Context.Device.Api.vkCmdCopyImage(commands, Image.Handle, Vk.VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                target.Image.Handle, Vk.VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
        }

        void Piece(int mip, in TexelBox box, byte* texels)
        {
            var bytes = box.Texels * Format.BytesPerTexel;
            var staging = m_Context.Stream.Staging((ulong)bytes);
            Buffer.MemoryCopy(texels, staging.Pointer, bytes, bytes);
            m_Context.Stream.Read(staging.Buffer);
            m_Context.Stream.Write(Image, Vk.VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
            var region = Region(staging.Offset, mip, box);
            var commands = m_Context.Stream.Command();
            m_Context.Device.Api.vkCmdCopyBufferToImage(commands, staging.Buffer.Handle, Image.Handle, Vk.VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
        }

        VkBufferImageCopy Region(ulong offset, int mip, in TexelBox box)
        {
            var volume = Image.Shape.IsVolume;
            return new VkBufferImageCopy
            {
                bufferOffset = offset,
                imageSubresource = new VkImageSubresourceLayers
                {
                    aspectMask = Image.ReadAspect,
                    mipLevel = (uint)mip,
                    baseArrayLayer = volume ? 0 : (uint)box.Z,
                    layerCount = volume ? 1 : (uint)box.Depth,
                },
                imageOffset = new VkOffset3D { x = box.X, y = box.Y, z = volume ? box.Z : 0 },
                imageExtent = new VkExtent3D { width = (uint)box.Width, height = (uint)box.Height, depth = volume ? (uint)box.Depth : 1 },
            };
        }
    }
}
