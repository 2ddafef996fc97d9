using System;
using System.Collections.Generic;
using System.Text;

namespace UnityEngine.Vulkan
{
    /// <summary>One render pass per combination of formats, sample count and views. All of them load and store: a clear is a command.</summary>
    sealed unsafe class RenderPassCache : IDisposable
    {
        readonly VulkanDevice m_Device;
        readonly Dictionary<string, ulong> m_Passes = new();

        internal RenderPassCache(VulkanDevice device) => m_Device = device;

        internal ulong Get(PassTarget target)
        {
            if (target.RenderPass != 0)
                return target.RenderPass;
            var key = Key(target);
            if (!m_Passes.TryGetValue(key, out var pass))
            {
                pass = Create(target);
                m_Passes.Add(key, pass);
            }
            target.RenderPass = pass;
            return pass;
        }

        public void Dispose()
        {
            foreach (var pass in m_Passes.Values)
                m_Device.Draw.vkDestroyRenderPass(m_Device.Handle, pass, null);
            m_Passes.Clear();
        }

        static string Key(PassTarget target)
        {
            var text = new StringBuilder();
            foreach (var color in target.Colors)
                text.Append(target.FormatOf(color)).Append(' ');
            text.Append(target.Resolves.Length > 0 ? "resolved " : "").Append(target.Depth?.Format ?? 0).Append(" x").Append(target.Samples).Append(" v")
                .Append(target.ViewMask);
            return text.ToString();
        }

        ulong Create(PassTarget target)
        {
            var colors = target.Colors.Length;
            var attachments = stackalloc VkAttachmentDescription[2 * colors + 1];
            var colorReferences = stackalloc VkAttachmentReference[colors + 1];
            var resolveReferences = stackalloc VkAttachmentReference[colors + 1];
            uint count = 0;
            for (var i = 0; i < colors; i++)
                colorReferences[i] = Attach(attachments, ref count, target, target.Colors[i], Vk.VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
            for (var i = 0; i < target.Resolves.Length; i++)
                resolveReferences[i] = Attach(attachments, ref count, target, target.Resolves[i], Vk.VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
            VkAttachmentReference depth = default;
            if (target.Depth != null)
                depth = Attach(attachments, ref count, target, target.Depth, Vk.VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL);
            var subpass = new VkSubpassDescription
            {
                pipelineBindPoint = Vk.VK_PIPELINE_BIND_POINT_GRAPHICS,
                colorAttachmentCount = (uint)colors,
                pColorAttachments = colorReferences,
                pResolveAttachments = target.Resolves.Length > 0 ? resolveReferences : null,
                pDepthStencilAttachment = target.Depth != null ? &depth : null,
            };
            var mask = target.ViewMask;
            var views = new VkRenderPassMultiviewCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_RENDER_PASS_MULTIVIEW_CREATE_INFO,
                subpassCount = 1,
                pViewMasks = &mask,
                correlationMaskCount = 1,
                pCorrelationMasks = &mask,
            };
            var info = new VkRenderPassCreateInfo
            {
                sType = Vk.VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO,
                pNext = mask != 0 ? &views : null,
                attachmentCount = count,
                pAttachments = attachments,
                subpassCount = 1,
                pSubpasses = &subpass,
            };
            ulong pass;
            VulkanException.Check(m_Device.Draw.vkCreateRenderPass(m_Device.Handle, &info, null, &pass), "vkCreateRenderPass");
            return pass;
        }

        static VkAttachmentReference Attach(VkAttachmentDescription* attachments, ref uint count, PassTarget target, VulkanImage image,
            uint layout)
        {
            attachments[count] = new VkAttachmentDescription
            {
                format = target.FormatOf(image),
                samples = (uint)image.Samples,
                loadOp = Vk.VK_ATTACHMENT_LOAD_OP_LOAD,
                storeOp = Vk.VK_ATTACHMENT_STORE_OP_STORE,
                stencilLoadOp = Vk.VK_ATTACHMENT_LOAD_OP_LOAD,
                stencilStoreOp = Vk.VK_ATTACHMENT_STORE_OP_STORE,
                initialLayout = layout,
                finalLayout = layout,
            };
            return new VkAttachmentReference { attachment = count++, layout = layout };
        }
    }
}
