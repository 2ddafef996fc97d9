using System.Runtime.InteropServices;

#pragma warning disable CS0649 // zero unless set

namespace UnityEngine.Vulkan
{
    // Render passes, framebuffers and graphics pipelines. Names and layouts as in vulkan_core.h; enums are plain integers, handles nint or ulong.

    [StructLayout(LayoutKind.Sequential)]
    struct VkAttachmentDescription
    {
        public uint flags;
        public uint format;
        public uint samples;
        public uint loadOp;
        public uint storeOp;
        public uint stencilLoadOp;
        public uint stencilStoreOp;
        public uint initialLayout;
        public uint finalLayout;
    }

    [StructLayout(LayoutKind.Sequential)]
    struct VkAttachmentReference
    {
        public uint attachment;
        public uint layout;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkSubpassDescription
    {
        public uint flags;
        public uint pipelineBindPoint;
        public uint inputAttachmentCount;
        public VkAttachmentReference* pInputAttachments;
        public uint colorAttachmentCount;
        public VkAttachmentReference* pColorAttachments;
        public VkAttachmentReference* pResolveAttachments;
        public VkAttachmentReference* pDepthStencilAttachment;
        public uint preserveAttachmentCount;
        public uint* pPreserveAttachments;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkRenderPassCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint attachmentCount;
        public VkAttachmentDescription* pAttachments;
        public uint subpassCount;
        public VkSubpassDescription* pSubpasses;
        public uint dependencyCount;
        public void* pDependencies;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkRenderPassMultiviewCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint subpassCount;
        public uint* pViewMasks;
        public uint dependencyCount;
        public int* pViewOffsets;
        public uint correlationMaskCount;
        public uint* pCorrelationMasks;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPhysicalDeviceMultiviewFeatures
    {
        public uint sType;
        public void* pNext;
        public uint multiview;
        public uint multiviewGeometryShader;
        public uint multiviewTessellationShader;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkFramebufferCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public ulong renderPass;
        public uint attachmentCount;
        public ulong* pAttachments;
        public uint width;
        public uint height;
        public uint layers;
    }

    [StructLayout(LayoutKind.Sequential)]
    struct VkRect2D
    {
        public int x;
        public int y;
        public uint width;
        public uint height;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkRenderPassBeginInfo
    {
        public uint sType;
        public void* pNext;
        public ulong renderPass;
        public ulong framebuffer;
        public VkRect2D renderArea;
        public uint clearValueCount;
        public void* pClearValues;
    }

    [StructLayout(LayoutKind.Sequential)]
    struct VkViewport
    {
        public float x;
        public float y;
        public float width;
        public float height;
        public float minDepth;
        public float maxDepth;
    }

    [StructLayout(LayoutKind.Sequential)]
    struct VkClearDepthStencilValue
    {
        public float depth;
        public uint stencil;
    }

    [StructLayout(LayoutKind.Explicit)]
    struct VkClearValue
    {
        [FieldOffset(0)] public VkClearColorValue color;
        [FieldOffset(0)] public VkClearDepthStencilValue depthStencil;
    }

    [StructLayout(LayoutKind.Sequential)]
    struct VkClearAttachment
    {
        public uint aspectMask;
        public uint colorAttachment;
        public VkClearValue clearValue;
    }

    [StructLayout(LayoutKind.Sequential)]
    struct VkClearRect
    {
        public VkRect2D rect;
        public uint baseArrayLayer;
        public uint layerCount;
    }

    [StructLayout(LayoutKind.Sequential)]
    struct VkVertexInputBindingDescription
    {
        public uint binding;
        public uint stride;
        public uint inputRate;
    }

    [StructLayout(LayoutKind.Sequential)]
    struct VkVertexInputAttributeDescription
    {
        public uint location;
        public uint binding;
        public uint format;
        public uint offset;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPipelineVertexInputStateCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint vertexBindingDescriptionCount;
        public VkVertexInputBindingDescription* pVertexBindingDescriptions;
        public uint vertexAttributeDescriptionCount;
        public VkVertexInputAttributeDescription* pVertexAttributeDescriptions;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPipelineInputAssemblyStateCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint topology;
        public uint primitiveRestartEnable;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPipelineViewportStateCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint viewportCount;
        public VkViewport* pViewports;
        public uint scissorCount;
        public VkRect2D* pScissors;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPipelineRasterizationStateCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint depthClampEnable;
        public uint rasterizerDiscardEnable;
        public uint polygonMode;
        public uint cullMode;
        public uint frontFace;
        public uint depthBiasEnable;
        public float depthBiasConstantFactor;
        public float depthBiasClamp;
        public float depthBiasSlopeFactor;
        public float lineWidth;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPipelineMultisampleStateCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint rasterizationSamples;
        public uint sampleShadingEnable;
        public float minSampleShading;
        public uint* pSampleMask;
        public uint alphaToCoverageEnable;
        public uint alphaToOneEnable;
    }

    [StructLayout(LayoutKind.Sequential)]
    struct VkStencilOpState
    {
        public uint failOp;
        public uint passOp;
        public uint depthFailOp;
        public uint compareOp;
        public uint compareMask;
        public uint writeMask;
        public uint reference;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPipelineDepthStencilStateCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint depthTestEnable;
        public uint depthWriteEnable;
        public uint depthCompareOp;
        public uint depthBoundsTestEnable;
        public uint stencilTestEnable;
        public VkStencilOpState front;
        public VkStencilOpState back;
        public float minDepthBounds;
        public float maxDepthBounds;
    }

    [StructLayout(LayoutKind.Sequential)]
    struct VkPipelineColorBlendAttachmentState
    {
        public uint blendEnable;
        public uint srcColorBlendFactor;
        public uint dstColorBlendFactor;
        public uint colorBlendOp;
        public uint srcAlphaBlendFactor;
        public uint dstAlphaBlendFactor;
        public uint alphaBlendOp;
        public uint colorWriteMask;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPipelineColorBlendStateCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint logicOpEnable;
        public uint logicOp;
        public uint attachmentCount;
        public VkPipelineColorBlendAttachmentState* pAttachments;
        public fixed float blendConstants[4];
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkPipelineDynamicStateCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint dynamicStateCount;
        public uint* pDynamicStates;
    }

    [StructLayout(LayoutKind.Sequential)]
    unsafe struct VkGraphicsPipelineCreateInfo
    {
        public uint sType;
        public void* pNext;
        public uint flags;
        public uint stageCount;
        public VkPipelineShaderStageCreateInfo* pStages;
        public VkPipelineVertexInputStateCreateInfo* pVertexInputState;
        public VkPipelineInputAssemblyStateCreateInfo* pInputAssemblyState;
        public void* pTessellationState;
        public VkPipelineViewportStateCreateInfo* pViewportState;
        public VkPipelineRasterizationStateCreateInfo* pRasterizationState;
        public VkPipelineMultisampleStateCreateInfo* pMultisampleState;
        public VkPipelineDepthStencilStateCreateInfo* pDepthStencilState;
        public VkPipelineColorBlendStateCreateInfo* pColorBlendState;
        public VkPipelineDynamicStateCreateInfo* pDynamicState;
        public ulong layout;
        public ulong renderPass;
        public uint subpass;
        public ulong basePipelineHandle;
        public int basePipelineIndex;
    }
}
