using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>
    /// Reads what <see cref="PackedHeaderWriter"/> writes. Nothing is believed: a number decides on memory only after the bytes that it speaks of were found.
    /// </summary>
    static class PackedHeaderReader
    {
        const int AffineElements = 12;

        /// <summary>Label, name, colour, opacity, voxels.</summary>
        const int SmallestSegmentBytes = 1 + 1 + 3 + sizeof(float) + 1;

        const int PointBytes = 2 * sizeof(double);

        /// <summary>Reads the start and the summary.</summary>
        /// <param name="data">The whole packed volume.</param>
        internal static PackedVolumeInfo ReadInfo(ReadOnlyMemory<byte> data, ReadContext context) => ReadSummary(Open(data, context, out int headerBytes), headerBytes, data.Length, context);

        /// <summary>Reads all of it.</summary>
        /// <param name="data">The whole packed volume.</param>
        internal static PackedHeader Read(ReadOnlyMemory<byte> data, ReadContext context)
        {
            PackedFieldReader fields = Open(data, context, out int headerBytes);
            PackedVolumeInfo info = ReadSummary(fields, headerBytes, data.Length, context);
            var header = new PackedHeader { Info = info };
            header.Automatic = ReadFunction(fields, context);
            header.Histogram = ReadHistogram(fields, info.Geometry.VoxelCount, context);
            ReadSegments(fields, header, context);
            header.Warnings = fields.Texts("the warnings");
            header.IntensityWarnings = fields.Texts("the intensities' warnings");
            header.LabelWarnings = fields.Texts("the labels' warnings");
            header.IntensityBlocks = ReadDirectory(fields, "intensities", headerBytes, info.IntensityBytes, info, context);
            header.LabelBlocks = ReadDirectory(fields, "labels", headerBytes + info.IntensityBytes, info.LabelBytes, info, context);
            if (fields.Left > 0)
                throw context.Refusal("the header", $"{fields.Left} bytes too long", "an end behind the directory of blocks");
            return header;
        }

        /// <summary>Checks everything that holds for a header as a whole.</summary>
        /// <returns>At the summary.</returns>
        static PackedFieldReader Open(ReadOnlyMemory<byte> data, ReadContext context, out int headerBytes)
        {
            string magic = Encoding.ASCII.GetString(data.Span.Slice(0, Math.Min(PackedHeader.Magic.Length, data.Length)));
            if (!PackedHeader.Magic.StartsWith(magic, StringComparison.Ordinal))
                throw context.Refusal("the start", $"\"{Printable(magic)}\"", $"\"{PackedHeader.Magic}\", as packed volumes have");
            if (data.Length < PackedHeader.StartBytes)
                throw context.Refusal("the packed volume", $"cut off after {data.Length} bytes", "a header");
            var start = new PackedFieldReader(data.Slice(PackedHeader.Magic.Length), context);
            int version = start.Int32("the version");
            if (version != PackedHeader.Version)
                throw context.Refusal("the version", $"{version}", FormattableString.Invariant($"{PackedHeader.Version}: another version of AnatomyCarve packed it; pack the scan again"));
            headerBytes = start.Int32("the header's length");
            long fileBytes = start.Int64("the length");
            if (fileBytes != data.Length)
                throw context.Refusal("the length", $"{data.Length} bytes", FormattableString.Invariant($"{fileBytes} bytes, as the header says: the data are cut off or damaged"));
            int checkedBytes = headerBytes - PackedHeader.ChecksumBytes;
            if (checkedBytes < PackedHeader.StartBytes || headerBytes > data.Length)
                throw context.Refusal("the header's length", $"{headerBytes} bytes", FormattableString.Invariant($"at most the {data.Length} bytes that there are"));
            var checksum = new PackedFieldReader(data.Slice(checkedBytes, PackedHeader.ChecksumBytes), context);
            if ((ulong)checksum.Int64("the header's checksum") != Checksum64.Of(data.Span.Slice(0, checkedBytes)))
                throw context.Refusal("the header", $"damaged", "bytes that agree with their checksum");
            return new PackedFieldReader(data.Slice(PackedHeader.StartBytes, checkedBytes - PackedHeader.StartBytes), context);
        }

        static PackedVolumeInfo ReadSummary(PackedFieldReader fields, int headerBytes, long fileBytes, ReadContext context)
        {
            int sizeI = fields.Int32("the size along i"), sizeJ = fields.Int32("the size along j"), sizeK = fields.Int32("the size along k");

            // The product may overflow 64 bits, but no double.
            if (sizeI < 1 || sizeJ < 1 || sizeK < 1 || (double)sizeI * sizeJ * sizeK > VoxelBlocks.LargestCount)
                throw context.Refusal("the size", $"{sizeI} x {sizeJ} x {sizeK}", FormattableString.Invariant($"1 to {VoxelBlocks.LargestCount} voxels"));
            VolumeGeometry geometry = context.MakeGeometry(sizeI, sizeJ, sizeK, ReadAffine(fields), "the grid");
            byte flags = fields.Byte("the flags");
            if (flags > PackedHeader.HasLabelGeometry)
                throw context.Refusal("the flags", $"{flags}", "0 or 1");
            VolumeGeometry labelGeometry = flags == 0 ? geometry : context.MakeGeometry(sizeI, sizeJ, sizeK, ReadAffine(fields), "the labels' grid");
            if (!geometry.Matches(labelGeometry, out string difference))
                throw context.Refusal("the labels' grid", $"another than the scan's", "the same within a rounding. " + difference.TrimEnd('.'));
            double codeOffset = fields.Double("CodeOffset"), codeScale = fields.Double("CodeScale"), valueMax = fields.Double("ValueMax");
            if (!double.IsFinite(codeOffset) || !double.IsFinite(codeScale) || codeScale <= 0 || !double.IsFinite(valueMax) || valueMax < codeOffset)
                throw context.Refusal("the range of values", $"{codeOffset} to {valueMax} in steps of {codeScale}", "finite numbers in ascending order, and a step above 0");
            int segments = fields.Int32("the number of segments");
            if (segments < 1 || segments > SegmentTable.MaximumCount || segments > fields.Left / SmallestSegmentBytes)
                throw context.Refusal("the number of segments", $"{segments}", FormattableString.Invariant($"1 to {SegmentTable.MaximumCount}, each with its bytes in the header"));
            long intensityBytes = fields.Int64("the intensities' length"), labelBytes = fields.Int64("the labels' length");
            if (intensityBytes < 0 || labelBytes < 0 || (double)headerBytes + intensityBytes + labelBytes != fileBytes)
                throw context.Refusal("the lengths", $"{headerBytes} + {intensityBytes} + {labelBytes} bytes", FormattableString.Invariant($"{fileBytes} bytes in all"));
            long directoryBytes = 2L * PackedBlocks.Count(geometry.VoxelCount) * PackedBlock.SmallestEntryBytes;
            if (directoryBytes > fields.Left)
                throw context.Refusal("the size", $"{sizeI} x {sizeJ} x {sizeK}", "a size whose blocks the directory lists");
            return new PackedVolumeInfo(PackedHeader.Version, geometry, labelGeometry, codeOffset, codeScale, valueMax, segments, headerBytes, intensityBytes, labelBytes);
        }

        static Affine ReadAffine(PackedFieldReader fields)
        {
            var e = new double[AffineElements];
            for (int n = 0; n < AffineElements; n++)
                e[n] = fields.Double("the grid");
            return Affine.FromColumns(
                new VectorMm(e[0], e[1], e[2]), new VectorMm(e[3], e[4], e[5]), new VectorMm(e[6], e[7], e[8]), new PointMm(e[9], e[10], e[11]));
        }

        static OpacityTransferFunction ReadFunction(PackedFieldReader fields, ReadContext context)
        {
            const string what = "the transfer function";
            var points = new TransferPoint[fields.Count(what + "'s number of points", PointBytes)];
            if (points.Length == 0)
                throw context.Refusal(what, $"empty", "at least one point");
            for (int n = 0; n < points.Length; n++)
            {
                double value = fields.Double(what), opacity = fields.Double(what);
                if (!double.IsFinite(value) || !(opacity >= 0 && opacity <= 1) || (n > 0 && value < points[n - 1].Value))
                    throw context.Refusal(what, $"{value}:{opacity}", "a finite value, not below the one before, and an opacity of 0 to 1");
                points[n] = new TransferPoint(value, opacity);
            }

            return new OpacityTransferFunction(points);
        }

        static IntensityHistogram ReadHistogram(PackedFieldReader fields, long voxels, ReadContext context)
        {
            const string what = "the histogram";
            double valueMin = fields.Double(what), valueMax = fields.Double(what), binWidth = fields.Double(what);
            var counts = new long[fields.Count(what + "'s number of bins", 1)];
            long total = 0;
            for (int bin = 0; bin < counts.Length; bin++)
            {
                counts[bin] = fields.Voxels(what, voxels - total);
                total += counts[bin];
            }

            if (total != voxels)
                throw context.Refusal(what, $"one of {total} voxels", FormattableString.Invariant($"all {voxels} voxels"));
            string problem = IntensityHistogram.FindProblem(valueMin, valueMax, binWidth, counts);
            if (problem != null)
                throw context.Refusal(what, $"{valueMin} to {valueMax} in {counts.Length} bins of {binWidth}", problem);
            return new IntensityHistogram(valueMin, valueMax, binWidth, counts);
        }

        static void ReadSegments(PackedFieldReader fields, PackedHeader header, ReadContext context)
        {
            int count = header.Info.SegmentCount;
            long voxels = header.Info.Geometry.VoxelCount;
            var segments = new Segment[count];
            header.VoxelCounts = new long[count];
            long total = 0;
            for (int index = 0; index < count; index++)
            {
                string what = FormattableString.Invariant($"segment {index}");
                long label = fields.Signed(what + "'s label");
                if (index == 0 ? label != 0 : label == 0 || (index > 1 && label <= segments[index - 1].Label))
                    throw context.Refusal(what + "'s label", $"{label}", index == 0 ? "0" : "one that is not 0, and more than the label before");
                string name = fields.Text(what + "'s name");
                var color = new SegmentColor(fields.Byte(what), fields.Byte(what), fields.Byte(what));
                float opacity = fields.Float(what + "'s opacity");
                if (!(opacity >= 0 && opacity <= 1))
                    throw context.Refusal(what + "'s opacity", $"{opacity}", "0 to 1");
                segments[index] = new Segment(index, label, name, color, opacity);
                header.VoxelCounts[index] = fields.Voxels(what + "'s number of voxels", voxels - total);
                total += header.VoxelCounts[index];
            }

            if (total != voxels)
                throw context.Refusal("the segments' number of voxels", $"{total} in all", FormattableString.Invariant($"all {voxels} voxels"));
            header.Segments = new SegmentTable(segments);
        }

        static IReadOnlyList<PackedBlock> ReadDirectory(PackedFieldReader fields, string plane, long start, long bytes, PackedVolumeInfo info, ReadContext context)
        {
            var blocks = new PackedBlock[PackedBlocks.Count(info.Geometry.VoxelCount)];
            long end = start + bytes;
            for (int n = 0; n < blocks.Length; n++)
            {
                string what = FormattableString.Invariant($"block {n} of the {plane}");
                byte method = fields.Byte(what);
                if (method > (byte)BlockMethod.Runs)
                    throw context.Refusal(what + "'s method", $"{method}", "0 or 1");
                ulong length = fields.Number(what + "'s length");
                if (length > (ulong)(end - start))
                    throw context.Refusal(what + "'s length", $"{length}", FormattableString.Invariant($"at most the {end - start} bytes that are left"));
                blocks[n] = new PackedBlock((BlockMethod)method, (int)start, (int)length, (ulong)fields.Int64(what + "'s checksum"));
                start += (int)length;
            }

            if (start != end)
                throw context.Refusal("the directory of the " + plane, $"{end - start} bytes short", "blocks that fill them all");
            return blocks;
        }

        static string Printable(string text) => new string(text.Select(letter => letter >= ' ' && letter < '\u007F' ? letter : '?').ToArray());
    }
}
