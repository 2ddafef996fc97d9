using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>Reads a volume from its files, or from their content in memory, on any thread.</summary>
    public static class SegmentedVolumeReader
    {
        /// <summary>What each of the four steps counts in the progress of the whole.</summary>
        const float ReadIntensity = 0.3f, ConvertIntensity = 0.25f, ReadLabels = 0.2f, ConvertLabels = 0.25f;

        /// <param name="intensityPath">A file with intensities.</param>
        /// <param name="labelsPath">
        /// A file with labels on the same grid, or on a part of it, in any orientation; null or empty = everything is unlabelled.
        /// </param>
        /// <param name="cancellationToken">Stops reading.</param>
        /// <param name="progress">Gets 0 to 1, on the thread that reads.</param>
        /// <exception cref="VolumeFormatException">A file cannot be read.</exception>
        /// <exception cref="VolumeMismatchException">The files are on different grids.</exception>
        public static SegmentedVolume Read(string intensityPath, string labelsPath, CancellationToken cancellationToken, IProgress<float> progress) =>
            Read(VolumeSource.OfFile(intensityPath), VolumeSource.OfFile(labelsPath), cancellationToken, progress);

        /// <summary>The same from files or from memory.</summary>
        /// <param name="intensitySource">The intensities.</param>
        /// <param name="labelsSource">The labels; null = everything is unlabelled.</param>
        public static SegmentedVolume Read(VolumeSource intensitySource, VolumeSource labelsSource, CancellationToken cancellationToken, IProgress<float> progress)
        {
            if (intensitySource == null)
                throw new ArgumentNullException(nameof(intensitySource), "A volume needs intensities.");
            float whole = labelsSource != null ? 1f : ReadIntensity + ConvertIntensity;
            var warnings = new List<string>();
            VolumeData data = intensitySource.Read(cancellationToken, new ProgressShare(progress, 0f, ReadIntensity / whole));
            Add(warnings, intensitySource, data.Warnings);
            if (data.Components > 1)
                Add(warnings, intensitySource, new[] { $"The file has {data.Components} values per voxel; the first is shown, the others are ignored." });
            var share = new ProgressShare(progress, ReadIntensity / whole, ConvertIntensity / whole);
            IntensityVolume intensity = IntensityVolume.FromVolumeData(data, 0, cancellationToken, share);
            Add(warnings, intensitySource, intensity.Warnings);
            if (labelsSource == null)
                return Prepared(SegmentedVolume.Unsegmented(intensity, warnings));
            data = labelsSource.Read(cancellationToken, new ProgressShare(progress, ReadIntensity + ConvertIntensity, ReadLabels));
            LabelMap labels = LabelMap.FromVolumeData(data, cancellationToken, new ProgressShare(progress, 1f - ConvertLabels, ConvertLabels))
                .OnGridOf(intensity.Geometry);
            Add(warnings, labelsSource, data.Warnings.Concat(labels.Warnings));
            try
            {
                return Prepared(new SegmentedVolume(intensity, labels, warnings));
            }
            catch (VolumeMismatchException problem)
            {
                throw new VolumeMismatchException($"{labelsSource.Name} and {intensitySource.Name}: {problem.Message}");
            }
        }

        /// <summary>Computes here what the main thread would wait for otherwise.</summary>
        static SegmentedVolume Prepared(SegmentedVolume volume)
        {
            _ = volume.AutomaticTransferFunction;
            _ = volume.Blocks;
            return volume;
        }

        static void Add(List<string> warnings, VolumeSource source, IEnumerable<string> sentences) =>
            warnings.AddRange(sentences.Select(sentence => $"{source.ShortName}: {sentence}"));
    }
}
