using System.Collections;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.TestTools;
using UnityEngine.UI;

namespace AnatomyCarve.Desktop.Tests
{
    /// <summary>What is written on the screen.</summary>
    sealed class LabelTests : DesktopScene
    {
        [UnityTest]
        public IEnumerator PointerLabel_NamesWhatIsPointed_InItsColour()
        {
            CarvedVolumeRenderer volume = MakeVolume();
            Camera camera = MakeCamera();
            camera.gameObject.AddComponent<SegmentPointer>().Target = volume;
            MousePointer pointer = Add<MousePointer>(camera.gameObject, p => p.Controls = Controls);
            Text text = Make("Label").AddComponent<Text>();
            Add<PointerLabel>(text.gameObject, label => label.Pointer = pointer);
            MoveTo(camera.WorldToScreenPoint(new Vector3(0.004f, 0.002f, -Block.HalfWidth)));
            yield return Pass();
            volume.Stack.SetActive(new Vector3(0.2f, 0f, 0f), 0.01f);
            for (int n = 0; n < 2; n++)
            {
                yield return Pass();
                Assert.That(text.text, Is.EqualTo(pointer.WillBeClipped ? "\u00D7 Left" : "+ Left"));
                Assert.That(text.color.r > text.color.g, Is.EqualTo(pointer.WillBeClipped), "red: it goes; green: it stays");
                bool before = pointer.WillBeClipped;
                pointer.Pointer.ToggleSegment();
                yield return Pass();
                Assert.That(pointer.WillBeClipped, Is.Not.EqualTo(before));
            }
            MoveTo(new Vector2(1f, 1f));
            yield return Pass();
            Assert.That(text.text, Is.Empty);
        }

        [UnityTest]
        public IEnumerator PointerLabel_WithoutAPointer_SaysSoAndIsDisabled()
        {
            Text text = Make("Label").AddComponent<Text>();
            LogAssert.Expect(LogType.Error, new Regex("PointerLabel.*MousePointer"));
            var label = text.gameObject.AddComponent<PointerLabel>();
            yield return null;
            Assert.That(label.enabled, Is.False);
        }

        [UnityTest]
        public IEnumerator LoadingLabel_BesideALoader_NeedsNoWiring()
        {
            var loader = Make("Label").AddComponent<VolumeLoader>();
            Text text = loader.gameObject.AddComponent<Text>();
            var label = loader.gameObject.AddComponent<LoadingLabel>();
            System.Threading.Tasks.Task load = loader.LoadAsync(new byte[] { 1, 2, 3 }, null, "broken.nrrd");
            while (!load.IsCompleted)
                yield return null;
            yield return null;
            yield return null;
            Assert.That(text.text, Does.Contain("broken.nrrd"));
            label.enabled = false;
            Assert.That(text.text, Is.Empty);
        }

        [UnityTest]
        public IEnumerator LoadingLabel_TellsAFailure_UntilAVolumeIsThere()
        {
            var loader = Make("Loader").AddComponent<VolumeLoader>();
            Text text = Make("Label").AddComponent<Text>();
            Add<LoadingLabel>(text.gameObject, label => label.Loader = loader);
            System.Threading.Tasks.Task load = loader.LoadAsync(new byte[] { 1, 2, 3 }, null, "broken.nrrd");
            yield return null;
            while (!load.IsCompleted)
            {
                Assert.That(text.text, Does.StartWith("Loading").Or.Empty);
                yield return null;
            }
            yield return null;
            yield return null;
            Assert.That(text.text, Does.Contain("broken.nrrd"));
            loader.SetVolume(Block.Make());
            yield return null;
            yield return null;
            Assert.That(text.text, Is.Empty);
        }

        [UnityTest]
        public IEnumerator HintsLabel_HasTwoColumnsOfEquallyManyLines_AndItsKeyHidesThem()
        {
            GameObject panel = Make("Panel");
            Text keys = Make("Keys").AddComponent<Text>();
            Text deeds = Make("Deeds").AddComponent<Text>();
            Add<HintsLabel>(Make("Hints"), hints =>
            {
                hints.Keys = keys;
                hints.Deeds = deeds;
                hints.Panel = panel;
                hints.Controls = Controls;
            });
            yield return null;
            Assert.That(deeds.text, Does.Contain("undo").And.Contain("hide, show these hints"));
            Assert.That(keys.text.Split('\n'), Has.Length.EqualTo(deeds.text.Split('\n').Length));
            yield return Type(Key.H);
            Assert.That(panel.activeSelf, Is.False);
            yield return Type(Key.H);
            Assert.That(panel.activeSelf, Is.True);
        }
    }
}
