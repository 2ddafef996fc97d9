using System;
using System.Globalization;
using System.IO;

namespace UnityEngine.Vulkan
{
    /// <summary>The driver's cache of compiled pipelines, kept in a file per device and driver version.</summary>
    sealed unsafe class PipelineCacheFile : IDisposable
    {
        readonly VulkanDevice m_Device;
        readonly string m_Path;
        int m_LoadedSize;

        internal PipelineCacheFile(VulkanDevice device, string folder)
        {
            m_Device = device;
            var p = device.Properties;
            m_Path = Path.Combine(folder,
                string.Format(CultureInfo.InvariantCulture, "pipelines-{0:x4}-{1:x4}-{2:x8}.bin", p.vendorID, p.deviceID, p.driverVersion));
            var content = Load();
            m_LoadedSize = content.Length;
            ulong handle;
            fixed (byte* data = content)
            {
                var info = new VkPipelineCacheCreateInfo
                {
                    sType = Vk.VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO,
                    initialDataSize = (nuint)content.Length,
                    pInitialData = data,
                };
                VulkanException.Check(device.Api.vkCreatePipelineCache(device.Handle, &info, null, &handle), "vkCreatePipelineCache");
            }
            Handle = handle;
        }

        internal ulong Handle { get; private set; }

        /// <summary>Writes the file anew if the cache has grown. A folder that cannot be written costs only time.</summary>
        internal void Save()
        {
            nuint size = 0;
            VulkanException.Check(m_Device.Api.vkGetPipelineCacheData(m_Device.Handle, Handle, &size, null), "vkGetPipelineCacheData");
            if ((int)size <= m_LoadedSize)
                return;
            var content = new byte[(int)size];
            fixed (byte* data = content)
                VulkanException.Check(m_Device.Api.vkGetPipelineCacheData(m_Device.Handle, Handle, &size, data), "vkGetPipelineCacheData");
            if (AtomicFile.TryWrite(m_Path, content))
                m_LoadedSize = content.Length;
        }

        public void Dispose()
        {
            if (Handle == 0)
                return;
            Save();
            m_Device.Api.vkDestroyPipelineCache(m_Device.Handle, Handle, null);
            Handle = 0;
        }

        byte[] Load()
        {
            try
            {
                return File.Exists(m_Path) ? File.ReadAllBytes(m_Path) : Array.Empty<byte>();
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                return Array.Empty<byte>();
            }
        }
    }
}
