using System;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>Renderings whose input is bad: exit code 1, one line that names the culprit, nothing written.</summary>
    sealed class BadRenderTests
    {
        const string Camera = """{"space": "LPS", "eyeMm": [23, -181, 15], "targetMm": [23, 19, 15], "up": [0, 0, 1], "verticalFovDegrees": 20}""";

        TestFolder folder;

        [SetUp]
        public void MakeFolder() => folder = new TestFolder();

        [TearDown]
        public void DeleteFolder() => folder.Dispose();

        [Test]
        public void Render_OfMissingVolume_IsRefused() => IsRefused("missing.nrrd", Carve.InProcess, volume: folder["missing.nrrd"]);

        [Test]
        public void Render_WithMissingLabels_IsRefused() => IsRefused("missing.seg.nrrd", Carve.InProcess, null, "--labels", folder["missing.seg.nrrd"]);

        [Test]
        public void Render_WithMissingCarving_IsRefused() => IsRefused("missing.json", Carve.InProcess, null, "--carving", folder["missing.json"]);

        [Test]
        public void Render_WithMissingCamera_IsRefused() => IsRefused("missing.json", Carve.InProcess, null, "--camera", folder["missing.json"]);

        [TestCase("no JSON", "not a camera")]
        [TestCase("{}", "space")]
        [TestCase("""{"space": "MNI", "eyeMm": [23, -181, 15], "targetMm": [23, 19, 15], "up": [0, 0, 1], "verticalFovDegrees": 20}""", "\"space\" is \"MNI\"")]
        [TestCase("""{"space": "LPS", "eyeMm": [23, -181], "targetMm": [23, 19, 15], "up": [0, 0, 1], "verticalFovDegrees": 20}""", "\"eyeMm\" is [23,-181]")]
        [TestCase("""{"space": "LPS", "eyeMm": [23, -181, 15], "targetMm": [23, -181, 15], "up": [0, 0, 1], "verticalFovDegrees": 20}""", "same point")]
        [TestCase("""{"space": "LPS", "eyeMm": [23, -181, 15], "targetMm": [23, 19, 15], "up": [0, 2, 0], "verticalFovDegrees": 20}""", "up")]
        [TestCase("""{"space": "LPS", "eyeMm": [23, -181, 15], "targetMm": [23, 19, 15], "up": [0, 0, 1], "verticalFovDegrees": 180}""",
            "\"verticalFovDegrees\" is 180")]
        [TestCase("""{"space": "LPS", "eyeMm": [23, -181, 15], "targetMm": [23, 19, 15], "up": [0, 0, 1]}""", "missing")]
        [TestCase("""{"space": "LPS", "eyeMm": [1e300, 0, 0], "targetMm": [23, 19, 15], "up": [0, 0, 1], "verticalFovDegrees": 20}""", "1E+300")]
        [TestCase("""{"space": "LPS", "eyeMm": [NaN, 0, 0], "targetMm": [23, 19, 15], "up": [0, 0, 1], "verticalFovDegrees": 20}""", "NaN")]
        [TestCase(Camera + " {}", "not a camera")]
        [TestCase(Camera + " and more", "not a camera")]
        public void Render_WithBadCamera_IsRefused(string json, string culprit) =>
            IsRefused(culprit, Carve.InProcess, null, "--camera", folder.Write("camera.json", json));

        [TestCase("somewhere")]
        [TestCase("0:0,100")]
        [TestCase("0:zero,100:1")]
        [TestCase("0:0,100:7")]
        public void Render_WithBadTransferFunction_IsRefused(string text) => IsRefused("--tf", Carve.InProcess, null, "--tf", text);

        [Test]
        public void Render_OfAFolder_SaysSo() => IsRefused("this is a folder", Carve.InProcess, folder.Path);

        [Test]
        public void Render_WithAFolderAsTransferFunction_SaysSo() => IsRefused("this is a folder", Carve.InProcess, null, "--tf", folder.Path);

        [Test]
        public void Render_IntoAFolderThatTakesNoFiles_IsRefusedByTheOutputsName()
        {
            if (!Directory.Exists("/proc")) Assert.Ignore("There is no folder here that takes no files of anyone.");
            IsRefused("/proc/depth.pfm", Carve.InProcess, null, "--depth", "/proc/depth.pfm");
        }

        [Test]
        public void Render_IntoMissingFolder_IsRefused() =>
            IsRefused("folder", Carve.InProcess, null, "--depth", Path.Combine(folder.Path, "nowhere", "depth.pfm"));

        [Test]
        public void Render_OntoAFolder_IsRefused()
        {
            Directory.CreateDirectory(folder["taken.pfm"]);

            IsRefused("taken.pfm", Carve.InProcess, null, "--depth", folder["taken.pfm"]);
        }

        [Test]
        public void Render_OfSomethingElse_IsRefused() => IsRefused("text.nrrd", Carve.Process, folder.Write("text.nrrd", "this is no volume"));

        [Test]
        public void Render_WithoutVulkanDriver_SaysSo() =>
            IsRefused("No Vulkan driver is installed", arguments => Carve.Process(arguments, ("VK_DRIVER_FILES", "/none"), ("VK_ICD_FILENAMES", "/none")));

        [Test]
        public void Render_WithLabelsOfAnotherGrid_IsRefused() =>
            IsRefused("moved.seg.nrrd and " + folder["volume.nrrd"], Carve.Process, null,
                "--labels", Phantom.WriteLabels(folder, "moved.seg.nrrd", originMm: 3));

        [TestCase("""{"version": 99, "space": "LPS", "spheres": []}""")]
        [TestCase("""{"version": 1, "space": "LPS", "spheres": [{"centerMm": [0, 0, 0], "radiusMm": -1, "clipped": []}]}""")]
        [TestCase("""{"version": 1, "sphe""")]
        public void Render_WithBadCarving_IsRefused(string json) =>
            IsRefused("carving.json", Carve.Process, null, "--carving", folder.Write("carving.json", json));

        void IsRefused(string culprit, Func<string[], CarveResult> carve, string volume = null, params string[] options)
        {
            folder.Write("good.camera.json", Camera);
            volume ??= Phantom.WriteVolume(folder);
            var before = folder.FileNames.ToArray();
            string[] camera = options.Contains("--camera") ? [] : ["--camera", folder["good.camera.json"]];

            var result = carve(["render", volume, "--size", "16x16", "--output", folder["out.png"], .. camera, .. options]);

            Assert.That(result.ExitCode, Is.EqualTo(1), result.Error);
            Assert.That(result.ErrorLines, Has.Length.EqualTo(1), result.Error);
            Assert.That(result.Error, Does.StartWith("carve: ").And.Contain(culprit));
            Assert.That(result.Error, Does.Not.Contain("unexpected").And.Not.Contain("(Parameter"));
            Assert.That(result.Output, Is.Empty);
            Assert.That(folder.FileNames, Is.EqualTo(before));
        }
    }
}
