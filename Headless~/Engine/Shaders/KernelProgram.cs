using System;
using UnityEngine.Vulkan;

namespace UnityEngine.Shaders
{
    /// <summary>A compiled kernel on a device: its pipeline and the shape of its descriptor set.</summary>
    sealed unsafe class KernelProgram : IDisposable
    {
        readonly VulkanDevice m_Device;

        internal KernelProgram(GpuContext context, KernelCode code)
        {
            Context = context;
            m_Device = context.Device;
            try
            {
                SetLayout = DescriptorLayouts.CreateSet(m_Device, code.Layout.Bindings, Vk.VK_SHADER_STAGE_COMPUTE_BIT);
                PipelineLayout = DescriptorLayouts.CreatePipeline(m_Device, SetLayout);
                Pipeline = CreatePipeline(code);
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

        ulong CreatePipeline(KernelCode code)
        {
            using var text = new NativeText();
            var module = DescriptorLayouts.CreateModule(m_Device, code.Spirv);
            ulong pipeline;
            var info = new VkComputePipelineCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                stage = new VkPipelineShaderStageCreateInfo
                {
                    sType = Vk.VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                    stage = Vk.VK_SHADER_STAGE_COMPUTE_BIT,
                    module = module,
                    pName = text.Add(code.Entry),
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
