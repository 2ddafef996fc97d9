using System;
using UnityEngine.Vulkan;

namespace UnityEngine.Shaders
{
    /// <summary>A compiled kernel on a device: its pipeline and the shape of its descriptor set.</summary>
    sealed unsafe class KernelProgram : IDisposable
    {
        readonly VulkanDevice m_Device;

        internal KernelProgram(GpuContext context, string kernel, byte[] spirv, KernelLayout layout)
        {
            Context = context;
            m_Device = context.Device;
            try
            {
                SetLayout = CreateSetLayout(layout);
                PipelineLayout = CreatePipelineLayout();
                Pipeline = CreatePipeline(kernel, spirv);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        internal GpuContext Context { get; }

        internal ulong SetLayout { get; private set; }

        internal ulong PipelineLayout { get; private set; }

        internal ulong Pipeline { get; private set; }

        internal static uint DescriptorType(BindingKind kind) => kind switch
        {
            BindingKind.Texture => Vk.VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE,
            BindingKind.RandomWriteTexture => Vk.VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,
            BindingKind.Sampler => Vk.VK_DESCRIPTOR_TYPE_SAMPLER,
            BindingKind.ConstantBuffer => Vk.VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
            _ => Vk.VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
        };

        public void Dispose()
        {
            if (Pipeline != 0)
                m_Device.Api.vkDestroyPipeline(m_Device.Handle, Pipeline, null);
            if (PipelineLayout != 0)
                m_Device.Api.vkDestroyPipelineLayout(m_Device.Handle, PipelineLayout, null);
            if (SetLayout != 0)
                m_Device.Api.vkDestroyDescriptorSetLayout(m_Device.Handle, SetLayout, null);
            Pipeline = PipelineLayout = SetLayout = 0;
        }

        ulong CreateSetLayout(KernelLayout layout)
        {
            var bindings = new VkDescriptorSetLayoutBinding[layout.Bindings.Count];
            for (var i = 0; i < bindings.Length; i++)
            {
                bindings[i] = new VkDescriptorSetLayoutBinding
                {
                    binding = layout.Bindings[i].Index,
                    descriptorType = DescriptorType(layout.Bindings[i].Kind),
                    descriptorCount = 1,
                    stageFlags = Vk.VK_SHADER_STAGE_COMPUTE_BIT,
                };
            }
            ulong handle;
            fixed (VkDescriptorSetLayoutBinding* p = bindings)
            {
                var info = new VkDescriptorSetLayoutCreateInfo
                {
                    sType = Vk.VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                    bindingCount = (uint)bindings.Length,
                    pBindings = p,
                };
                VulkanException.Check(m_Device.Api.vkCreateDescriptorSetLayout(m_Device.Handle, &info, null, &handle), "vkCreateDescriptorSetLayout");
            }
            return handle;
        }

        ulong CreatePipelineLayout()
        {
            var set = SetLayout;
            var info = new VkPipelineLayoutCreateInfo { sType = Vk.VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO, setLayoutCount = 1, pSetLayouts = &set };
            ulong handle;
            VulkanException.Check(m_Device.Api.vkCreatePipelineLayout(m_Device.Handle, &info, null, &handle), "vkCreatePipelineLayout");
            return handle;
        }

        ulong CreatePipeline(string kernel, byte[] spirv)
        {
            using var text = new NativeText();
            ulong module, pipeline;
            fixed (byte* code = spirv)
            {
                var moduleInfo = new VkShaderModuleCreateInfo
                {
                    sType = Vk.VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                    codeSize = (nuint)spirv.Length,
                    pCode = (uint*)code,
                };
                VulkanException.Check(m_Device.Api.vkCreateShaderModule(m_Device.Handle, &moduleInfo, null, &module), "vkCreateShaderModule");
            }
            var info = new VkComputePipelineCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                stage = new VkPipelineShaderStageCreateInfo
                {
                    sType = Vk.VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                    stage = Vk.VK_SHADER_STAGE_COMPUTE_BIT,
                    module = module,
                    pName = text.Add(kernel),
                },
                layout = PipelineLayout,
                basePipelineIndex = -1,
            };
            var result = m_Device.Api.vkCreateComputePipelines(m_Device.Handle, Context.Pipelines.Handle, 1, &info, null, &pipeline);
            m_Device.Api.vkDestroyShaderModule(m_Device.Handle, module, null);
            VulkanException.Check(result, "vkCreateComputePipelines");
            return pipeline;
        }
    }
}
