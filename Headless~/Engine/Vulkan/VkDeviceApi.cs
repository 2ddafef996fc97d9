namespace UnityEngine.Vulkan
{
    /// <summary>Functions of a device.</summary>
    sealed unsafe class VkDeviceApi
    {
        public readonly delegate* unmanaged[Cdecl]<nint, void*, void> vkDestroyDevice;
        public readonly delegate* unmanaged[Cdecl]<nint, uint, uint, nint*, void> vkGetDeviceQueue;
        public readonly delegate* unmanaged[Cdecl]<nint, int> vkDeviceWaitIdle;
        public readonly delegate* unmanaged[Cdecl]<nint, VkMemoryAllocateInfo*, void*, ulong*, int> vkAllocateMemory;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkFreeMemory;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, ulong, ulong, uint, void**, int> vkMapMemory;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void> vkUnmapMemory;
        public readonly delegate* unmanaged[Cdecl]<nint, VkBufferCreateInfo*, void*, ulong*, int> vkCreateBuffer;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroyBuffer;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, VkMemoryRequirements*, void> vkGetBufferMemoryRequirements;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, ulong, ulong, int> vkBindBufferMemory;
        public readonly delegate* unmanaged[Cdecl]<nint, VkImageCreateInfo*, void*, ulong*, int> vkCreateImage;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroyImage;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, VkMemoryRequirements*, void> vkGetImageMemoryRequirements;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, ulong, ulong, int> vkBindImageMemory;
        public readonly delegate* unmanaged[Cdecl]<nint, VkImageViewCreateInfo*, void*, ulong*, int> vkCreateImageView;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroyImageView;
        public readonly delegate* unmanaged[Cdecl]<nint, VkBufferViewCreateInfo*, void*, ulong*, int> vkCreateBufferView;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroyBufferView;
        public readonly delegate* unmanaged[Cdecl]<nint, VkSamplerCreateInfo*, void*, ulong*, int> vkCreateSampler;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroySampler;
        public readonly delegate* unmanaged[Cdecl]<nint, VkCommandPoolCreateInfo*, void*, ulong*, int> vkCreateCommandPool;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroyCommandPool;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, uint, int> vkResetCommandPool;
        public readonly delegate* unmanaged[Cdecl]<nint, VkCommandBufferAllocateInfo*, nint*, int> vkAllocateCommandBuffers;
        public readonly delegate* unmanaged[Cdecl]<nint, VkCommandBufferBeginInfo*, int> vkBeginCommandBuffer;
        public readonly delegate* unmanaged[Cdecl]<nint, int> vkEndCommandBuffer;
        public readonly delegate* unmanaged[Cdecl]<nint, uint, VkSubmitInfo*, ulong, int> vkQueueSubmit;
        public readonly delegate* unmanaged[Cdecl]<nint, VkFenceCreateInfo*, void*, ulong*, int> vkCreateFence;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroyFence;
        public readonly delegate* unmanaged[Cdecl]<nint, uint, ulong*, int> vkResetFences;
        public readonly delegate* unmanaged[Cdecl]<nint, uint, ulong*, uint, ulong, int> vkWaitForFences;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, int> vkGetFenceStatus;
        public readonly delegate* unmanaged[Cdecl]<
            nint, uint, uint, uint, uint, VkMemoryBarrier*, uint, VkBufferMemoryBarrier*, uint, VkImageMemoryBarrier*, void> vkCmdPipelineBarrier;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, ulong, uint, VkBufferCopy*, void> vkCmdCopyBuffer;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, uint, ulong, uint, uint, VkImageCopy*, void> vkCmdCopyImage;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, uint, ulong, uint, uint, VkImageBlit*, uint, void> vkCmdBlitImage;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, ulong, uint, uint, VkBufferImageCopy*, void> vkCmdCopyBufferToImage;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, uint, ulong, uint, VkBufferImageCopy*, void> vkCmdCopyImageToBuffer;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, ulong, ulong, uint, void> vkCmdFillBuffer;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, uint, VkClearColorValue*, uint, VkImageSubresourceRange*, void> vkCmdClearColorImage;
        public readonly delegate* unmanaged[Cdecl]<nint, uint, ulong, void> vkCmdBindPipeline;
        public readonly delegate* unmanaged[Cdecl]<nint, uint, ulong, uint, uint, ulong*, uint, uint*, void> vkCmdBindDescriptorSets;
        public readonly delegate* unmanaged[Cdecl]<nint, uint, uint, uint, void> vkCmdDispatch;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, ulong, void> vkCmdDispatchIndirect;
        public readonly delegate* unmanaged[Cdecl]<nint, VkDescriptorSetLayoutCreateInfo*, void*, ulong*, int> vkCreateDescriptorSetLayout;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroyDescriptorSetLayout;
        public readonly delegate* unmanaged[Cdecl]<nint, VkDescriptorPoolCreateInfo*, void*, ulong*, int> vkCreateDescriptorPool;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroyDescriptorPool;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, uint, int> vkResetDescriptorPool;
        public readonly delegate* unmanaged[Cdecl]<nint, VkDescriptorSetAllocateInfo*, ulong*, int> vkAllocateDescriptorSets;
        public readonly delegate* unmanaged[Cdecl]<nint, uint, VkWriteDescriptorSet*, uint, void*, void> vkUpdateDescriptorSets;
        public readonly delegate* unmanaged[Cdecl]<nint, VkPipelineLayoutCreateInfo*, void*, ulong*, int> vkCreatePipelineLayout;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroyPipelineLayout;
        public readonly delegate* unmanaged[Cdecl]<nint, VkShaderModuleCreateInfo*, void*, ulong*, int> vkCreateShaderModule;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroyShaderModule;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, uint, VkComputePipelineCreateInfo*, void*, ulong*, int> vkCreateComputePipelines;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroyPipeline;
        public readonly delegate* unmanaged[Cdecl]<nint, VkPipelineCacheCreateInfo*, void*, ulong*, int> vkCreatePipelineCache;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, void*, void> vkDestroyPipelineCache;
        public readonly delegate* unmanaged[Cdecl]<nint, ulong, nuint*, void*, int> vkGetPipelineCacheData;
        public readonly delegate* unmanaged[Cdecl]<nint, VkDebugUtilsObjectNameInfoEXT*, int> vkSetDebugUtilsObjectNameEXT;

        public VkDeviceApi(System.Func<string, nint> load)
        {
            vkDestroyDevice = (delegate* unmanaged[Cdecl]<nint, void*, void>)load("vkDestroyDevice");
            vkGetDeviceQueue = (delegate* unmanaged[Cdecl]<nint, uint, uint, nint*, void>)load("vkGetDeviceQueue");
            vkDeviceWaitIdle = (delegate* unmanaged[Cdecl]<nint, int>)load("vkDeviceWaitIdle");
            vkAllocateMemory = (delegate* unmanaged[Cdecl]<nint, VkMemoryAllocateInfo*, void*, ulong*, int>)load("vkAllocateMemory");
            vkFreeMemory = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkFreeMemory");
            vkMapMemory = (delegate* unmanaged[Cdecl]<nint, ulong, ulong, ulong, uint, void**, int>)load("vkMapMemory");
            vkUnmapMemory = (delegate* unmanaged[Cdecl]<nint, ulong, void>)load("vkUnmapMemory");
            vkCreateBuffer = (delegate* unmanaged[Cdecl]<nint, VkBufferCreateInfo*, void*, ulong*, int>)load("vkCreateBuffer");
            vkDestroyBuffer = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroyBuffer");
            vkGetBufferMemoryRequirements = (delegate* unmanaged[Cdecl]<nint, ulong, VkMemoryRequirements*, void>)load("vkGetBufferMemoryRequirements");
            vkBindBufferMemory = (delegate* unmanaged[Cdecl]<nint, ulong, ulong, ulong, int>)load("vkBindBufferMemory");
            vkCreateImage = (delegate* unmanaged[Cdecl]<nint, VkImageCreateInfo*, void*, ulong*, int>)load("vkCreateImage");
            vkDestroyImage = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroyImage");
            vkGetImageMemoryRequirements = (delegate* unmanaged[Cdecl]<nint, ulong, VkMemoryRequirements*, void>)load("vkGetImageMemoryRequirements");
            vkBindImageMemory = (delegate* unmanaged[Cdecl]<nint, ulong, ulong, ulong, int>)load("vkBindImageMemory");
            vkCreateImageView = (delegate* unmanaged[Cdecl]<nint, VkImageViewCreateInfo*, void*, ulong*, int>)load("vkCreateImageView");
            vkDestroyImageView = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroyImageView");
            vkCreateBufferView = (delegate* unmanaged[Cdecl]<nint, VkBufferViewCreateInfo*, void*, ulong*, int>)load("vkCreateBufferView");
            vkDestroyBufferView = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroyBufferView");
            vkCreateSampler = (delegate* unmanaged[Cdecl]<nint, VkSamplerCreateInfo*, void*, ulong*, int>)load("vkCreateSampler");
            vkDestroySampler = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroySampler");
            vkCreateCommandPool = (delegate* unmanaged[Cdecl]<nint, VkCommandPoolCreateInfo*, void*, ulong*, int>)load("vkCreateCommandPool");
            vkDestroyCommandPool = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroyCommandPool");
            vkResetCommandPool = (delegate* unmanaged[Cdecl]<nint, ulong, uint, int>)load("vkResetCommandPool");
            vkAllocateCommandBuffers = (delegate* unmanaged[Cdecl]<nint, VkCommandBufferAllocateInfo*, nint*, int>)load("vkAllocateCommandBuffers");
            vkBeginCommandBuffer = (delegate* unmanaged[Cdecl]<nint, VkCommandBufferBeginInfo*, int>)load("vkBeginCommandBuffer");
            vkEndCommandBuffer = (delegate* unmanaged[Cdecl]<nint, int>)load("vkEndCommandBuffer");
            vkQueueSubmit = (delegate* unmanaged[Cdecl]<nint, uint, VkSubmitInfo*, ulong, int>)load("vkQueueSubmit");
            vkCreateFence = (delegate* unmanaged[Cdecl]<nint, VkFenceCreateInfo*, void*, ulong*, int>)load("vkCreateFence");
            vkDestroyFence = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroyFence");
            vkResetFences = (delegate* unmanaged[Cdecl]<nint, uint, ulong*, int>)load("vkResetFences");
            vkWaitForFences = (delegate* unmanaged[Cdecl]<nint, uint, ulong*, uint, ulong, int>)load("vkWaitForFences");
            vkGetFenceStatus = (delegate* unmanaged[Cdecl]<nint, ulong, int>)load("vkGetFenceStatus");
            vkCmdPipelineBarrier = (delegate* unmanaged[Cdecl]<nint, uint, uint, uint, uint, VkMemoryBarrier*, uint, VkBufferMemoryBarrier*, uint,
                VkImageMemoryBarrier*, void>)load("vkCmdPipelineBarrier");
            vkCmdCopyBuffer = (delegate* unmanaged[Cdecl]<nint, ulong, ulong, uint, VkBufferCopy*, void>)load("vkCmdCopyBuffer");
            vkCmdCopyImage = (delegate* unmanaged[Cdecl]<nint, ulong, uint, ulong, uint, uint, VkImageCopy*, void>)load("vkCmdCopyImage");
            vkCmdBlitImage = (delegate* unmanaged[Cdecl]<nint, ulong, uint, ulong, uint, uint, VkImageBlit*, uint, void>)load("vkCmdBlitImage");
            vkCmdCopyBufferToImage = (delegate* unmanaged[Cdecl]<nint, ulong, ulong, uint, uint, VkBufferImageCopy*, void>)load("vkCmdCopyBufferToImage");
            vkCmdCopyImageToBuffer = (delegate* unmanaged[Cdecl]<nint, ulong, uint, ulong, uint, VkBufferImageCopy*, void>)load("vkCmdCopyImageToBuffer");
            vkCmdFillBuffer = (delegate* unmanaged[Cdecl]<nint, ulong, ulong, ulong, uint, void>)load("vkCmdFillBuffer");
            vkCmdClearColorImage =
                (delegate* unmanaged[Cdecl]<nint, ulong, uint, VkClearColorValue*, uint, VkImageSubresourceRange*, void>)load("vkCmdClearColorImage");
            vkCmdBindPipeline = (delegate* unmanaged[Cdecl]<nint, uint, ulong, void>)load("vkCmdBindPipeline");
            vkCmdBindDescriptorSets = (delegate* unmanaged[Cdecl]<nint, uint, ulong, uint, uint, ulong*, uint, uint*, void>)load("vkCmdBindDescriptorSets");
            vkCmdDispatch = (delegate* unmanaged[Cdecl]<nint, uint, uint, uint, void>)load("vkCmdDispatch");
            vkCmdDispatchIndirect = (delegate* unmanaged[Cdecl]<nint, ulong, ulong, void>)load("vkCmdDispatchIndirect");
            vkCreateDescriptorSetLayout =
                (delegate* unmanaged[Cdecl]<nint, VkDescriptorSetLayoutCreateInfo*, void*, ulong*, int>)load("vkCreateDescriptorSetLayout");
            vkDestroyDescriptorSetLayout = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroyDescriptorSetLayout");
            vkCreateDescriptorPool = (delegate* unmanaged[Cdecl]<nint, VkDescriptorPoolCreateInfo*, void*, ulong*, int>)load("vkCreateDescriptorPool");
            vkDestroyDescriptorPool = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroyDescriptorPool");
            vkResetDescriptorPool = (delegate* unmanaged[Cdecl]<nint, ulong, uint, int>)load("vkResetDescriptorPool");
            vkAllocateDescriptorSets = (delegate* unmanaged[Cdecl]<nint, VkDescriptorSetAllocateInfo*, ulong*, int>)load("vkAllocateDescriptorSets");
            vkUpdateDescriptorSets = (delegate* unmanaged[Cdecl]<nint, uint, VkWriteDescriptorSet*, uint, void*, void>)load("vkUpdateDescriptorSets");
            vkCreatePipelineLayout = (delegate* unmanaged[Cdecl]<nint, VkPipelineLayoutCreateInfo*, void*, ulong*, int>)load("vkCreatePipelineLayout");
            vkDestroyPipelineLayout = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroyPipelineLayout");
            vkCreateShaderModule = (delegate* unmanaged[Cdecl]<nint, VkShaderModuleCreateInfo*, void*, ulong*, int>)load("vkCreateShaderModule");
            vkDestroyShaderModule = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroyShaderModule");
            vkCreateComputePipelines =
                (delegate* unmanaged[Cdecl]<nint, ulong, uint, VkComputePipelineCreateInfo*, void*, ulong*, int>)load("vkCreateComputePipelines");
            vkDestroyPipeline = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroyPipeline");
            vkCreatePipelineCache = (delegate* unmanaged[Cdecl]<nint, VkPipelineCacheCreateInfo*, void*, ulong*, int>)load("vkCreatePipelineCache");
            vkDestroyPipelineCache = (delegate* unmanaged[Cdecl]<nint, ulong, void*, void>)load("vkDestroyPipelineCache");
            vkGetPipelineCacheData = (delegate* unmanaged[Cdecl]<nint, ulong, nuint*, void*, int>)load("vkGetPipelineCacheData");
            vkSetDebugUtilsObjectNameEXT = (delegate* unmanaged[Cdecl]<nint, VkDebugUtilsObjectNameInfoEXT*, int>)load("vkSetDebugUtilsObjectNameEXT");
        }
    }
}
