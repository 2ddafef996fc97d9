using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using AnatomyCarve.Formats;
using AnatomyCarve.Volumes;

namespace AnatomyCarve
{
    /// <summary>Reads a volume from its files, on any thread.</summary>
    static class VolumeReading
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
        public static SegmentedVolume Read(string intensityPath, string labelsPath, CancellationToken cancellationToken, IProgress<float> progress)
        {
            bool labelled = !string.IsNullOrEmpty(labelsPath);
            float whole = labelled ? 1f : ReadIntensity + ConvertIntensity;
            var warnings = new List<string>();
            VolumeData data = VolumeReader.Read(intensityPath, cancellationToken, new Share(progress, 0f, ReadIntensity / whole));
            Add(warnings, intensityPath, data.Warnings);
            if (data.Components > 1)
                Add(warnings, intensityPath, new[] { $"The file has {data.Components} values per voxel; the first is shown, the others are ignored." });
            var share = new Share(progress, ReadIntensity / whole, ConvertIntensity / whole);
            IntensityVolume intensity = IntensityVolume.FromVolumeData(data, 0, cancellationToken, share);
            Add(warnings, intensityPath, intensity.Warnings);
            if (!labelled)
                return Prepared(SegmentedVolume.Unsegmented(intensity, warnings));
            data = VolumeReader.Read(labelsPath, cancellationToken, new Share(progress, ReadIntensity + ConvertIntensity, ReadLabels));
            LabelMap labels = LabelMap.FromVolumeData(data, cancellationToken, new Share(progress, 1f - ConvertLabels, ConvertLabels))
                .OnGridOf(intensity.Geometry);
            Add(warnings, labelsPath, data.Warnings.Concat(labels.Warnings));
            try
            {
                return Prepared(new SegmentedVolume(intensity, labels, warnings));
            }
            catch (VolumeMismatchException problem)
            {
                throw new VolumeMismatchException($"{labelsPath} and {intensityPath}: {problem.Message}");
            }
        }

        /// <summary>Computes here what the main thread would wait for otherwise.</summary>
        static SegmentedVolume Prepared(SegmentedVolume volume)
        {
            _ = volume.AutomaticTransferFunction;
            return volume;
        }

        static void Add(List<string> warnings, string path, IEnumerable<string> sentences) =>
            warnings.AddRange(sentences.Select(sentence => $"{Path.GetFileName(path)}: {sentence}"));

        sealed class Share : IProgress<float>
        {
            readonly IProgress<float> whole;
            readonly float start, length;

            public Share(IProgress<float> whole, float start, float length)
            {
                this.whole = whole;
                this.start = start;
                this.length = length;
            }

            public void Report(float value) => whole.Report(start + length * value);
        }
    }
}
