using System.Collections.Generic;
using System.Text.RegularExpressions;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>What a carving starts with, and carvings as text.</summary>
    sealed class StartCarvingTests : PlayModeScene
    {
        const string TwoSpheres = "{\"version\": 1, \"space\": \"LPS\", \"spheres\": ["
            + "{\"centerMm\": [10, -20, 30], \"radiusMm\": 12, \"clipped\": [{\"label\": 20, \"name\": \"Left\"}]},"
            + "{\"centerMm\": [12, -20, 30], \"radiusMm\": 5, \"clipped\": [{\"label\": 10}], \"active\": true}]}";

        [Test]
        public void StartFile_IsWhatEachVolumeStartsWith()
        {
            ClipSphereStack stack = MakeVolume(Phantoms.Markers(20)).Stack;
            Assert.That(stack.Carving.Spheres, Is.Empty);
            stack.StartFile = Own(new TextAsset(TwoSpheres));
            Assert.That(stack.Carving.Spheres, Is.Empty, "in Play the present carving is the user's");
            stack.Loader.SetVolume(Phantoms.Markers(20));
            Assert.That(stack.Carving.Fixed, Has.Count.EqualTo(1));
            Assert.That(stack.Carving.Active.RadiusMm, Is.EqualTo(5));
            Assert.That(stack.Carving.Fixed[0].Mask[Phantoms.Left], Is.True);
            Assert.That(stack.Carving.Fixed[0].Mask[Phantoms.Right], Is.False);
            stack.Clear();
            stack.Loader.SetVolume(Phantoms.Markers(24));
            Assert.That(stack.Carving.Spheres, Has.Count.EqualTo(2), "the next volume starts with it too");
            Assert.That(stack.Undo(), Is.False, "what a carving starts with is no edit");
        }

        [Test]
        public void StartFile_WithForeignSegments_WarnsAndKeepsThem()
        {
            ClipSphereStack stack = MakeVolume(Phantoms.Markers(20)).Stack;
            LogAssert.Expect(LogType.Warning, new Regex("Elsewhere"));
            stack.StartFile = Own(new TextAsset(TwoSpheres.Replace("{\"label\": 20, \"name\": \"Left\"}", "{\"label\": 77, \"name\": \"Elsewhere\"}")));
            Assert.That(stack.Carving.Spheres, Has.Count.EqualTo(2));
            Assert.That(stack.ToJson(), Does.Contain("Elsewhere"));
        }

        [Test]
        public void StartFile_ThatIsNone_SaysSoAndStartsEmpty()
        {
            ClipSphereStack stack = MakeVolume(Phantoms.Markers(20)).Stack;
            LogAssert.Expect(LogType.Error, new Regex("starts without a carving.*version"));
            stack.StartFile = Own(new TextAsset("{\"version\": 9}") { name = "broken" });
            Assert.That(stack.Carving.Spheres, Is.Empty);
        }

        [Test]
        public void Json_ThatIsLoaded_IsTheCarvingAgain_AndCanBeUndone()
        {
            ClipSphereStack stack = MakeVolume(Phantoms.Markers(20)).Stack;
            stack.SetActive(new Vector3(0.003f, 0f, 0f), 0.01f);
            stack.ToggleSegment(Phantoms.Left);
            stack.FixActive();
            string json = stack.ToJson();
            IReadOnlyList<Carving.ClipSphere> spheres = new List<Carving.ClipSphere>(stack.Carving.Spheres);
            stack.Clear();
            Assert.That(stack.LoadJson(json), Is.Empty, "no warnings");
            Assert.That(stack.Carving.Spheres, Is.EqualTo(spheres));
            Assert.That(stack.Undo(), Is.True);
            Assert.That(stack.Carving.Spheres, Is.Empty);
        }

        [Test]
        public void Json_ThatIsBroken_NamesItsSourceAndChangesNothing()
        {
            ClipSphereStack stack = MakeVolume(Phantoms.Markers(20)).Stack;
            stack.SetActive(Vector3.zero, 0.01f);
            Assert.That(() => stack.LoadJson("{\"version\": 1, \"space\": \"XYZ\", \"spheres\": []}", "the server's answer"),
                Throws.InstanceOf<AnatomyCarveException>().With.Message.Contains("the server's answer").And.Message.Contains("XYZ"));
            Assert.That(stack.Carving.Active, Is.Not.Null);
        }
    }
}
