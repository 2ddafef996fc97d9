using System.Collections.Generic;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>Everything that a packed volume holds beside its voxels, and where their blocks are.</summary>
    sealed class PackedHeader
    {
        /// <summary>How packed volumes begin, ASCII.</summary>
        internal const string Magic = "ACVOLUME";

        /// <summary>The version that is written, and the only one that is read.</summary>
        internal const int Version = 1;

        /// <summary>Mark, version, the header's and the file's bytes.</summary>
        internal const int StartBytes = 24;

        internal const int ChecksumBytes = sizeof(ulong);

        /// <summary>Set where the label map's grid is not bit by bit the scan's and follows it.</summary>
        internal const byte HasLabelGeometry = 1;

        internal PackedVolumeInfo Info { get; set; }

        internal OpacityTransferFunction Automatic { get; set; }

        internal IntensityHistogram Histogram { get; set; }

        internal SegmentTable Segments { get; set; }

        /// <summary>Voxels of each segment.</summary>
        internal long[] VoxelCounts { get; set; }

        /// <summary>The volume's warnings.</summary>
        internal string[] Warnings { get; set; }

        internal string[] IntensityWarnings { get; set; }

        internal string[] LabelWarnings { get; set; }

        internal IReadOnlyList<PackedBlock> IntensityBlocks { get; set; }

        internal IReadOnlyList<PackedBlock> LabelBlocks { get; set; }

        /// <summary>What volumes of this header share; see <see cref="SegmentedVolume.Origin"/>.</summary>
        internal object Origin { get; } = new object();

        /// <summary>The volume of this header and its voxels.</summary>
        internal SegmentedVolume MakeVolume(ushort[] codes, ushort[] indices)
        {
            var intensity = new IntensityVolume(Info.Geometry, codes, Info.CodeOffset, Info.CodeScale, Info.ValueMax, IntensityWarnings);
            var labels = new LabelMap(Info.LabelGeometry, indices, Segments, VoxelCounts, LabelWarnings);
            return new SegmentedVolume(intensity, labels, Warnings, Automatic, Histogram, Origin);
        }

        /// <summary>A coarser volume of this header.</summary>
        internal SegmentedVolume MakeVolume(VolumeGeometry coarse, ushort[] codes, ushort[] indices)
        {
            var intensity = new IntensityVolume(coarse, codes, Info.CodeOffset, Info.CodeScale, Info.ValueMax, IntensityWarnings);
            return new SegmentedVolume(intensity, new LabelMap(coarse, indices, Segments, LabelWarnings), Warnings, Automatic, null, Origin);
        }
    }
}
