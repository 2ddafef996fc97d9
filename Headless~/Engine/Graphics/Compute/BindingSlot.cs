using System.Collections.Generic;
using UnityEngine.Shaders;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>What was found for one binding of a program.</summary>
    struct BindingSlot
    {
        internal GpuTexture Texture;
        internal int Mip;
        internal VulkanBuffer Buffer;
        internal ulong Offset;
        internal ulong Range;
        internal ulong Sampler;

        /// <summary>Writes a descriptor set.</summary>
        internal static unsafe void Write(GpuContext context, ulong set, IReadOnlyList<KernelBinding> bindings, BindingSlot[] slots)
        {
            var count = bindings.Count;
            var writes = stackalloc VkWriteDescriptorSet[count];
            var images = stackalloc VkDescriptorImageInfo[count];
            var buffers = stackalloc VkDescriptorBufferInfo[count];
            var views = stackalloc ulong[count];
            for (var i = 0; i < count; i++)
            {
                writes[i] = new VkWriteDescriptorSet
                {
                    sType = Vk.VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                    dstSet = set,
                    dstBinding = bindings[i].Index,
                    descriptorCount = 1,
                    descriptorType = DescriptorLayouts.Type(bindings[i].Kind),
                    pImageInfo = &images[i],
                    pBufferInfo = &buffers[i],
                    pTexelBufferView = &views[i],
                };
                views[i] = bindings[i].Kind == BindingKind.TexelBuffer ? slots[i].Buffer.WordView : 0;
                slots[i].Describe(bindings[i].Kind, out images[i], out buffers[i]);
            }
            context.Device.Api.vkUpdateDescriptorSets(context.Device.Handle, (uint)count, writes, 0, null);
        }

        readonly void Describe(BindingKind kind, out VkDescriptorImageInfo image, out VkDescriptorBufferInfo buffer)
        {
            image = default;
            buffer = default;
            switch (kind)
            {
                case BindingKind.Texture or BindingKind.SampledTexture:
                    image.imageView = Texture.Image.SampledView;
                    image.imageLayout = Vk.VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
                    image.sampler = Sampler;
                    break;
                case BindingKind.RandomWriteTexture:
                    image.imageView = Texture.Image.StorageView(Mip);
                    image.imageLayout = Vk.VK_IMAGE_LAYOUT_GENERAL;
                    break;
                case BindingKind.Sampler:
                    image.sampler = Sampler;
                    break;
                case BindingKind.TexelBuffer:
                    break;
                default:
                    buffer = new VkDescriptorBufferInfo { buffer = Buffer.Handle, offset = Offset, range = Range };
                    break;
            }
        }
    }
}
