using System;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Files;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>A rendering of the phantom from the front, in a process of its own, with everything that can be written.</summary>
    sealed class RenderTests
    {
        const int Width = 90, Height = 60;
        const ushort Nothing = 65535;

        TestFolder folder;
        CarveResult result;
        Plane<byte> picture;
        Plane<ushort> segments;
        Plane<float> depth;
        JsonNode report;

        [OneTimeSetUp]
        public void Render()
        {
            folder = new TestFolder();
            result = Render("whole");
            picture = PngFile.ReadRgb(folder["whole.png"]);
            segments = PgmFile.Read(folder["whole.pgm"]);
            depth = PfmFile.Read(folder["whole.pfm"]);
            report = JsonNode.Parse(File.ReadAllText(folder["whole.json"]));
        }

        [OneTimeTearDown]
        public void DeleteFolder() => folder.Dispose();

        [Test]
        public void Render_WithAllOutputs_WritesThemAndNothingElse()
        {
            Assert.That(folder.FileNames.Where(name => name.StartsWith("whole", StringComparison.Ordinal)),
                Is.EqualTo(new[] { "whole.json", "whole.pfm", "whole.pgm", "whole.png" }));
            Assert.That(folder.FileNames.Where(name => name.EndsWith(".part", StringComparison.Ordinal)), Is.Empty);
            Assert.That(result.Output.Trim(), Is.EqualTo(folder["whole.png"]));
            Assert.That(result.Error, Is.Empty);
        }

        [Test]
        public void Render_OfSize_GivesPicturesOfThatSize()
        {
            Assert.That((picture.Width / 3, picture.Height), Is.EqualTo((Width, Height)));
            Assert.That((segments.Width, segments.Height), Is.EqualTo((Width, Height)));
            Assert.That((depth.Width, depth.Height), Is.EqualTo((Width, Height)));
        }

        [Test]
        public void Render_FromTheFront_ShowsThePatientsRightAtTheViewersLeft()
        {
            const int row = Height / 2 + 3;
            var seen = Enumerable.Range(0, Width).Select(x => segments.Values[row * Width + x]).Where(index => index != Nothing).ToArray();

            Assert.That(seen[0], Is.EqualTo(IndexOf("right")));
            Assert.That(seen[^1], Is.EqualTo(IndexOf("left")));
        }

        [Test]
        public void Render_FirstRow_IsTheTop()
        {
            var first = Array.FindIndex(segments.Values, index => index != Nothing);
            var last = Array.FindLastIndex(segments.Values, index => index != Nothing);

            Assert.That(segments.Values[first], Is.EqualTo(IndexOf("top")));
            Assert.That(segments.Values[last], Is.Not.EqualTo(IndexOf("top")));
        }

        [Test]
        public void Render_Picture_ShowsTheSegmentsColours()
        {
            foreach (var (name, channel) in new[] { ("top", 0), ("left", 1), ("right", 2) })
            {
                // The middle of what is seen of the segment.
                var pixels = Enumerable.Range(0, Width * Height).Where(pixel => segments.Values[pixel] == IndexOf(name)).ToArray();
                var middle = pixels[pixels.Length / 2];
                var rgb = picture.Values.AsSpan(middle * 3, 3).ToArray();
                Assert.That(rgb[channel], Is.GreaterThan(100).And.EqualTo(rgb.Max()), $"{name}: {string.Join(' ', rgb)}");
            }
        }

        [Test]
        public void Render_WhereNothingIs_IsBackgroundAndInfinitelyFar()
        {
            Assert.That(segments.Values[0], Is.EqualTo(Nothing));
            Assert.That(depth.Values[0], Is.EqualTo(float.PositiveInfinity));
            Assert.That(picture.Values[..3], Is.EqualTo(new byte[] { 0x10, 0x20, 0x30 }));
            for (var pixel = 0; pixel < segments.Values.Length; pixel++)
                Assert.That(float.IsFinite(depth.Values[pixel]), Is.EqualTo(segments.Values[pixel] != Nothing), $"pixel {pixel}");
        }

        [Test]
        public void Render_Depth_IsTheWayToTheFrontFace()
        {
            // Eye 200 mm in front of the block's centre (voxel 11.5, 9.5, 7.5); its first row of voxels is j = 3.
            const double toFace = 200 - (9.5 - 3) * Phantom.Spacing;
            var middle = depth.Values[(Height / 2) * Width + Width / 2];

            Assert.That(middle, Is.EqualTo(toFace).Within(Phantom.Spacing));
        }

        [Test]
        public void Render_Report_CountsWhatTheSegmentsShow()
        {
            foreach (var segment in report["segments"].AsArray())
                Assert.That((int)segment["visiblePixels"], Is.EqualTo(segments.Values.Count(index => index == (int)segment["index"])), (string)segment["name"]);
            Assert.That(report["segments"].AsArray().Select(segment => (long)segment["label"]), Is.EqualTo(new long[] { 0, 1, 2, 5 }));
            Assert.That(report["stages"].AsArray().Select(stage => (string)stage["name"]),
                Is.EqualTo(new[] { "ClipVoxels", "AntiAlias", "SobelNormals", "Raymarch" }));
            Assert.That((long)report["stages"][0]["voxels"], Is.GreaterThanOrEqualTo(Phantom.SizeI * Phantom.SizeJ * Phantom.SizeK));
            Assert.That((long)report["stages"][3]["samples"], Is.Positive);
            Assert.That((long)report["bytesResident"], Is.Positive);
            Assert.That((string)report["device"]["name"], Is.Not.Empty);
            Assert.That((string)report["outputs"]["picture"], Is.EqualTo("whole.png"));
            Assert.That((string)report["quality"]["filter"], Is.EqualTo("exact"));
            Assert.That(report["warnings"].AsArray(), Is.Empty);
        }

        [Test]
        public void Render_WithCarving_HidesWhatItsMaskNames()
        {
            folder.Write("carving.json", """
                {"version": 1, "space": "LPS", "spheres": [{"centerMm": [23, 19, 15], "radiusMm": 60, "clipped": [{"label": 1, "name": "left"}]}]}
                """);
            Render("carved", "--carving", folder["carving.json"]);
            var carved = PgmFile.Read(folder["carved.pgm"]).Values;

            Assert.That(carved.Count(index => index == IndexOf("left")), Is.Zero);
            // Its edge to the cut is another one than its edge to the left part.
            Assert.That(carved.Count(index => index == IndexOf("right")),
                Is.EqualTo(segments.Values.Count(index => index == IndexOf("right"))).Within(5).Percent);
        }

        [Test]
        public void Render_OfTheSameTwice_IsTheSame()
        {
            Render("again");

            foreach (var extension in new[] { ".png", ".pgm", ".pfm" })
                Assert.That(File.ReadAllBytes(folder["again" + extension]), Is.EqualTo(File.ReadAllBytes(folder["whole" + extension])), extension);
        }

        [Test]
        public void Render_WithRasCamera_IsTheSameAsWithLps()
        {
            folder.Write("ras.json", """{"space": "RAS", "eyeMm": [-23, 181, 15], "targetMm": [-23, -19, 15], "up": [0, 0, 1], "verticalFovDegrees": 20}""");
            Render("ras", "--camera", folder["ras.json"]);

            Assert.That(File.ReadAllBytes(folder["ras.pgm"]), Is.EqualTo(File.ReadAllBytes(folder["whole.pgm"])));
        }

        [Test]
        public void Render_WithoutLabels_ShowsOneUnlabelledSegment()
        {
            var unlabelled = Carve.Process("render", Phantom.WriteVolume(folder, "plain.nrrd"), "--camera", "90,0", "--quality", "fast", "--size", "32x32",
                "--output", folder["plain.png"], "--report", folder["plain.json"]);

            Assert.That(unlabelled.ExitCode, Is.Zero, unlabelled.Error);
            var row = JsonNode.Parse(File.ReadAllText(folder["plain.json"]))["segments"].AsArray().Single();
            Assert.That((int)row["visiblePixels"], Is.Positive);
        }

        [Test]
        public void Render_WithAntiAliasing_UsesIt()
        {
            Assert.That((double)report["quality"]["antiAliasing"], Is.EqualTo(1));
            Render("half", "--anti-aliasing", "0.5");

            Assert.That((double)JsonNode.Parse(File.ReadAllText(folder["half.json"]))["quality"]["antiAliasing"], Is.EqualTo(0.5));
        }

        [Test]
        public void Render_OfOddFiles_SaysSoOnTheErrorStreamAndInTheReport()
        {
            folder.Write("foreign.json", """
                {"version": 1, "space": "LPS", "spheres": [{"centerMm": [0, 0, 0], "radiusMm": 5, "clipped": [{"label": 77, "name": "elsewhere"}]}]}
                """);
            var odd = Carve.Process("render", Phantom.WriteUnorientedVolume(folder), "--carving", folder["foreign.json"], "--tf", "0:0,50:1",
                "--quality", "fast", "--size", "16x16", "--output", folder["odd.png"], "--report", folder["odd.json"]);

            Assert.That(odd.ExitCode, Is.Zero, odd.Error);
            var lines = odd.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries);
            Assert.That(lines, Has.All.StartsWith("warning: "));
            Assert.That(lines, Has.One.Contains("no orientation").And.One.Contains("elsewhere"));
            Assert.That(JsonNode.Parse(File.ReadAllText(folder["odd.json"]))["warnings"].AsArray().Select(warning => "warning: " + (string)warning),
                Is.EqualTo(lines));
        }

        int IndexOf(string name) =>
            (int)report["segments"].AsArray().Single(segment => (string)segment["name"] == name)["index"];

        CarveResult Render(string name, params string[] more)
        {
            folder.Write("front.json", """{"space": "LPS", "eyeMm": [23, -181, 15], "targetMm": [23, 19, 15], "up": [0, 0, 1], "verticalFovDegrees": 20}""");
            string[] camera = more.Contains("--camera") ? [] : ["--camera", folder["front.json"]];
            var rendered = Carve.Process(["render", Phantom.WriteVolume(folder), "--labels", Phantom.WriteLabels(folder), "--tf", "0:0,50:1",
                "--size", $"{Width}x{Height}", "--background", "#102030", "--output", folder[name + ".png"], "--depth", folder[name + ".pfm"],
                "--segments", folder[name + ".pgm"], "--report", folder[name + ".json"], .. camera, .. more]);
            Assert.That(rendered.ExitCode, Is.Zero, rendered.Error);
            return rendered;
        }
    }
}
