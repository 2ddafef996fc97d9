using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>A renderer's place for one volume on the GPU. What the device refused is said once, and not tried again before it was released.</summary>
    sealed class GpuSlot
    {
        SegmentedVolume refused;

        public GpuSlot(RenderStatistics statistics) => Statistics = statistics;

        public RenderStatistics Statistics { get; }

        /// <summary>What is there; null = nothing.</summary>
        public VolumeGpu Gpu { get; private set; }

        /// <summary>Puts a volume there, unless it is there already; another one goes.</summary>
        /// <returns>Null where there is no volume or the device cannot.</returns>
        public VolumeGpu For(SegmentedVolume volume, Object owner)
        {
            KeepOnly(volume);
            if (volume == null || volume == refused)
                return null;
            if (Gpu == null)
            {
                Gpu = VolumeGpu.TryCreate(volume, Statistics, out string problem);
                if (Gpu == null)
                    Refuse(volume, problem, owner);
            }
            return Gpu;
        }

        /// <summary>Takes a volume away that the device turned out not to bear.</summary>
        public void Refuse(SegmentedVolume volume, string problem, Object owner)
        {
            Release();
            refused = volume;
            Debug.LogError($"{owner.name}: this volume cannot be shown. {problem}", owner);
        }

        /// <summary>Lets go of every other volume.</summary>
        public void KeepOnly(SegmentedVolume volume)
        {
            if ((Gpu != null && Gpu.Volume != volume) || (refused != null && refused != volume))
                Release();
        }

        public void Release()
        {
            Gpu?.Dispose();
            Gpu = null;
            refused = null;
        }
    }
}
