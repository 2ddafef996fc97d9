using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>Everything that belongs to one Vulkan device.</summary>
    sealed class GpuContext
    {
        readonly HashSet<IGpuObject> m_Alive = new();
        readonly List<IDisposable> m_Programs = new();
        VulkanBuffer m_DefaultVertex;

        internal GpuContext()
        {
            Messages = new VulkanMessages();
            Instance = new VulkanInstance(GpuOptions.Validation, Messages);
            try
            {
                Device = new VulkanDevice(Instance, Environment.GetEnvironmentVariable(GpuOptions.DeviceVariable));
            }
            catch
            {
                Instance.Dispose();
                throw;
            }
            Stream = new CommandStream(Device);
            Samplers = new SamplerCache(Device);
            Pipelines = new PipelineCacheFile(Device, GpuOptions.EffectiveCacheFolder);
            Readbacks = new ReadbackQueue(this);
        }

        internal VulkanMessages Messages { get; }

        internal VulkanInstance Instance { get; }

        internal VulkanDevice Device { get; }

        internal CommandStream Stream { get; }

        internal SamplerCache Samplers { get; }

        internal PipelineCacheFile Pipelines { get; }

        internal ReadbackQueue Readbacks { get; }

        /// <summary>What vertices read of attributes that their mesh lacks.</summary>
        internal unsafe VulkanBuffer DefaultVertex
        {
            get
            {
                if (m_DefaultVertex != null)
                    return m_DefaultVertex;
                var values = UnityEngine.DefaultVertex.Values;
                m_DefaultVertex = new VulkanBuffer(Device, (ulong)values.Length * sizeof(float), Vk.VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, BufferPlace.Upload);
                values.CopyTo(new Span<float>(m_DefaultVertex.Mapped, values.Length));
                return m_DefaultVertex;
            }
        }

        internal bool IsDisposed { get; private set; }

        /// <summary>How many textures have memory on the device.</summary>
        internal int TextureCount => m_Alive.Count(o => o.IsTexture);

        /// <summary>How many buffers have memory on the device.</summary>
        internal int BufferCount => m_Alive.Count(o => !o.IsTexture);

        /// <summary>Bytes on the device that belong to textures and buffers.</summary>
        internal long Bytes { get; private set; }

        /// <summary>The most that <see cref="Bytes"/> ever was.</summary>
        internal long PeakBytes { get; private set; }

        /// <summary>Bytes of <see cref="Bytes"/> that belong to textures.</summary>
        internal ulong TextureBytes => (ulong)m_Alive.Where(o => o.IsTexture).Sum(o => o.Bytes);

        /// <summary>How many dispatches were recorded since the start.</summary>
        internal long DispatchCount { get; set; }

        internal void Add(IGpuObject item)
        {
            m_Alive.Add(item);
            Bytes += item.Bytes;
            PeakBytes = Math.Max(PeakBytes, Bytes);
        }

        internal void Remove(IGpuObject item)
        {
            if (m_Alive.Remove(item))
                Bytes -= item.Bytes;
        }

        /// <summary>Keeps a pipeline until the device ends.</summary>
        internal void Own(IDisposable program) => m_Programs.Add(program);

        internal GpuReport Shutdown()
        {
            Readbacks.Cancel();
            Stream.Wait(Stream.CurrentSerial);
            var leaks = m_Alive.Select(o => o.Describe()).OrderBy(s => s, StringComparer.Ordinal).ToList();
            foreach (var item in m_Alive.ToArray())
                item.FreeNow();
            m_Alive.Clear();
            Readbacks.Dispose();
            Stream.Dispose();
            m_DefaultVertex?.Dispose();
            foreach (var program in m_Programs)
                program.Dispose();
            Samplers.Dispose();
            Pipelines.Dispose();
            IsDisposed = true;
            Device.Dispose();
            Instance.Dispose();
            Messages.Drain();
            return new GpuReport(leaks);
        }
    }

    /// <summary>Something with memory on the device.</summary>
    interface IGpuObject
    {
        bool IsTexture { get; }

        long Bytes { get; }

        string Describe();

        /// <summary>The device ends: free without asking it whether it is done.</summary>
        void FreeNow();
    }
}
