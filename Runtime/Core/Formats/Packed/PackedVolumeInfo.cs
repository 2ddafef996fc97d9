using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>What a packed volume's header says, without its voxels. Immutable.</summary>
    public sealed class PackedVolumeInfo
    {
        internal PackedVolumeInfo(
            int version, VolumeGeometry geometry, VolumeGeometry labelGeometry, double codeOffset, double codeScale, double valueMax, int segmentCount,
            int headerBytes, long intensityBytes, long labelBytes)
        {
            Version = version;
            Geometry = geometry;
            LabelGeometry = labelGeometry;
            CodeOffset = codeOffset;
            CodeScale = codeScale;
            ValueMax = valueMax;
            SegmentCount = segmentCount;
            HeaderBytes = headerBytes;
            IntensityBytes = intensityBytes;
            LabelBytes = labelBytes;
        }

        /// <summary>The format's version.</summary>
        public int Version { get; }

        /// <summary>Where the voxels lie: sizes, spacing, orientation and place of the scan's grid.</summary>
        public VolumeGeometry Geometry { get; }

        /// <summary>Voxels along i, the axis that runs fastest in memory.</summary>
        public int SizeI => Geometry.SizeI;

        /// <summary>Voxels along j.</summary>
        public int SizeJ => Geometry.SizeJ;

        /// <summary>Voxels along k, the slowest axis.</summary>
        public int SizeK => Geometry.SizeK;

        /// <summary>Distances of neighbouring voxels' centres along i, j, k, mm.</summary>
        public VectorMm SpacingMm => Geometry.SpacingMm;

        /// <summary>Where i, j and k run to, such as "RAS".</summary>
        public string OrientationCode => Geometry.OrientationCode;

        /// <summary>The smallest intensity, in the scan's unit (Hounsfield units for CT).</summary>
        public double ValueMin => CodeOffset;

        /// <summary>The largest intensity, in the scan's unit.</summary>
        public double ValueMax { get; }

        /// <summary>The number of segments, label 0 included.</summary>
        public int SegmentCount { get; }

        /// <summary>All bytes of the packed volume: header, intensities and labels.</summary>
        public long PackedBytes => HeaderBytes + IntensityBytes + LabelBytes;

        /// <summary>The header's bytes: everything that is no voxel.</summary>
        public int HeaderBytes { get; }

        /// <summary>The bytes that the intensities take when they are packed.</summary>
        public long IntensityBytes { get; }

        /// <summary>The bytes that the labels take when they are packed.</summary>
        public long LabelBytes { get; }

        /// <summary>The bytes of the voxels in memory after reading: two of intensity and two of label each.</summary>
        public long UnpackedBytes => Geometry.VoxelCount * (sizeof(ushort) + sizeof(ushort));

        internal VolumeGeometry LabelGeometry { get; }

        internal double CodeOffset { get; }

        internal double CodeScale { get; }
    }
}
