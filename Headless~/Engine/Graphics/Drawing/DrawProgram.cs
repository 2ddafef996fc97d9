using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Rendering;
using UnityEngine.Shaders;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>Both stages of a pass on a device, and a pipeline for each combination of states, target and mesh layout that was drawn.</summary>
    sealed unsafe class DrawProgram : IDisposable
    {
        readonly VulkanDevice m_Device;
        readonly PassVariant m_Variant;
        readonly Dictionary<(ulong State, ulong RenderPass, int Layout, MeshTopology Topology, bool Clockwise), ulong> m_Pipelines = new();
        ulong m_Vertex;
        ulong m_Fragment;

        internal DrawProgram(GpuContext context, PassVariant variant)
        {
            Context = context;
            m_Device = context.Device;
            m_Variant = variant;
            try
            {
                VertexSetLayout = DescriptorLayouts.CreateSet(m_Device, variant.VertexBindings, Vk.VK_SHADER_STAGE_VERTEX_BIT);
                FragmentSetLayout = DescriptorLayouts.CreateSet(m_Device, variant.FragmentBindings, Vk.VK_SHADER_STAGE_FRAGMENT_BIT);
                PipelineLayout = DescriptorLayouts.CreatePipeline(m_Device, VertexSetLayout, FragmentSetLayout);
                m_Vertex = DescriptorLayouts.CreateModule(m_Device, variant.VertexCode);
                m_Fragment = DescriptorLayouts.CreateModule(m_Device, variant.FragmentCode);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        internal GpuContext Context { get; }

        internal ulong VertexSetLayout { get; private set; }

        internal ulong FragmentSetLayout { get; private set; }

        internal ulong PipelineLayout { get; private set; }

        /// <summary>Whether drawing a mesh of that layout reads attributes that it does not have.</summary>
        internal bool NeedsDefaults(MeshLayout layout) =>
            m_Variant.VertexInputs.Any(i => !layout.TryGet(MeshLayout.Attribute(i.Semantic), out _, out _, out _));

        /// <summary>The pipeline, made at its first use.</summary>
        internal ulong Pipeline(in DrawState state, PassTarget target, MeshLayout layout, MeshTopology topology, bool clockwise)
        {
            var key = (state.Key, Context.Stream.RenderPass(target), layout.Id, topology, clockwise);
            if (!m_Pipelines.TryGetValue(key, out var pipeline))
            {
                pipeline = Create(state, target, layout, topology, clockwise);
                m_Pipelines.Add(key, pipeline);
            }
            return pipeline;
        }

        public void Dispose()
        {
            foreach (var pipeline in m_Pipelines.Values)
                m_Device.Api.vkDestroyPipeline(m_Device.Handle, pipeline, null);
            m_Pipelines.Clear();
            if (m_Vertex != 0)
                m_Device.Api.vkDestroyShaderModule(m_Device.Handle, m_Vertex, null);
            if (m_Fragment != 0)
                m_Device.Api.vkDestroyShaderModule(m_Device.Handle, m_Fragment, null);
            if (PipelineLayout != 0)
                m_Device.Api.vkDestroyPipelineLayout(m_Device.Handle, PipelineLayout, null);
            if (VertexSetLayout != 0)
                m_Device.Api.vkDestroyDescriptorSetLayout(m_Device.Handle, VertexSetLayout, null);
            if (FragmentSetLayout != 0)
                m_Device.Api.vkDestroyDescriptorSetLayout(m_Device.Handle, FragmentSetLayout, null);
            m_Vertex = m_Fragment = PipelineLayout = VertexSetLayout = FragmentSetLayout = 0;
        }

        ulong Create(in DrawState state, PassTarget target, MeshLayout layout, MeshTopology topology, bool clockwise)
        {
            using var text = new NativeText();
            var stages = stackalloc VkPipelineShaderStageCreateInfo[]
            {
                Stage(Vk.VK_SHADER_STAGE_VERTEX_BIT, m_Vertex, text.Add(m_Variant.VertexEntry)),
                Stage(Vk.VK_SHADER_STAGE_FRAGMENT_BIT, m_Fragment, text.Add(m_Variant.FragmentEntry)),
            };
            var bindings = stackalloc VkVertexInputBindingDescription[]
            {
                new VkVertexInputBindingDescription { binding = 0, stride = (uint)layout.Stride, inputRate = Vk.VK_VERTEX_INPUT_RATE_VERTEX },
                new VkVertexInputBindingDescription { binding = 1, stride = 0, inputRate = Vk.VK_VERTEX_INPUT_RATE_VERTEX },
            };
            var attributes = stackalloc VkVertexInputAttributeDescription[m_Variant.VertexInputs.Count + 1];
            Attributes(layout, attributes);
            var vertexInput = new VkPipelineVertexInputStateCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
                vertexBindingDescriptionCount = m_Variant.VertexInputs.Count == 0 ? 0u : NeedsDefaults(layout) ? 2u : 1u,
                pVertexBindingDescriptions = bindings,
                vertexAttributeDescriptionCount = (uint)m_Variant.VertexInputs.Count,
                pVertexAttributeDescriptions = attributes,
            };
            var assembly = new VkPipelineInputAssemblyStateCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
                topology = Topology(topology),
            };
            var viewport = new VkPipelineViewportStateCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
                viewportCount = 1,
                scissorCount = 1,
            };
            var rasterization = new VkPipelineRasterizationStateCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
                depthClampEnable = !state.ZClip && m_Device.Abilities.HasDepthClamp ? 1u : 0u,
                polygonMode = Vk.VK_POLYGON_MODE_FILL,
                cullMode = state.CullMode,
                frontFace = clockwise ? Vk.VK_FRONT_FACE_CLOCKWISE : Vk.VK_FRONT_FACE_COUNTER_CLOCKWISE,
                depthBiasEnable = 1,
                lineWidth = 1,
            };
            var multisample = new VkPipelineMultisampleStateCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
                rasterizationSamples = (uint)target.Samples,
                alphaToCoverageEnable = state.AlphaToMask && target.Samples > 1 ? 1u : 0u,
            };
            var depth = state.DepthStencil;
            var blends = stackalloc VkPipelineColorBlendAttachmentState[target.Colors.Length + 1];
            for (var i = 0; i < target.Colors.Length; i++)
                blends[i] = state.Blend(i < m_Variant.TargetCount, IsInteger(target.Colors[i].Format));
            var blend = new VkPipelineColorBlendStateCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
                attachmentCount = (uint)target.Colors.Length,
                pAttachments = blends,
            };
            var dynamics = stackalloc uint[] { Vk.VK_DYNAMIC_STATE_VIEWPORT, Vk.VK_DYNAMIC_STATE_SCISSOR, Vk.VK_DYNAMIC_STATE_DEPTH_BIAS };
            var dynamic = new VkPipelineDynamicStateCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
                dynamicStateCount = 3,
                pDynamicStates = dynamics,
            };
            var info = new VkGraphicsPipelineCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                stageCount = 2,
                pStages = stages,
                pVertexInputState = &vertexInput,
                pInputAssemblyState = &assembly,
                pViewportState = &viewport,
                pRasterizationState = &rasterization,
                pMultisampleState = &multisample,
                pDepthStencilState = &depth,
                pColorBlendState = &blend,
                pDynamicState = &dynamic,
                layout = PipelineLayout,
                renderPass = Context.Stream.RenderPass(target),
                basePipelineIndex = -1,
            };
            ulong pipeline;
            VulkanException.Check(m_Device.Draw.vkCreateGraphicsPipelines(m_Device.Handle, Context.Pipelines.Handle, 1, &info, null, &pipeline),
                "vkCreateGraphicsPipelines");
            return pipeline;
        }

        void Attributes(MeshLayout layout, VkVertexInputAttributeDescription* attributes)
        {
            for (var i = 0; i < m_Variant.VertexInputs.Count; i++)
            {
                var input = m_Variant.VertexInputs[i];
                var attribute = MeshLayout.Attribute(input.Semantic);
                var has = layout.TryGet(attribute, out var format, out var offset, out var integer);
                if (has && integer != (input.Number != NumberKind.Float))
                    throw new NotSupportedException($"the vertex stage reads {input.Semantic} as {input.Number}, but the mesh has {layout}");
                attributes[i] = new VkVertexInputAttributeDescription { location = input.Location, binding = has ? 0u : 1u };
                attributes[i].format = has ? format : DefaultVertex.Format(input.Number);
                attributes[i].offset = has ? (uint)offset : DefaultVertex.Offset(attribute, input.Number);
            }
        }

        static VkPipelineShaderStageCreateInfo Stage(uint stage, ulong module, byte* entry) => new()
        {
            sType = Vk.VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
            stage = stage,
            module = module,
            pName = entry,
        };

        static uint Topology(MeshTopology topology) => topology switch
        {
            MeshTopology.Triangles or MeshTopology.Quads => Vk.VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST,
            MeshTopology.Lines => Vk.VK_PRIMITIVE_TOPOLOGY_LINE_LIST,
            MeshTopology.LineStrip => Vk.VK_PRIMITIVE_TOPOLOGY_LINE_STRIP,
            MeshTopology.Points => Vk.VK_PRIMITIVE_TOPOLOGY_POINT_LIST,
            _ => throw new ArgumentOutOfRangeException(nameof(topology), topology, "no topology"),
        };

        // The integer formats of vulkan_core.h among those that can be drawn to.
        static bool IsInteger(uint format) =>
            format is 13 or 14 or 20 or 21 or 41 or 42 or 48 or 49 or 74 or 75 or 81 or 82 or 95 or 96 or 98 or 99 or 101 or 102 or 107 or 108;
    }

    /// <summary>What a vertex stage reads of an attribute that the mesh lacks: white for colours, otherwise zeros with w = 1.</summary>
    static class DefaultVertex
    {
        internal static readonly float[] Values = { 0f, 0f, 0f, 1f, 1f, 1f, 1f, 1f, 0f, 0f, 0f, 0f };

        internal static uint Offset(VertexAttribute attribute, NumberKind number) =>
            number != NumberKind.Float ? 32u : attribute == VertexAttribute.Color ? 16u : 0u;

        // Of four components: R32G32B32A32 as float, signed or unsigned.
        internal static uint Format(NumberKind number) => number switch { NumberKind.UInt => 107, NumberKind.Int => 108, _ => 109 };
    }
}
