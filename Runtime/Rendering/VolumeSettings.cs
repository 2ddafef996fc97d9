using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve
{
    /// <summary>A renderer's transfer function and segment table: its own, or what suits the volume.</summary>
    sealed class VolumeSettings
    {
        SegmentedVolume segmentsFor;
        SegmentTable segments;

        /// <summary>The one that was set; null = automatic.</summary>
        public OpacityTransferFunction TransferFunction { get; set; }

        public OpacityTransferFunction TransferFunctionFor(SegmentedVolume volume) => TransferFunction ?? volume?.AutomaticTransferFunction;

        /// <summary>The table for a volume. The one that was set for another volume is forgotten, and that volume with it.</summary>
        public SegmentTable SegmentsFor(SegmentedVolume volume)
        {
            if (segmentsFor != volume)
            {
                segments = volume?.Segments;
                segmentsFor = volume;
            }
            return segments;
        }

        public void SetSegments(SegmentedVolume volume, SegmentTable table)
        {
            if (volume == null)
                throw new ArgumentException("No volume is loaded, so it has no segments.", nameof(table));
            if (table != null && table.Count != volume.Segments.Count)
                throw new ArgumentException($"The table has {table.Count} segments, the volume has {volume.Segments.Count}.", nameof(table));
            segments = table ?? volume.Segments;
            segmentsFor = volume;
        }
    }
}
