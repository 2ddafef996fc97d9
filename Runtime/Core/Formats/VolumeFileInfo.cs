using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>What a file's header says, before any voxel is read. Immutable.</summary>
    public sealed class VolumeFileInfo
    {
        internal VolumeFileInfo(VolumeGeometry geometry, VoxelType voxelType, long components, bool isCompressed, VolumeDescription description)
        {
            Geometry = geometry;
            VoxelType = voxelType;
            Components = components;
            IsCompressed = isCompressed;
            Segments = description.Segments.ToArray();
            Source = description.Source;
            Format = description.Format;
        }

        /// <summary>Where the voxels lie.</summary>
        public VolumeGeometry Geometry { get; }

        /// <summary>The type that they are stored in.</summary>
        public VoxelType VoxelType { get; }

        /// <summary>Values per voxel, at least 1.</summary>
        public long Components { get; }

        /// <summary>Whether the voxels' bytes are known only when they have been inflated or parsed.</summary>
        public bool IsCompressed { get; }

        /// <summary>The segments that the file names; empty if none.</summary>
        public IReadOnlyList<SegmentInfo> Segments { get; }

        /// <summary>The file, or what the caller named the stream.</summary>
        public string Source { get; }

        /// <summary>The file format's name, such as "NIfTI-1" or "NRRD".</summary>
        public string Format { get; }

        /// <summary>Bytes of the voxels as they are stored.</summary>
        public long StoredBytes => Geometry.VoxelCount * Components * VoxelType.SizeOf();
    }
}
