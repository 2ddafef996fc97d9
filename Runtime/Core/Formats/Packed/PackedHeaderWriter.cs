using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>
    /// Writes the header of a packed volume. Version 1, all little-endian, no gaps; "number" and "text" as <see cref="PackedFieldWriter"/> writes them:
    /// <code>
    /// start      8 bytes "ACVOLUME"; int32 version; int32 bytes of the header, from the first to its checksum's last; int64 bytes of the file
    /// summary    3 int32 voxels along i, j, k
    ///            12 doubles: i, j, k to LPS mm, column by column (i, j, k, origin)
    ///            byte flags: 1 = the labels' grid differs by a rounding, 12 doubles more
    ///            doubles CodeOffset, CodeScale, ValueMax
    ///            int32 segments; int64 bytes of all intensity blocks; int64 bytes of all label blocks
    /// function   number of points; for each: double value, double opacity
    /// histogram  doubles ValueMin, ValueMax, BinWidth; number of bins; for each: number of voxels
    /// segments   for each: signed label, text name, 3 bytes sRGB, float opacity, number of voxels
    /// warnings   texts of the volume, of the intensities, of the labels
    /// blocks     for each block of intensities, then of labels: byte method, number of bytes, uint64 checksum (XXH64) of them
    /// checksum   uint64 XXH64 of all header bytes before it
    /// </code>
    /// The header is followed by the blocks' bytes, in the directory's order. A block is 131,072 voxels in memory's order (i fastest), a plane's last may
    /// have fewer; it refers to no voxel outside itself, so blocks decode in any order, on any thread. Methods: <see cref="TileEncoder"/>, <see cref="RunEncoder"/>.
    /// </summary>
    static class PackedHeaderWriter
    {
        /// <summary>Writes a header with its checksum.</summary>
        /// <param name="intensity">The directory of the intensities; where the blocks start is left out.</param>
        /// <param name="labels">The directory of the labels.</param>
        internal static byte[] Write(SegmentedVolume volume, IReadOnlyList<PackedBlock> intensity, IReadOnlyList<PackedBlock> labels)
        {
            var fields = new PackedFieldWriter();
            foreach (char letter in PackedHeader.Magic)
                fields.Byte((byte)letter);
            fields.Int32(PackedHeader.Version);
            int lengthsPlace = fields.Length;
            fields.Int32(0);
            fields.Int64(0);
            long blockBytes = WriteSummary(fields, volume, intensity, labels);
            WriteFunction(fields, volume.AutomaticTransferFunction);
            WriteHistogram(fields, volume.Histogram);
            WriteSegments(fields, volume.Labels);
            fields.Texts(volume.Warnings);
            fields.Texts(volume.Intensity.Warnings);
            fields.Texts(volume.Labels.Warnings);
            WriteDirectory(fields, intensity);
            WriteDirectory(fields, labels);

            int headerBytes = fields.Length + PackedHeader.ChecksumBytes;
            BinaryPrimitives.WriteInt32LittleEndian(fields.Written.Slice(lengthsPlace), headerBytes);
            BinaryPrimitives.WriteInt64LittleEndian(fields.Written.Slice(lengthsPlace + sizeof(int)), headerBytes + blockBytes);
            fields.Int64((long)Checksum64.Of(fields.Written));
            return fields.Written.ToArray();
        }

        static long WriteSummary(PackedFieldWriter fields, SegmentedVolume volume, IReadOnlyList<PackedBlock> intensity, IReadOnlyList<PackedBlock> labels)
        {
            VolumeGeometry geometry = volume.Geometry;
            fields.Int32(geometry.SizeI);
            fields.Int32(geometry.SizeJ);
            fields.Int32(geometry.SizeK);
            WriteAffine(fields, geometry.IjkToLps);
            bool sameGrid = Elements(geometry.IjkToLps).SequenceEqual(Elements(volume.Labels.Geometry.IjkToLps));
            fields.Byte(sameGrid ? (byte)0 : PackedHeader.HasLabelGeometry);
            if (!sameGrid)
                WriteAffine(fields, volume.Labels.Geometry.IjkToLps);
            fields.Double(volume.Intensity.CodeOffset);
            fields.Double(volume.Intensity.CodeScale);
            fields.Double(volume.Intensity.ValueMax);
            fields.Int32(volume.Segments.Count);
            long intensityBytes = intensity.Sum(block => (long)block.Length), labelBytes = labels.Sum(block => (long)block.Length);
            fields.Int64(intensityBytes);
            fields.Int64(labelBytes);
            return intensityBytes + labelBytes;
        }

        static void WriteAffine(PackedFieldWriter fields, Affine map)
        {
            foreach (long bits in Elements(map))
                fields.Int64(bits);
        }

        /// <summary>The elements' bits, so that a negative zero is not a zero.</summary>
        static IEnumerable<long> Elements(Affine map)
        {
            VectorMm i = map.Column(0), j = map.Column(1), k = map.Column(2);
            PointMm origin = map.Origin;
            return new[] { i.X, i.Y, i.Z, j.X, j.Y, j.Z, k.X, k.Y, k.Z, origin.X, origin.Y, origin.Z }.Select(BitConverter.DoubleToInt64Bits);
        }

        static void WriteFunction(PackedFieldWriter fields, OpacityTransferFunction function)
        {
            fields.Number((ulong)function.Points.Count);
            foreach (TransferPoint point in function.Points)
            {
                fields.Double(point.Value);
                fields.Double(point.Opacity);
            }
        }

        static void WriteHistogram(PackedFieldWriter fields, IntensityHistogram histogram)
        {
            fields.Double(histogram.ValueMin);
            fields.Double(histogram.ValueMax);
            fields.Double(histogram.BinWidth);
            fields.Number((ulong)histogram.Counts.Count);
            foreach (long count in histogram.Counts)
                fields.Number((ulong)count);
        }

        static void WriteSegments(PackedFieldWriter fields, LabelMap labels)
        {
            foreach (Segment segment in labels.Segments)
            {
                fields.Signed(segment.Label);
                fields.Text(segment.Name);
                fields.Byte(segment.Color.R);
                fields.Byte(segment.Color.G);
                fields.Byte(segment.Color.B);
                fields.Float(segment.Opacity);
                fields.Number((ulong)labels.VoxelCounts[segment.Index]);
            }
        }

        static void WriteDirectory(PackedFieldWriter fields, IReadOnlyList<PackedBlock> blocks)
        {
            foreach (PackedBlock block in blocks)
            {
                fields.Byte((byte)block.Method);
                fields.Number((ulong)block.Length);
                fields.Int64((long)block.Checksum);
            }
        }
    }
}
