using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using AnatomyCarve.Headless.Cli.Files;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>Scenes played from the command line.</summary>
    sealed class SceneTests
    {
        static readonly string Demo = RepositoryFiles.Demo("DemoHead.unity");

        TestFolder folder;

        [SetUp]
        public void MakeFolder() => folder = new TestFolder();

        [TearDown]
        public void DeleteFolder() => folder.Dispose();

        [Test]
        public void Scene_OfTheDemo_ShowsTheHead()
        {
            CarveResult result = Carve.Process("scene", Demo, "--output", folder["scene.png"], "--size", "96x54", "--pipeline", "universal");
            Assert.That(result.ExitCode, Is.Zero, result.Error);
            Assert.That(result.Output.Trim(), Is.EqualTo(folder["scene.png"]));
            Plane<byte> picture = PngFile.ReadRgb(folder["scene.png"]);
            Assert.That((picture.Width / 3, picture.Height), Is.EqualTo((96, 54)));
            Assert.That(picture.Values.Count(value => value > 0x60), Is.GreaterThan(1000));
        }

        [Test]
        public void Scene_ThatIsNotThere_IsRefused()
        {
            CarveResult result = Carve.Process("scene", folder["missing.unity"], "--output", folder["scene.png"]);
            Assert.That((result.ExitCode, result.ErrorLines.Length), Is.EqualTo((1, 1)), result.Error);
            Assert.That(result.Error, Does.Contain("missing.unity"));
            Assert.That(folder.FileNames, Is.Empty);
        }

        [TestCase("drawInCameras: 1", "drawInCamera: 1", "drawInCamera")]
        [TestCase("guid: 63dd58ed06c7da0d54bc6c4b7a636712", "guid: 63dd58ed06c7da0d54bc6c4b7a636713", "63dd58ed06c7da0d54bc6c4b7a636713")]
        public void Scene_WithSomethingUnknown_IsRefused_NamingFileAndLine(string found, string replaced, string culprit)
        {
            // Without the sample's other files.
            string alone = Regex.Replace(File.ReadAllText(Demo), "(asset|startFile): .*", "$1: {fileID: 0}");
            string scene = folder.Write("Broken.unity", alone.Replace(found, replaced, StringComparison.Ordinal));
            CarveResult result = Carve.Process("scene", scene, "--output", folder["scene.png"]);
            Assert.That((result.ExitCode, result.ErrorLines.Length), Is.EqualTo((1, 1)), result.Error);
            Assert.That(result.Error, Does.Contain("Broken.unity").And.Contain("line ").And.Contain(culprit));
            Assert.That(folder.FileNames, Is.EqualTo(new[] { "Broken.unity" }));
        }
    }
}
