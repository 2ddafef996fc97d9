using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli;
using AnatomyCarve.Headless.Cli.Bench.Scenes;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine.Benchmark
{
    /// <summary>The file of scenes that figures name.</summary>
    sealed class SceneFileTests
    {
        const string Volume = "\"v\": {\"dims\": [8, 8, 8], \"spacingMm\": [1, 1, 1], \"organs\": 2, \"body\": [0.4, 0.4]}";

        static SceneFile Read(TestFolder folder, string volumes, string scenes, int version = 1) =>
            SceneFile.Read(folder.Write("scenes.json", $"{{\"version\": {version}, \"volumes\": {{{volumes}}}, \"scenes\": {{{scenes}}}}}"));

        [Test]
        public void Committed_IsValid()
        {
            Assert.That(SceneFile.Read(SceneFile.DefaultPath).Scenes, Is.Not.Empty);
        }

        [Test]
        public void Committed_DemoVolume_IsTheOneThatFiguresAreStatedFor()
        {
            var demo = SceneFile.Read(SceneFile.DefaultPath).Volumes["demo"];

            Assert.That((demo.Dims, demo.SpacingMm, demo.Organs), Is.EqualTo((new[] { 441, 321, 215 }, new[] { 0.74, 0.74, 1.5 }, 75)).AsCollection);
        }

        [Test]
        public void Committed_Moves_AreAsLongAsTheFiguresSay()
        {
            var file = SceneFile.Read(SceneFile.DefaultPath);
            double Length(string name) => System.Math.Sqrt(file.Scenes[name].MoveMm.Sum(mm => mm * mm));

            Assert.That(new[] { "demo-move-40", "demo-move-80", "demo-move-15", "cube-move" }.Select(Length), Is.EqualTo(new[] { 5.0, 5, 5, 2 }).Within(1e-9));
        }

        [Test]
        public void Scene_OfAPhantom_HasItsSpheresAroundTheVolumesCentre()
        {
            using var folder = new TestFolder();
            var scenes = new BenchScenes(Read(folder, Volume,
                "\"s\": {\"volume\": \"v\", \"spheres\": [{\"centreMm\": [1, 2, 3], \"radiusMm\": 4, \"spared\": [1]}], \"moveMm\": [0, 0, 1]}"));

            var sphere = scenes.Get("s").Spheres.Single();

            Assert.That((sphere.CentreLps - scenes.Get("s").Volume.Geometry.CentreLps).Z, Is.EqualTo(3).Within(1e-12));
            Assert.That((sphere.RadiusMm, sphere.Mask[0], sphere.Mask[1], sphere.Mask[2]), Is.EqualTo((4.0, true, false, true)));
        }

        [Test]
        public void Scene_WithACrowd_HasItBeforeTheOthers()
        {
            using var folder = new TestFolder();
            var scene = new BenchScenes(Read(folder, Volume,
                "\"s\": {\"volume\": \"v\", \"crowd\": 9, \"crowdRadiusMm\": 0.5, \"spheres\": [{\"centreMm\": [1, 2, 3], \"radiusMm\": 4}]}")).Get("s");

            Assert.That(scene.Spheres.Select(sphere => sphere.RadiusMm), Is.EqualTo(Enumerable.Repeat(0.5, 9).Append(4)));
            Assert.That(scene.Spheres.Select(sphere => sphere.CentreLps).Distinct().Count(), Is.EqualTo(10));
        }

        [Test]
        public void Scene_ThatHidesSegments_KeepsTheOthers()
        {
            using var folder = new TestFolder();
            var scene = new BenchScenes(Read(folder, Volume, "\"s\": {\"volume\": \"v\", \"shown\": [1]}")).Get("s");

            Assert.That(scene.Segments.Select(segment => segment.Opacity), Is.EqualTo(new[] { 0f, 1f, 0f }));
        }

        [Test]
        public void Scene_OfAScanThatIsNotThere_IsAbsent()
        {
            using var folder = new TestFolder();
            var scenes = new BenchScenes(Read(folder, "\"v\": {\"scan\": \"nowhere.nrrd\"}", "\"s\": {\"volume\": \"v\"}"));

            Assert.That(scenes.IsPresent("s"), Is.False);
        }

        [TestCase(Volume, "\"s\": {\"volume\": \"w\"}", 1, "there is no volume \"w\"")]
        [TestCase(Volume, "\"s\": {\"volume\": \"v\", \"moveMm\": [1, 2, 3]}", 1, "there is a sphere to move")]
        [TestCase(Volume, "\"s\": {\"volume\": \"v\", \"spheres\": [{\"radiusMm\": 3}]}", 1, "centreMm")]
        [TestCase(Volume, "\"s\": {\"volume\": \"v\", \"radius\": 3}", 1, "radius")]
        [TestCase("\"v\": {\"dims\": [8, 8], \"spacingMm\": [1, 1, 1], \"body\": [1, 1]}", "", 1, "dims")]
        [TestCase(Volume, "", 2, "version 2 is not known")]
        public void File_ThatMakesNoSense_IsRefused(string volumes, string scenes, int version, string message)
        {
            using var folder = new TestFolder();
            Assert.That(() => Read(folder, volumes, scenes, version), Throws.InstanceOf<CommandException>().With.Message.Contains(message));
        }

        /// <summary>The committed scenes with an eighth of the voxels per axis in larger volumes, and small pictures: what tests run.</summary>
        public static string WriteSmall(TestFolder folder)
        {
            var file = JsonNode.Parse(File.ReadAllText(SceneFile.DefaultPath));
            foreach (var (_, volume) in file["volumes"].AsObject())
            {
                if (volume["dims"] is not JsonArray dims || dims.Max(side => (int)side) <= 64) continue;
                volume["dims"] = new JsonArray(dims.Select(side => (JsonNode)((int)side / 8)).ToArray());
                volume["spacingMm"] = new JsonArray(volume["spacingMm"].AsArray().Select(spacing => (JsonNode)(8 * (double)spacing)).ToArray());
            }

            foreach (var (_, scene) in file["scenes"].AsObject()) scene["size"] = new JsonArray(24, 24);
            return folder.Write("small.json", file.ToJsonString());
        }
    }
}
