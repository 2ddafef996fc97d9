using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>What `carve info` prints, against what independent readers found in the same files.</summary>
    sealed class InfoTests
    {
        const double GeometryTolerance = 1e-4;

        static readonly string[] Fields =
            ["dims", "spacing", "originLps", "directionLps", "ijkToRas", "voxelType", "components", "min", "max", "mean", "sha256", "segments"];

        // Pairs, detached headers, NIfTI-2 and bzip2 are refused by name so far.
        static bool IsRefusedSoFar(JsonNode entry)
        {
            var file = (string)entry["file"];
            return file.EndsWith(".nhdr", StringComparison.Ordinal) || file.Contains(".hdr", StringComparison.Ordinal)
                || file.Contains("/n2_", StringComparison.Ordinal) || file.Contains("bzip2", StringComparison.Ordinal)
                    || file.Contains("_bz2", StringComparison.Ordinal);
        }

        static IEnumerable<TestCaseData> ReadableFiles() =>
            Entries("readers", "files")
                .Where(entry => (string)entry["format"] is "nifti" or "nrrd" && (string)entry["expect"] == "ok" && !IsRefusedSoFar(entry))
                .Concat(Entries("demo", "volumes"))
                .Select(entry => new TestCaseData(entry).SetName($"Info_Of_{Path.GetFileName((string)entry["file"])}_IsAsExpected"))
                .DefaultIfEmpty(NothingShared("Info_OfReadableFiles_IsAsExpected"));

        static IEnumerable<TestCaseData> MalformedFiles() =>
            Entries("readers", "malformed").Where(entry => (string)entry["expect"] == "refuse")
                .Select(entry => new TestCaseData(entry).SetName($"Info_Of_{Path.GetFileName((string)entry["file"])}_IsRefusedInOneLine"))
                .DefaultIfEmpty(NothingShared("Info_OfMalformedFiles_IsRefusedInOneLine"));

        [TestCaseSource(nameof(ReadableFiles))]
        public void Info_OfFile_IsAsExpected(JsonNode expected)
        {
            var result = Carve.InProcess("info", (string)expected["path"], "--json");

            Assert.That(result.ExitCode, Is.Zero, result.Error);
            var info = JsonNode.Parse(result.Output).AsObject();
            Assert.That(info.Select(field => field.Key), Is.EqualTo(Fields));
            Assert.That(Numbers(info["dims"]), Is.EqualTo(Numbers(expected["dims"])));
            if ((string)expected["file"] != "nifti/units_micron.nii") GeometryIsAsExpected(info, expected);
            Assert.That((string)info["voxelType"], Is.EqualTo((string)expected["stored_type"]));
            Assert.That((int)info["components"], Is.EqualTo((int?)expected["components"] ?? 1));
            ValuesAreAsExpected(info, expected);
            if (expected["segments"] is JsonArray { Count: > 0 } segments)
            {
                Assert.That(info["segments"].AsArray().Select(segment => (string)segment["name"]),
                    Is.EqualTo(segments.Select(segment => (string)segment["name"])));
                Assert.That(info["segments"].AsArray().Select(segment => (long)segment["label"]),
                    Is.EqualTo(segments.Select(segment => (long)segment["label_value"])));
            }
        }

        [TestCaseSource(nameof(MalformedFiles))]
        public void Info_OfMalformedFile_IsRefusedInOneLine(JsonNode expected)
        {
            var result = Carve.InProcess("info", (string)expected["path"]);

            Assert.That(result.ExitCode, Is.EqualTo(1));
            Assert.That(result.ErrorLines, Has.Length.EqualTo(1), result.Error);
            Assert.That(result.Error, Does.Contain(Path.GetFileName((string)expected["path"])));
            Assert.That(result.Output, Is.Empty);
        }

        [Test]
        public void Info_OfMissingFile_IsRefusedInOneLine()
        {
            var result = Carve.InProcess("info", "nowhere.nrrd");

            Assert.That((result.ExitCode, result.ErrorLines.Length), Is.EqualTo((1, 1)), result.Error);
            Assert.That(result.Error, Does.StartWith("carve: nowhere.nrrd: "));
        }

        [Test]
        public void Info_ForPeople_NamesSegmentsAndGeometry()
        {
            var result = Carve.InProcess("info", RepositoryFiles.Demo("Colin27.seg.nrrd"));

            Assert.That(result.ExitCode, Is.Zero, result.Error);
            Assert.That(result.Output, Does.Contain("181 x 216 x 176 voxels"));
            Assert.That(result.Output, Does.Contain("Hippocampus_L"));
            Assert.That(result.Output, Does.Contain("1  1  1 mm"));
        }

        // Not for the file in micrometres, whose expected geometry is that of the raw header numbers.
        static void GeometryIsAsExpected(JsonObject info, JsonNode expected)
        {
            Assert.That(Numbers(info["spacing"]), Is.EqualTo(Numbers(expected["spacing"])).Within(GeometryTolerance));
            foreach (var (name, expectedName) in new[] { ("ijkToRas", "ijk_to_ras"), ("originLps", "origin_lps"), ("directionLps", "direction_lps") })
            {
                // Left out where the file does not say where it lies.
                if (expected[expectedName] == null) continue;
                Assert.That(Numbers(info[name]), Is.EqualTo(Numbers(expected[expectedName])).Within(GeometryTolerance), name);
            }
        }

        static void ValuesAreAsExpected(JsonObject info, JsonNode expected)
        {
            // demo/expected.json has the statistics beside the geometry, readers/expected.json under "stored", and under "scaled" where slope and intercept
            // count.
            var scaled = expected["scaled"];
            var statistics = scaled ?? expected["stored"] ?? expected;
            foreach (var name in new[] { "min", "max", "mean" })
                Assert.That((double?)info[name], Is.EqualTo((double?)statistics[name]).Within(scaled == null ? 1e-9 : 1e-5).Percent
                    .Or.EqualTo((double?)statistics[name]), name);
            if (scaled == null) Assert.That((string)info["sha256"], Is.EqualTo((string)statistics["sha256_f64_le"]));
        }

        static double[] Numbers(JsonNode node) => node is JsonArray array ? array.SelectMany(Numbers).ToArray() : [(double)node];

        static IEnumerable<JsonNode> Entries(string folder, string list)
        {
            var expected = RepositoryFiles.Shared("data", folder, "expected.json");
            if (expected == null) yield break;
            foreach (var entry in JsonNode.Parse(File.ReadAllText(expected))[list].AsArray())
            {
                entry["path"] = RepositoryFiles.Shared("data", folder, (string)entry["file"]);
                if (entry["path"] != null) yield return entry;
            }
        }

        static TestCaseData NothingShared(string name) => new TestCaseData((object)null).SetName(name).Ignore("The test data of ../shared is absent.");
    }
}
