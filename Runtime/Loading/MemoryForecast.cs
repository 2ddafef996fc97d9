using System;
using System.Globalization;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Formats;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// What a volume will take in memory as it is, known from its header before its voxels are read. Pictures and what pointers keep (64 MiB at most) are not in
    /// it; the GPU's bytes are those that <see cref="RenderStatistics.Resources"/> lists for the volume, at up to 16 clip spheres.
    /// </summary>
    public readonly struct MemoryForecast
    {
        /// <summary>Rows of a table of which nothing else is known than that its labels are stored in 8 bits.</summary>
        const int SegmentsOf8Bits = VolumeTextures.MaxSegmentsIn8Bits;

        internal MemoryForecast(string name, VolumeGeometry grid, int segmentCount, int mostSegments, long cpuPeakBytes, VolumeLimits limits)
        {
            (Name, SizeI, SizeJ, SizeK, SegmentCount) = (name, grid.SizeI, grid.SizeJ, grid.SizeK, segmentCount);
            Layout = limits.Layout;
            CpuBytes = grid.VoxelCount * (sizeof(ushort) + sizeof(ushort));
            CpuPeakBytes = Math.Max(CpuBytes, cpuPeakBytes);
            GpuBytes = limits.Needs(SizeI, SizeJ, SizeK, mostSegments);
        }

        /// <summary>The volume's name: a file's without folders, or the asset's.</summary>
        public string Name { get; }

        /// <summary>Voxels along i, the axis that runs fastest in memory.</summary>
        public int SizeI { get; }

        /// <summary>Voxels along j.</summary>
        public int SizeJ { get; }

        /// <summary>Voxels along k.</summary>
        public int SizeK { get; }

        /// <summary>
        /// Segments, label 0 included; 0 = known only when the voxels have been read. Then <see cref="GpuBytes"/> counts as many as the labels' type allows, and
        /// 255 for labels stored in 8 bits.
        /// </summary>
        public int SegmentCount { get; }

        /// <summary>How it will lie in textures: compact or portable.</summary>
        public TextureLayout Layout { get; }

        /// <summary>Bytes in main memory once it is loaded: two for the intensity and two for the label of each voxel.</summary>
        public long CpuBytes { get; }

        /// <summary>Bytes in main memory while it loads: with the voxels as the file stores them, or the asset's packed bytes.</summary>
        public long CpuPeakBytes { get; }

        /// <summary>
        /// Bytes on the GPU once it is shown, if all of it can be visible. Where there is nothing at its faces it is less: <see cref="RenderStatistics.StoredVoxels"/>.
        /// </summary>
        public long GpuBytes { get; }

        /// <summary><see cref="GpuBytes"/> for each voxel.</summary>
        public double GpuBytesPerVoxel => (double)GpuBytes / ((long)SizeI * SizeJ * SizeK);

        /// <summary>The forecast for an imported volume. Main thread.</summary>
        /// <param name="asset">The asset.</param>
        /// <param name="layout">How it will lie in textures; automatic = as the device can write them.</param>
        /// <exception cref="ArgumentNullException"><paramref name="asset"/> is null.</exception>
        /// <exception cref="AnatomyCarveException">The asset holds no volume.</exception>
        public static MemoryForecast Of(VolumeAsset asset, TextureLayout layout = TextureLayout.Automatic)
        {
            if (asset == null)
                throw new ArgumentNullException(nameof(asset));
            return Of(asset, VolumeLimits.OfDevice(layout, 0));
        }

        /// <summary>The forecast for a volume that is in memory already. Main thread.</summary>
        /// <param name="volume">The volume.</param>
        /// <param name="name">What the sentence calls it.</param>
        /// <param name="layout">How it will lie in textures; automatic = as the device can write them.</param>
        /// <exception cref="ArgumentNullException"><paramref name="volume"/> is null.</exception>
        public static MemoryForecast Of(SegmentedVolume volume, string name = "volume", TextureLayout layout = TextureLayout.Automatic)
        {
            int segments = (volume ?? throw new ArgumentNullException(nameof(volume))).Segments.Count;
            return new MemoryForecast(name, volume.Geometry, segments, segments, 0, VolumeLimits.OfDevice(layout, 0));
        }

        /// <summary>The forecast for files, of which only the headers are read, on another thread. Call it on the main thread.</summary>
        /// <param name="intensityPath">File with intensities. A relative path counts from StreamingAssets; a file at an address is fetched first.</param>
        /// <param name="labelsPath">File with labels; null or empty = everything is unlabelled.</param>
        /// <param name="layout">How the volume will lie in textures; automatic = as the device can write them.</param>
        /// <param name="cancellationToken">Stops it.</param>
        /// <exception cref="ArgumentException">There is no path.</exception>
        /// <exception cref="VolumeFormatException">A header cannot be read.</exception>
        /// <exception cref="AnatomyCarveException">A file could not be fetched.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public static async Task<MemoryForecast> OfFilesAsync(
            string intensityPath, string labelsPath = null, TextureLayout layout = TextureLayout.Automatic, CancellationToken cancellationToken = default)
        {
            using VolumeOpening opening = VolumeOpening.OfFiles(intensityPath, labelsPath);
            return await opening.ForecastAsync(VolumeLimits.OfDevice(layout, 0), cancellationToken, null);
        }

        /// <summary>One sentence, such as "ct.nii.gz: 512 x 512 x 600 voxels take at most 1,057.5 MiB on the GPU (7.05 bytes per voxel) and ...".</summary>
        public override string ToString() =>
            FormattableString.Invariant($"{Name}: {SizeI} x {SizeJ} x {SizeK} voxels take at most {MiB(GpuBytes)} on the GPU ({GpuBytesPerVoxel:0.00} bytes per voxel) ")
            + $"and {MiB(CpuBytes)} of main memory, {MiB(CpuPeakBytes)} while they load.";

        internal static string MiB(long bytes) => (bytes / (double)(1 << 20)).ToString("N1", CultureInfo.InvariantCulture) + " MiB";

        internal static MemoryForecast Of(VolumeAsset asset, VolumeLimits limits)
        {
            Vector3Int size = asset.Size;
            if (asset.Data == null || size.x < 1 || size.y < 1 || size.z < 1)
                throw VolumeAsset.HoldsNoVolume(asset.name);
            int segments = Math.Max(1, asset.Segments.Count);
            var grid = new VolumeGeometry(size.x, size.y, size.z, Affine.Identity);
            return new MemoryForecast(asset.name, grid, segments, segments, asset.UnpackedBytes + asset.PackedBytes, limits);
        }

        internal static MemoryForecast Of(VolumeFileInfo scan, VolumeFileInfo labels, string name, VolumeLimits limits)
        {
            int segments = SegmentsOf(labels);
            int most = segments > 0 ? segments : labels.VoxelType.SizeOf() == 1 ? SegmentsOf8Bits : SegmentTable.MaximumCount;
            long plane = sizeof(ushort) * scan.Geometry.VoxelCount, label = labels?.StoredBytes ?? 0;
            long peak = Math.Max(Math.Max(WhileRead(scan), scan.StoredBytes + plane), plane + Math.Max(WhileRead(labels), label + plane));
            return new MemoryForecast(name, scan.Geometry, segments, most, peak, limits);
        }

        /// <summary>The segments of a file with labels; 0 where the header does not say.</summary>
        internal static int SegmentsOf(VolumeFileInfo labels) =>
            labels == null ? 1 : labels.Segments.Count > 0 ? Math.Min(labels.Segments.Count + 1, SegmentTable.MaximumCount) : 0;

        /// <summary>Arrays grow by half where it is not known before how much comes out of a file.</summary>
        static long WhileRead(VolumeFileInfo info) => info == null ? 0 : info.IsCompressed ? info.StoredBytes / 2 * 3 : info.StoredBytes;
    }
}
