using System;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>What a device holds of one volume. Asked of the device on the main thread, used on any.</summary>
    readonly struct VolumeLimits
    {
        /// <summary>Graphics memory below this, MiB, is a window on main memory: no device of its own has as little.</summary>
        const int SmallestOwnMemory = 1024;

        /// <summary>A volume's share of graphics memory; the rest is for pictures and for whoever else draws.</summary>
        const double ShareOfOwn = 0.75;

        /// <summary>
        /// A volume's share of main memory where the graphics device has none of its own: phones, headsets, integrated graphics. The volume's main-memory copy
        /// takes more than half as much again: of the 8 GiB of a Quest 3, of which an application gets about four, both have 3.2.
        /// </summary>
        const double ShareOfShared = 0.25;

        readonly bool narrowLabels;

        VolumeLimits(TextureLayout layout, bool narrowLabels, int side, long voxels, long bytes, string holder) =>
            (Layout, this.narrowLabels, Side, Voxels, Bytes, Holder) = (layout, narrowLabels, side, voxels, bytes, holder);

        /// <summary>How volumes lie in textures there.</summary>
        public TextureLayout Layout { get; }

        /// <summary>The most voxels along an axis.</summary>
        public int Side { get; }

        /// <summary>The most voxels.</summary>
        public long Voxels { get; }

        /// <summary>The most bytes; <see cref="long.MaxValue"/> = nobody knows.</summary>
        public long Bytes { get; }

        /// <summary>Who holds no more, for messages.</summary>
        public string Holder { get; }

        /// <summary>What this device holds.</summary>
        /// <param name="layout">How volumes are to lie in textures.</param>
        /// <param name="budgetMiB">What a volume may take; 0 = what the device says.</param>
        public static VolumeLimits OfDevice(TextureLayout layout, int budgetMiB)
        {
            layout = DeviceSupport.Choose(layout);
            bool narrow = DeviceSupport.LabelsIn8Bits(1);
            if (DeviceSupport.MissingAtAll() != null) // renderers say so; voxels can be used all the same
                return new VolumeLimits(layout, narrow, int.MaxValue, long.MaxValue, long.MaxValue, "");
            long bytes = budgetMiB > 0 ? (long)budgetMiB << 20 : Available(SystemInfo.graphicsMemorySize, SystemInfo.systemMemorySize, Application.isMobilePlatform);
            return new VolumeLimits(
                layout, narrow, DeviceSupport.LargestSide, DeviceSupport.MaxVoxels, bytes, budgetMiB > 0 ? "the budget" : SystemInfo.graphicsDeviceName);
        }

        /// <summary>Bytes that a volume may take of a device's memory; <see cref="long.MaxValue"/> where the device does not say what it has.</summary>
        /// <param name="graphicsMiB">Graphics memory, 0 = unknown.</param>
        /// <param name="systemMiB">Main memory, 0 = unknown.</param>
        /// <param name="isMobile">Whether it is a phone or a headset: their memory is shared, whatever they say.</param>
        public static long Available(int graphicsMiB, int systemMiB, bool isMobile)
        {
            bool isShared = isMobile || graphicsMiB < SmallestOwnMemory;
            double mib = isShared && systemMiB > 0 ? ShareOfShared * systemMiB : ShareOfOwn * graphicsMiB;
            return mib > 0 ? (long)(mib * (1 << 20)) : long.MaxValue;
        }

        /// <summary>What a volume takes.</summary>
        public long Needs(int sizeI, int sizeJ, int sizeK, int segments) => VolumeGpuBytes.Of(
            sizeI, sizeJ, sizeK, segments, Layout, narrowLabels && segments <= VolumeTextures.MaxSegmentsIn8Bits);

        /// <summary>Whether a volume of so many voxels along i, j and k and so many segments can be held.</summary>
        public bool Hold(int sizeI, int sizeJ, int sizeK, int segments) =>
            sizeI <= Side && sizeJ <= Side && sizeK <= Side && (long)sizeI * sizeJ * sizeK <= Voxels && Needs(sizeI, sizeJ, sizeK, segments) <= Bytes;

        /// <summary>Why a volume cannot be held, as the half of a sentence.</summary>
        public string Reason(VolumeGeometry grid, int segments)
        {
            if (grid.SizeI > Side || grid.SizeJ > Side || grid.SizeK > Side)
                return FormattableString.Invariant($"the device's 3D textures end at {Side} voxels along an axis");
            if (grid.VoxelCount > Voxels)
                return FormattableString.Invariant($"a texture holds {Voxels} voxels at most");
            return FormattableString.Invariant(
                $"it needs {MiB(Needs(grid.SizeI, grid.SizeJ, grid.SizeK, segments))} on the GPU and {Holder} has {MiB(Bytes)} for it");
        }

        static string MiB(long bytes) => MemoryForecast.MiB(bytes);
    }
}
