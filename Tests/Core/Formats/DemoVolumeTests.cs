using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Formats;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Formats
{
    /// <summary>The scans and segmentations of ../shared/data/demo: geometry, values, and every segment's size and place.</summary>
    public sealed class DemoVolumeTests
    {
        const string Folder = "demo";

        /// <summary>expected.json gives centroids with three digits.</summary>
        const double CentroidToleranceMm = 1e-3;

        static IEnumerable<string> Files() => SharedData.FilesIn(Folder, "volumes");

        [TestCaseSource(nameof(Files))]
        public void DemoVolume_Read_MatchesExpected(string file)
        {
            JObject expected = SharedData.Expected(Folder, "volumes", file);
            VolumeData data = VolumeReader.Read(SharedData.PathOf(Folder + "/" + file));
            VolumeAssert.HasSizes(expected["dims"], data.Geometry);
            VolumeAssert.PlacesVoxels(expected["ijk_to_ras"], data.Geometry);
            Assert.That(data.Geometry.OrientationCode, Is.EqualTo((string)expected["axcodes"]));
            Assert.That(data.VoxelType.ToString(), Is.EqualTo((string)expected["stored_type"]).IgnoreCase);
            VolumeAssert.HasStoredValues(expected, data);
            VolumeAssert.HasProbes(expected["probes"], 0, data.Value);
            if (expected["labels"] != null)
                CheckLabels(expected["labels"].ToArray(), data);
        }

        static void CheckLabels(JToken[] expected, VolumeData data)
        {
            LabelMap map = LabelMap.FromVolumeData(data);
            long[] counts = map.CountVoxels();
            Assert.That(map.Segments, Has.Count.EqualTo(expected.Length + 1));
            VectorMm[] sums = SumsOfPositions(map);
            foreach (JToken label in expected)
            {
                int index = map.Segments.IndexOfLabel((long)label["label"]);
                Assert.That(index, Is.GreaterThan(0), "label " + label["label"]);
                Assert.That(counts[index], Is.EqualTo((long)label["voxels"]), "label " + label["label"]);
                VectorMm centroid = sums[index] / counts[index];
                JToken ras = label["centroid_ras"];
                Assert.That(-centroid.X, Is.EqualTo((double)ras[0]).Within(CentroidToleranceMm), "R of label " + label["label"]);
                Assert.That(-centroid.Y, Is.EqualTo((double)ras[1]).Within(CentroidToleranceMm), "A of label " + label["label"]);
                Assert.That(centroid.Z, Is.EqualTo((double)ras[2]).Within(CentroidToleranceMm), "S of label " + label["label"]);
                if (data.Segments.Count > 0)
                {
                    JToken rgb = label["rgb"];
                    Assert.That(map.Segments[index].Name, Is.EqualTo(((string)label["name"]).Replace('_', ' ')));
                    Assert.That(map.Segments[index].Color, Is.EqualTo(new SegmentColor((byte)rgb[0], (byte)rgb[1], (byte)rgb[2])), "colour of " + map.Segments[index]);
                }
            }
        }

        static VectorMm[] SumsOfPositions(LabelMap map)
        {
            var sums = new VectorMm[map.Segments.Count];
            int n = 0;
            for (int k = 0; k < map.Geometry.SizeK; k++)
                for (int j = 0; j < map.Geometry.SizeJ; j++)
                    for (int i = 0; i < map.Geometry.SizeI; i++, n++)
                    {
                        int index = map.Indices[n];
                        if (index != 0)
                            sums[index] += map.Geometry.IjkToLps.TransformPoint(new PointMm(i, j, k)) - new PointMm(0, 0, 0);
                    }
            return sums;
        }
    }
}
