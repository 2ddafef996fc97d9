using System;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Formats;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>The ways to a volume. All begin on the main thread, do their work on others, and end on the main thread.</summary>
    static class VolumeOpening
    {
        /// <summary>The share of the progress that fetching takes, where files have to be fetched.</summary>
        const float Fetching = 0.3f;

        public static Task<SegmentedVolume> AssetAsync(VolumeAsset asset, CancellationToken cancellationToken, IProgress<float> progress)
        {
            ReadOnlyMemory<byte> packed = asset.Open();
            string name = asset.name;
            return Task.Run(() =>
            {
                SegmentedVolume volume = PackedVolume.Read(packed, name, cancellationToken, progress);
                _ = volume.Blocks; // here, so that the main thread need not wait for it
                return volume;
            }, cancellationToken);
        }

        public static Task<SegmentedVolume> ContentsAsync(
            byte[] intensity, byte[] labels, string name, CancellationToken cancellationToken, IProgress<float> progress)
        {
            VolumeSource intensitySource = VolumeSource.OfContent(intensity, name);
            VolumeSource labelsSource = labels == null ? null : VolumeSource.OfContent(labels, name + " (labels)");
            return Task.Run(() => SegmentedVolumeReader.Read(intensitySource, labelsSource, cancellationToken, progress), cancellationToken);
        }

        public static async Task<SegmentedVolume> FilesAsync(
            string intensityPath, string labelsPath, CancellationToken cancellationToken, IProgress<float> progress)
        {
            string intensity = VolumePaths.Resolve(intensityPath, Application.streamingAssetsPath);
            string labels = VolumePaths.Resolve(labelsPath, Application.streamingAssetsPath);
            if (!VolumePaths.IsAddress(intensity) && !VolumePaths.IsAddress(labels))
                return await Task.Run(() => SegmentedVolumeReader.Read(intensity, labels, cancellationToken, progress), cancellationToken);

            using var fetched = new FetchedFiles(Application.temporaryCachePath);
            intensity = await fetched.FetchAsync(intensity, cancellationToken, new ProgressShare(progress, 0f, 0.5f * Fetching));
            labels = await fetched.FetchAsync(labels, cancellationToken, new ProgressShare(progress, 0.5f * Fetching, 0.5f * Fetching));
            var rest = new ProgressShare(progress, Fetching, 1f - Fetching);
            return await Task.Run(() => SegmentedVolumeReader.Read(intensity, labels, cancellationToken, rest), cancellationToken);
        }
    }
}
