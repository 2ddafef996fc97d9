using System;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Formats;
using AnatomyCarve.Volumes;

namespace AnatomyCarve
{
    /// <summary>A volume out of files that can be read, or out of their contents.</summary>
    sealed class SourceOpening : VolumeOpening
    {
        /// <summary>The share of the progress that reading takes where a volume has to get coarser.</summary>
        const float Reading = 0.9f;

        readonly VolumeSource intensity, labels;
        VolumeFileInfo scanInfo, labelsInfo;

        /// <param name="intensity">The intensities.</param>
        /// <param name="labels">The labels; null = everything is unlabelled.</param>
        public SourceOpening(VolumeSource intensity, VolumeSource labels) => (this.intensity, this.labels) = (intensity, labels);

        public override Task<MemoryForecast> ForecastAsync(VolumeLimits limits, CancellationToken cancellationToken, IProgress<float> progress) =>
            Task.Run(
                () =>
                {
                    (scanInfo, labelsInfo) = (intensity.ReadInfo(), labels?.ReadInfo());
                    return MemoryForecast.Of(scanInfo, labelsInfo, intensity.ShortName, limits);
                },
                cancellationToken);

        public override Task<SegmentedVolume> ReadAsync(LoadPlan plan, CancellationToken cancellationToken, IProgress<float> progress) =>
            Task.Run(() => Read(plan, cancellationToken, progress), cancellationToken);

        SegmentedVolume Read(LoadPlan plan, CancellationToken cancellationToken, IProgress<float> progress)
        {
            // What is refused whatever the labels turn out to be takes no memory.
            int atLeast = Math.Max(1, MemoryForecast.SegmentsOf(labelsInfo));
            plan.Factors(scanInfo.Geometry, atLeast, intensity.ShortName);
            bool surelyFits = plan.Fits(scanInfo.Geometry, labels == null ? 1 : SegmentTable.MaximumCount);
            IProgress<float> reading = surelyFits ? progress : new ProgressShare(progress, 0f, Reading);
            SegmentedVolume volume = SegmentedVolumeReader.Read(intensity, labels, cancellationToken, reading);
            VolumeGeometry grid = volume.Geometry;
            VoxelFactors factors = plan.Factors(grid, volume.Segments.Count, intensity.ShortName);
            VolumeGeometry loaded = factors.Apply(grid);
            plan.ShowCoarse(loaded, grid, coarse => VolumeDownsampling.Of(volume, coarse, CellSlices.Middle, cancellationToken));
            if (factors.AreOne)
                return volume;
            int segments = volume.Segments.Count;
            volume = VolumeDownsampling.Of(volume, factors, CellSlices.All, cancellationToken, new ProgressShare(progress, Reading, 1f - Reading));
            _ = volume.Blocks; // here, so that the main thread need not wait for it
            return volume.WithWarning(plan.Warning(grid, segments, loaded, intensity.ShortName));
        }
    }
}
