using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Formats;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Formats
{
    /// <summary>Every intact file of ../shared/data/readers, against what independent readers see in it.</summary>
    public sealed class ReaderConformanceTests
    {
        const string Folder = "readers";

        /// <summary>Formats and variants that are refused by name; the word that the message must hold.</summary>
        static string RefusedAs(JObject expected)
        {
            string file = (string)expected["file"];
            string format = (string)expected["format"];
            return format == "dicom" ? "DICOM"
                : format == "meta" || format == "metaimage" || file.EndsWith(".mha") || file.EndsWith(".mhd") ? "MetaImage"
                : file.EndsWith(".nhdr") ? "detached"
                : file.Contains("bzip2") || file.Contains("_bz2") ? "bzip2"
                : file.Contains("/n2_") ? "NIfTI-2"
                : file.EndsWith(".hdr") || file.EndsWith(".hdr.gz") ? "pairs"
                : null;
        }

        static IEnumerable<string> Files() => SharedData.FilesIn(Folder, "files").Where(file => !file.StartsWith("dicom/"));

        [TestCaseSource(nameof(Files))]
        public void IntactFile_Read_MatchesExpectedOrIsRefusedByName(string file)
        {
            JObject expected = SharedData.Expected(Folder, "files", file);
            string path = SharedData.PathOf(Folder + "/" + file);
            string refusedAs = RefusedAs(expected);
            if (refusedAs != null)
            {
                var refusal = Assert.Throws<VolumeFormatException>(() => VolumeReader.Read(path));
                Assert.That(refusal.Message, Does.Contain(refusedAs).And.Contain(path));
                return;
            }

            VolumeData data = VolumeReader.Read(path);
            VolumeAssert.HasSizes(expected["dims"], data.Geometry);
            Assert.That(data.Components, Is.EqualTo((int)expected["components"]));
            Assert.That(data.ComponentOrder.ToString(), Is.EqualTo((string)expected["component_order"]).IgnoreCase);
            Assert.That(data.VoxelType.ToString(), Is.EqualTo((string)expected["stored_type"]).IgnoreCase);
            CheckGeometry(expected, data.Geometry);
            VolumeAssert.HasStoredValues(expected["stored"], data);
            VolumeAssert.HasProbes(expected["probes"], 0, StoredValueOf(data));
            CheckScaling(expected, data);
            CheckKeyValues(expected, data);
            CheckSegments(expected, data);
        }

        static Func<int, int, int, int, double> StoredValueOf(VolumeData data) =>
            (i, j, k, component) =>
            {
                long voxel = i + ((long)data.Geometry.SizeI * (j + ((long)data.Geometry.SizeJ * k)));
                return data.StoredValue(
                    data.ComponentOrder == ComponentOrder.Fastest ? (voxel * data.Components) + component : voxel + (component * data.Geometry.VoxelCount));
            };

        static void CheckGeometry(JObject expected, VolumeGeometry geometry)
        {
            // This one file is in micrometres, and the expected numbers are those of its header.
            double unitMm = ((string)expected["file"]).Contains("micron") ? 0.001 : 1;
            var spacing = new[] { geometry.SpacingMm.X, geometry.SpacingMm.Y, geometry.SpacingMm.Z };
            for (int axis = 0; axis < 3; axis++)
                Assert.That(spacing[axis], Is.EqualTo((double)expected["spacing"][axis] * unitMm).Within(VolumeAssert.ToleranceMm), "spacing " + axis);
            if (expected["ijk_to_ras"].Type != JTokenType.Null)
                VolumeAssert.PlacesVoxels(expected["ijk_to_ras"], geometry, unitMm);
            if (expected["direction_lps"].Type == JTokenType.Null)
                return;
            double[,] direction = geometry.Direction();
            for (int element = 0; element < 9; element++)
                Assert.That(
                    direction[element / 3, element % 3], Is.EqualTo((double)expected["direction_lps"][element / 3][element % 3]).Within(VolumeAssert.ToleranceMm), "direction");
        }

        static void CheckScaling(JObject expected, VolumeData data)
        {
            JToken scaling = expected["scl"];
            bool applied = scaling != null && scaling.Type != JTokenType.Null && (bool)scaling["applied"];
            Assert.That(data.Slope, Is.EqualTo(applied ? (double)scaling["slope"] : 1).Within(1e-7));
            Assert.That(data.Intercept, Is.EqualTo(applied ? (double)scaling["inter"] : 0).Within(1e-7));
            if (expected["scaled"] != null)
            {
                double relative = (double)expected["scaled"]["tolerance_rel"];
                VolumeAssert.HasStatistics(expected["scaled"], data.Statistics(), relative);
                VolumeAssert.HasProbes(expected["scaled"]["probes"], relative, data.Value);
            }
        }

        static void CheckKeyValues(JObject expected, VolumeData data)
        {
            foreach (JProperty pair in ((JObject)expected["key_values"] ?? new JObject()).Properties())
                Assert.That(data.Metadata.TryGetValue(pair.Name, out string value) ? value : null, Is.EqualTo((string)pair.Value), pair.Name);
        }

        static void CheckSegments(JObject expected, VolumeData data)
        {
            JToken[] segments = (expected["segments"] as JArray ?? new JArray()).ToArray();
            Assert.That(data.Segments, Has.Count.EqualTo(segments.Length));
            for (int n = 0; n < segments.Length; n++)
            {
                SegmentInfo segment = data.Segments[n];
                Assert.That(segment.Id, Is.EqualTo((string)segments[n]["id"]));
                Assert.That(segment.Name, Is.EqualTo((string)segments[n]["name"]));
                Assert.That(segment.LabelValue, Is.EqualTo((long)segments[n]["label_value"]));
                Assert.That(segment.Layer, Is.EqualTo((int)segments[n]["layer"]));
                Assert.That(segment.Extent, Is.EqualTo(segments[n]["extent"].Select(index => (int)index).ToArray()));
                JToken color = segments[n]["color"];
                Assert.That(segment.Color, Is.EqualTo(SegmentColor.FromFloats((double)color[0], (double)color[1], (double)color[2])));
                Assert.That(CountVoxels(data, segment), Is.EqualTo((long)segments[n]["voxels"]), segment.ToString());
            }
        }

        static long CountVoxels(VolumeData data, SegmentInfo segment)
        {
            long count = 0;
            for (long voxel = 0; voxel < data.Geometry.VoxelCount; voxel++)
            {
                long index = data.ComponentOrder == ComponentOrder.Fastest
                    ? (voxel * data.Components) + segment.Layer
                    : voxel + (segment.Layer * data.Geometry.VoxelCount);
                count += data.StoredValue(index) == segment.LabelValue ? 1 : 0;
            }

            return count;
        }
    }
}
