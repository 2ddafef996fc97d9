using System;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Formats;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// A way to a volume: first what it will take, then the volume. Both begin on the main thread, do their work on others, and end on the main thread.
    /// </summary>
    abstract class VolumeOpening : IDisposable
    {
        public static VolumeOpening OfAsset(VolumeAsset asset) => new AssetOpening(asset);

        public static VolumeOpening OfContents(byte[] intensity, byte[] labels, string name) => new SourceOpening(
            VolumeSource.OfContent(intensity, name), labels == null ? null : VolumeSource.OfContent(labels, name + " (labels)"));

        /// <exception cref="ArgumentException">There is no path.</exception>
        public static VolumeOpening OfFiles(string intensityPath, string labelsPath)
        {
            if (string.IsNullOrEmpty(intensityPath))
                throw new ArgumentException("A volume needs a file with intensities.", nameof(intensityPath));
            return new FileOpening(
                VolumePaths.Resolve(intensityPath, Application.streamingAssetsPath), VolumePaths.Resolve(labelsPath, Application.streamingAssetsPath));
        }

        /// <summary>What it will take. Comes before <see cref="ReadAsync"/>.</summary>
        public abstract Task<MemoryForecast> ForecastAsync(VolumeLimits limits, CancellationToken cancellationToken, IProgress<float> progress);

        /// <summary>The volume.</summary>
        /// <exception cref="VolumeTooLargeException">The plan refuses it.</exception>
        public abstract Task<SegmentedVolume> ReadAsync(LoadPlan plan, CancellationToken cancellationToken, IProgress<float> progress);

        public virtual void Dispose()
        {
        }
    }
}
