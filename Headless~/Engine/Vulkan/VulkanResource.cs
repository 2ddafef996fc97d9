namespace UnityEngine.Vulkan
{
    /// <summary>What the command stream must know of a buffer or an image to order its uses.</summary>
    abstract class VulkanResource
    {
        /// <summary>The barrier epoch in which a command last read this.</summary>
        internal long ReadEpoch = -1;

        /// <summary>The barrier epoch in which a command last wrote this.</summary>
        internal long WriteEpoch = -1;

        /// <summary>The submission that last used this.</summary>
        internal ulong LastUse;
    }
}
