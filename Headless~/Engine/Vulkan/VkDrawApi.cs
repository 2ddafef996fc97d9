namespace UnityEngine.Vulkan
{
    /// <summary>Functions of a device that drawing needs.</summary>
    sealed unsafe class VkDrawApi
    {
        public readonly delegate* unmanaged[Cdecl]<nint, VkRenderPassCreateInfo*, void*, ulong*, int> vkCreateRenderPass;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroyRenderPass;
        public readonly delegate* unmanaged[Cdecl]<nint, VkFramebufferCreateInfo*, void*, ulong*, int> vkCreateFramebuffer;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroyFramebuffer;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, uint, VkGraphicsPipelineCreateInfo*, void*, ulong*, int> vkCreateGraphicsPipelines;
        public readonly delegate* unmanaged[Cdecl]<nint, VkRenderPassBeginInfo*, uint, void> vkCmdBeginRenderPass;
        public readonly delegate* unmanaged[Cdecl]<nint, void> vkCmdEndRenderPass;
        public readonly delegate* unmanaged[Cdecl]<nint, uint, uint, VkViewport*, void> vkCmdSetViewport;
        public readonly delegate* unmanaged[Cdecl]<nint, uint, uint, VkRect2D*, void> vkCmdSetScissor;
        public readonly delegate* unmanaged[Cdecl]<nint, float, float, float, void> vkCmdSetDepthBias;
        public readonly delegate* unmanaged[Cdecl]<nint, uint, uint, ulong*, ulong*, void> vkCmdBindVertexBuffers;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, ulong, uint, void> vkCmdBindIndexBuffer;
        public readonly delegate* unmanaged[Cdecl]<nint, uint, uint, uint, uint, void> vkCmdDraw;
        public readonly delegate* unmanaged[Cdecl]<nint, uint, uint, uint, int, uint, void> vkCmdDrawIndexed;
        public readonly delegate* unmanaged[Cdecl]<nint, uint, VkClearAttachment*, uint, VkClearRect*, void> vkCmdClearAttachments;
        public readonly delegate* unmanaged[Cdecl]<
            nint, ulong, uint, VkClearDepthStencilValue*, uint, VkImageSubresourceRange*, void> vkCmdClearDepthStencilImage;

        public VkDrawApi(System.Func<string, nint> load)
        {
            vkCreateRenderPass = (delegate* unmanaged[Cdecl]<nint, VkRenderPassCreateInfo*, void*, ulong*, int>)load("vkCreateRenderPass");
            vkDestroyRenderPass = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroyRenderPass");
            vkCreateFramebuffer = (delegate* unmanaged[Cdecl]<nint, VkFramebufferCreateInfo*, void*, ulong*, int>)load("vkCreateFramebuffer");
            vkDestroyFramebuffer = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroyFramebuffer");
            vkCreateGraphicsPipelines =
                (delegate* unmanaged[Cdecl]<nint, ulong, uint, VkGraphicsPipelineCreateInfo*, void*, ulong*, int>)load("vkCreateGraphicsPipelines");
            vkCmdBeginRenderPass = (delegate* unmanaged[Cdecl]<nint, VkRenderPassBeginInfo*, uint, void>)load("vkCmdBeginRenderPass");
            vkCmdEndRenderPass = (delegate* unmanaged[Cdecl]<nint, void>)load("vkCmdEndRenderPass");
            vkCmdSetViewport = (delegate* unmanaged[Cdecl]<nint, uint, uint, VkViewport*, void>)load("vkCmdSetViewport");
            vkCmdSetScissor = (delegate* unmanaged[Cdecl]<nint, uint, uint, VkRect2D*, void>)load("vkCmdSetScissor");
            vkCmdSetDepthBias = (delegate* unmanaged[Cdecl]<nint, float, float, float, void>)load("vkCmdSetDepthBias");
            vkCmdBindVertexBuffers = (delegate* unmanaged[Cdecl]<nint, uint, uint, ulong*, ulong*, void>)load("vkCmdBindVertexBuffers");
            vkCmdBindIndexBuffer = (delegate* unmanaged[Cdecl]<nint, ulong, ulong, uint, void>)load("vkCmdBindIndexBuffer");
            vkCmdDraw = (delegate* unmanaged[Cdecl]<nint, uint, uint, uint, uint, void>)load("vkCmdDraw");
            vkCmdDrawIndexed = (delegate* unmanaged[Cdecl]<nint, uint, uint, uint, int, uint, void>)load("vkCmdDrawIndexed");
            vkCmdClearAttachments =
                (delegate* unmanaged[Cdecl]<nint, uint, VkClearAttachment*, uint, VkClearRect*, void>)load("vkCmdClearAttachments");
            vkCmdClearDepthStencilImage = (delegate* unmanaged[Cdecl]<nint, ulong, uint, VkClearDepthStencilValue*, uint, VkImageSubresourceRange*,
                void>)load("vkCmdClearDepthStencilImage");
        }
    }
}
