using System;
using System.Collections.Generic;

namespace UnityEngine.Vulkan
{
    /// <summary>One draw, ready to be recorded. Handles that are 0 are not there.</summary>
    struct DrawCommand
    {
        internal ulong Pipeline;

        /// <summary>The same for the second view where views take turns.</summary>
        internal ulong SecondPipeline;
        internal ulong PipelineLayout;
        internal ulong VertexSet;
        internal ulong FragmentSet;
        internal VkViewport Viewport;
        internal VkRect2D Scissor;
        internal float DepthBias;
        internal float SlopeBias;

        /// <summary>The mesh's vertices; null if the shader makes its own.</summary>
        internal VulkanBuffer Vertices;

        /// <summary>What a mesh lacks; null if it lacks nothing.</summary>
        internal VulkanBuffer Defaults;

        /// <summary>Null for a draw without.</summary>
        internal VulkanBuffer Indices;
        internal uint IndexType;
        internal uint First;
        internal uint Count;
        internal int BaseVertex;
        internal uint Instances;
    }

    /// <summary>What to clear, in a rectangle of all layers.</summary>
    struct ClearCommand
    {
        internal bool Color;
        internal bool Depth;
        internal bool Stencil;
        internal VkClearColorValue ColorValue;
        internal float DepthValue;
        internal uint StencilValue;
        internal VkRect2D Area;
    }

    /// <summary>
    /// Draws and clears of one target that gather until something else is to be done: then all that they read is announced, and they are
    /// recorded as one render pass, inside which there can be no barrier.
    /// </summary>
    sealed unsafe class DrawPass
    {
        readonly VulkanDevice m_Device;
        readonly RenderPassCache m_RenderPasses;
        readonly List<(bool IsClear, int Index)> m_Order = new();
        readonly List<DrawCommand> m_Draws = new();
        readonly List<ClearCommand> m_Clears = new();
        readonly HashSet<VulkanResource> m_Reads = new();

        internal DrawPass(VulkanDevice device, RenderPassCache renderPasses)
        {
            m_Device = device;
            m_RenderPasses = renderPasses;
        }

        /// <summary>Null while no pass is open.</summary>
        internal PassTarget Target { get; private set; }

        internal void Begin(PassTarget target) => Target = target;

        /// <summary>Says that the next draw reads a buffer, or an image in the layout for shaders.</summary>
        internal void Read(VulkanResource resource, ulong serial)
        {
            m_Reads.Add(resource);
            resource.LastUse = serial;
        }

        internal void Add(in DrawCommand draw)
        {
            m_Order.Add((false, m_Draws.Count));
            m_Draws.Add(draw);
        }

        internal void Add(in ClearCommand clear)
        {
            m_Order.Add((true, m_Clears.Count));
            m_Clears.Add(clear);
        }

        /// <summary>Records everything and ends the pass.</summary>
        internal void Record(CommandStream stream, Submission submission)
        {
            var target = Target;
            Target = null;
            foreach (var resource in m_Reads)
            {
                if (resource is VulkanImage image)
                    stream.Read(image, Vk.VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
                else
                    stream.Read((VulkanBuffer)resource);
            }
            foreach (var color in target.Colors)
                stream.Write(color, Vk.VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
            foreach (var resolve in target.Resolves)
                stream.Write(resolve, Vk.VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
            if (target.Depth != null)
                stream.Write(target.Depth, Vk.VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL);
            var commands = stream.Command();
            for (var i = 0; i < target.Passes.Length; i++)
                Record(commands, submission, target.Passes[i], i == 1);
            m_Order.Clear();
            m_Draws.Clear();
            m_Clears.Clear();
            m_Reads.Clear();
        }

        void Record(nint commands, Submission submission, PassTarget target, bool second)
        {
            var framebuffer = new Framebuffer(m_Device, target, m_RenderPasses.Get(target));
            submission.Garbage.Add(framebuffer);
            var begin = new VkRenderPassBeginInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO,
                renderPass = m_RenderPasses.Get(target),
                framebuffer = framebuffer.Handle,
                renderArea = new VkRect2D { width = (uint)target.Width, height = (uint)target.Height },
            };
            m_Device.Draw.vkCmdBeginRenderPass(commands, &begin, Vk.VK_SUBPASS_CONTENTS_INLINE);
            foreach (var (isClear, index) in m_Order)
            {
                if (isClear)
                    Record(commands, target, m_Clears[index]);
                else
                    Record(commands, m_Draws[index], second);
            }
            m_Device.Draw.vkCmdEndRenderPass(commands);
        }

        void Record(nint commands, in DrawCommand draw, bool second)
        {
            var (api, drawing) = (m_Device.Api, m_Device.Draw);
            api.vkCmdBindPipeline(commands, Vk.VK_PIPELINE_BIND_POINT_GRAPHICS, second ? draw.SecondPipeline : draw.Pipeline);
            var sets = stackalloc ulong[] { draw.VertexSet, draw.FragmentSet };
            api.vkCmdBindDescriptorSets(commands, Vk.VK_PIPELINE_BIND_POINT_GRAPHICS, draw.PipelineLayout, 0, 2, sets, 0, null);
            var viewport = draw.Viewport;
            drawing.vkCmdSetViewport(commands, 0, 1, &viewport);
            var scissor = draw.Scissor;
            drawing.vkCmdSetScissor(commands, 0, 1, &scissor);
            drawing.vkCmdSetDepthBias(commands, draw.DepthBias, 0, draw.SlopeBias);
            Bind(commands, 0, draw.Vertices);
            Bind(commands, 1, draw.Defaults);
            if (draw.Indices == null)
            {
                drawing.vkCmdDraw(commands, draw.Count, draw.Instances, draw.First, 0);
                return;
            }
            drawing.vkCmdBindIndexBuffer(commands, draw.Indices.Handle, 0, draw.IndexType);
            drawing.vkCmdDrawIndexed(commands, draw.Count, draw.Instances, draw.First, draw.BaseVertex, 0);
        }

        void Bind(nint commands, uint binding, VulkanBuffer buffer)
        {
            if (buffer == null)
                return;
            var handle = buffer.Handle;
            ulong offset = 0;
            m_Device.Draw.vkCmdBindVertexBuffers(commands, binding, 1, &handle, &offset);
        }

        void Record(nint commands, PassTarget target, in ClearCommand clear)
        {
            var attachments = stackalloc VkClearAttachment[target.Colors.Length + 1];
            uint count = 0;
            if (clear.Color)
                for (var i = 0; i < target.Colors.Length; i++)
                {
                    attachments[count] = new VkClearAttachment { aspectMask = Vk.VK_IMAGE_ASPECT_COLOR_BIT, colorAttachment = (uint)i };
                    attachments[count++].clearValue.color = clear.ColorValue;
                }
            if (target.Depth != null)
            {
                var aspects = (clear.Depth ? Vk.VK_IMAGE_ASPECT_DEPTH_BIT : 0) | (clear.Stencil ? Vk.VK_IMAGE_ASPECT_STENCIL_BIT : 0);
                aspects &= target.Depth.Aspects;
                if (aspects != 0)
                {
                    attachments[count] = new VkClearAttachment { aspectMask = aspects };
                    attachments[count++].clearValue.depthStencil =
                        new VkClearDepthStencilValue { depth = clear.DepthValue, stencil = clear.StencilValue };
                }
            }
            if (count == 0)
                return;
            var area = new VkClearRect { rect = clear.Area, layerCount = (uint)target.FramebufferLayers };
            m_Device.Draw.vkCmdClearAttachments(commands, count, attachments, 1, &area);
        }

        /// <summary>A framebuffer that lives as long as the submission that uses it.</summary>
        sealed class Framebuffer : IDisposable
        {
            readonly VulkanDevice m_Device;

            internal Framebuffer(VulkanDevice device, PassTarget target, ulong renderPass)
            {
                m_Device = device;
                var views = stackalloc ulong[2 * target.Colors.Length + 1];
                uint count = 0;
                foreach (var color in target.Colors)
                    views[count++] = color.AttachmentView(target.Mip, target.Layer, target.Layers, target.FormatOf(color));
                foreach (var resolve in target.Resolves)
                    views[count++] = resolve.AttachmentView(target.Mip, target.Layer, target.Layers, target.FormatOf(resolve));
                if (target.Depth != null)
                    views[count++] = target.Depth.AttachmentView(target.Mip, target.Layer, target.Layers, target.Depth.Format);
                var info = new VkFramebufferCreateInfo
                {
                    sType = Vk.VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO,
                    renderPass = renderPass,
                    attachmentCount = count,
                    pAttachments = views,
                    width = (uint)target.Width,
                    height = (uint)target.Height,
                    layers = (uint)target.FramebufferLayers,
                };
                ulong handle;
                VulkanException.Check(device.Draw.vkCreateFramebuffer(device.Handle, &info, null, &handle), "vkCreateFramebuffer");
                Handle = handle;
            }

            internal ulong Handle { get; private set; }

            public void Dispose()
            {
                m_Device.Draw.vkDestroyFramebuffer(m_Device.Handle, Handle, null);
                Handle = 0;
            }
        }
    }
}
