using System;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Formats;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>A volume out of files, wherever they lie: those that no stream can be opened on are fetched first.</summary>
    sealed class FileOpening : VolumeOpening
    {
        /// <summary>The share of the progress that fetching takes, where files have to be fetched.</summary>
        const float Fetching = 0.3f;

        readonly string intensity, labels;
        FetchedFiles fetched;
        SourceOpening source;

        /// <param name="intensity">A path or an address.</param>
        /// <param name="labels">Likewise; null = everything is unlabelled.</param>
        public FileOpening(string intensity, string labels) => (this.intensity, this.labels) = (intensity, labels);

        public override async Task<MemoryForecast> ForecastAsync(VolumeLimits limits, CancellationToken cancellationToken, IProgress<float> progress)
        {
            string scanPath = intensity, labelsPath = labels;
            if (VolumePaths.IsAddress(intensity) || VolumePaths.IsAddress(labels))
            {
                fetched = new FetchedFiles(Application.temporaryCachePath);
                scanPath = await fetched.FetchAsync(intensity, cancellationToken, new ProgressShare(progress, 0f, 0.5f * Fetching));
                labelsPath = await fetched.FetchAsync(labels, cancellationToken, new ProgressShare(progress, 0.5f * Fetching, 0.5f * Fetching));
            }
            source = new SourceOpening(VolumeSource.OfFile(scanPath), VolumeSource.OfFile(labelsPath));
            return await source.ForecastAsync(limits, cancellationToken, progress);
        }

        public override Task<SegmentedVolume> ReadAsync(LoadPlan plan, CancellationToken cancellationToken, IProgress<float> progress) =>
            source.ReadAsync(plan, cancellationToken, fetched == null ? progress : new ProgressShare(progress, Fetching, 1f - Fetching));

        public override void Dispose() => fetched?.Dispose();
    }
}
