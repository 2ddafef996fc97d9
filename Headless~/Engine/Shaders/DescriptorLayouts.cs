using System.Collections.Generic;
using UnityEngine.Vulkan;

namespace UnityEngine.Shaders
{
    /// <summary>What programs of all kinds make of their bindings and their code on a device.</summary>
    static unsafe class DescriptorLayouts
    {
        internal static uint Type(BindingKind kind) => kind switch
        {
            BindingKind.Texture => Vk.VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE,
            BindingKind.SampledTexture => Vk.VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
            BindingKind.RandomWriteTexture => Vk.VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,
            BindingKind.Sampler => Vk.VK_DESCRIPTOR_TYPE_SAMPLER,
            BindingKind.ConstantBuffer => Vk.VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
            BindingKind.TexelBuffer => Vk.VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER,
            _ => Vk.VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
        };

        internal static ulong CreateSet(VulkanDevice device, IReadOnlyList<KernelBinding> bindings, uint stages)
        {
            var described = new VkDescriptorSetLayoutBinding[bindings.Count];
            for (var i = 0; i < described.Length; i++)
            {
                described[i] = new VkDescriptorSetLayoutBinding
                {
                    binding = bindings[i].Index,
                    descriptorType = Type(bindings[i].Kind),
                    descriptorCount = 1,
                    stageFlags = stages,
                };
            }
            ulong handle;
            fixed (VkDescriptorSetLayoutBinding* p = described)
            {
                var info = new VkDescriptorSetLayoutCreateInfo
                {
                    sType = Vk.VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                    bindingCount = (uint)described.Length,
                    pBindings = p,
                };
                VulkanException.Check(device.Api.vkCreateDescriptorSetLayout(device.Handle, &info, null, &handle), "vkCreateDescriptorSetLayout");
            }
            return handle;
        }

        internal static ulong CreatePipeline(VulkanDevice device, params ulong[] sets)
        {
            ulong handle;
            fixed (ulong* p = sets)
            {
                var info = new VkPipelineLayoutCreateInfo
                {
                    sType = Vk.VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                    setLayoutCount = (uint)sets.Length,
                    pSetLayouts = p,
                };
                VulkanException.Check(device.Api.vkCreatePipelineLayout(device.Handle, &info, null, &handle), "vkCreatePipelineLayout");
            }
            return handle;
        }

        internal static ulong CreateModule(VulkanDevice device, byte[] spirv)
        {
            ulong module;
            fixed (byte* code = spirv)
            {
                var info = new VkShaderModuleCreateInfo
                {
                    sType = Vk.VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                    codeSize = (nuint)spirv.Length,
                    pCode = (uint*)code,
                };
                VulkanException.Check(device.Api.vkCreateShaderModule(device.Handle, &info, null, &module), "vkCreateShaderModule");
            }
            return module;
        }
    }
}
