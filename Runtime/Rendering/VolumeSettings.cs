using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve
{
    /// <summary>A renderer's segment table for the present volume: the one that a script set, or else what the appearance makes of the volume's.</summary>
    sealed class VolumeSettings
    {
        object setFor; // the volume's origin: a volume is large, none is held that is not shown
        SegmentTable set;

        /// <summary>The table for a volume. The one that was set for another volume is forgotten; a coarser one of the same data is none.</summary>
        public SegmentTable SegmentsFor(SegmentedVolume volume, VolumeAppearance appearance)
        {
            KeepOnly(volume);
            return set ?? appearance.Apply(volume?.Segments);
        }

        /// <summary>Sets the table for a volume; null = as the appearance has it.</summary>
        public void SetSegments(SegmentedVolume volume, SegmentTable table)
        {
            if (volume == null)
                throw new ArgumentException("No volume is loaded, so it has no segments.", nameof(table));
            if (table != null && table.Count != volume.Segments.Count)
                throw new ArgumentException($"The table has {table.Count} segments, the volume has {volume.Segments.Count}.", nameof(table));
            set = table;
            setFor = volume.Origin;
        }

        public void KeepOnly(SegmentedVolume volume)
        {
            if (setFor == volume?.Origin)
                return;
            set = null;
            setFor = null;
        }
    }
}
