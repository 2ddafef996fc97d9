using System.Collections;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.LowLevel;
using UnityEngine.TestTools;

namespace AnatomyCarve.Desktop.Tests
{
    /// <summary>Controls that several components share, that are missing, or that nobody wired.</summary>
    sealed class SharedControlsTests : DesktopScene
    {
        [UnityTest]
        public IEnumerator Components_OfOneAsset_DisableItWithTheLast()
        {
            OrbitView first = MakeView(), second = MakeView();
            yield return Pass();
            Assert.That(Controls.enabled, Is.True);
            first.enabled = false;
            Assert.That(Controls.enabled, Is.True, "the second one uses it");
            MoveTo(new Vector2(100f, 100f));
            yield return Pass();
            Scroll(1f);
            yield return Pass();
            Assert.That(second.Pose.Value.Distance, Is.LessThan(first.Pose.Value.Distance));
            first.enabled = true;
            second.enabled = false;
            Assert.That(Controls.enabled, Is.True);
            Object.Destroy(first.gameObject);
            yield return Pass();
            Assert.That(Controls.enabled, Is.False);
        }

        [UnityTest]
        public IEnumerator Asset_ThatSomebodyElseEnabled_StaysEnabled()
        {
            Controls.Enable();
            OrbitView view = MakeView();
            yield return Pass();
            view.enabled = false;
            Assert.That(Controls.enabled, Is.True);
        }

        [UnityTest]
        public IEnumerator Action_ThatIsMissing_IsOneError_WhichNamesIt()
        {
            InputActionAsset lacking = Keep(InputActionAsset.FromJson(
                Controls.ToJson().Replace("\"Orbit\"", "\"Spin\"").Replace("\"Zoom\"", "\"Come Nearer\"")));
            lacking.name = "MyControls";
            LogAssert.Expect(LogType.Error, new Regex(
                "^OrbitView on 'Camera' cannot use the input actions 'MyControls' and is disabled: there is no action 'Desktop/Orbit' \\(Button\\); "
                + "there is no action 'Desktop/Zoom' \\(Axis\\)\\.$"));
            OrbitView view = Add<OrbitView>(MakeCamera().gameObject, v => v.Controls = lacking);
            Assert.That(view.enabled, Is.False);
            yield return Pass(3);
            Assert.That(lacking.enabled, Is.False);
        }

        [Test]
        public void Map_ThatIsMissing_IsOneError([Values] bool ofTheSphere)
        {
            InputActionAsset empty = Keep(ScriptableObject.CreateInstance<InputActionAsset>());
            empty.name = "Empty";
            LogAssert.Expect(LogType.Error, new Regex("^Mouse(Sphere|Pointer) on 'Camera' cannot use the input actions 'Empty'.*there is no action map 'Desktop'\\.$"));
            GameObject o = MakeCamera().gameObject;
            Behaviour component = ofTheSphere
                ? (Behaviour)Add<MouseSphere>(o, s => s.Controls = empty)
                : Add<MousePointer>(o, p => p.Controls = empty);
            Assert.That(component.enabled, Is.False);
        }

        [Test]
        public void Action_OfAnotherKind_IsAnError()
        {
            Controls.FindAction("Desktop/Zoom").expectedControlType = "Vector2";
            LogAssert.Expect(LogType.Error, new Regex("the action 'Desktop/Zoom' is for controls of the kind Vector2, not Axis\\.$"));
            Assert.That(MakeView().enabled, Is.False);
        }

        [UnityTest]
        public IEnumerator Component_AddedAtRunTime_HasThePackagesControls()
        {
            Camera camera = MakeCamera();
            OrbitView view = camera.gameObject.AddComponent<OrbitView>();
            view.SmoothTime = 0f;
            InputActionAsset shared = AnatomyCarveDesktop.Load().Controls;
            MoveTo(new Vector2(camera.pixelWidth, camera.pixelHeight) / 2f);
            yield return Pass();
            Assert.That(shared.enabled, Is.True);
            float before = view.Pose.Value.Distance;
            Scroll(1f);
            yield return Pass();
            Assert.That(view.Pose.Value.Distance, Is.LessThan(before));
            Object.Destroy(camera.gameObject);
            yield return Pass();
            Assert.That(shared.enabled, Is.False);
        }

        [Test]
        public void Controls_OfThePackage_AreBoundToMouseAndKeyboardOnly()
        {
            foreach (InputBinding binding in Controls.bindings)
                if (!binding.isComposite)
                    Assert.That(binding.path, Does.StartWith("<Mouse>/").Or.StartWith("<Keyboard>/"));
            foreach (InputAction action in Controls)
                Assert.That(action.controls.Count, Is.GreaterThan(0), action.name);
        }

        [Test]
        public void Hints_NameWhatIsBound()
        {
            string hints = DesktopHints.Describe(Controls);
            Assert.That(hints, Does.Contain("RMB\tdrag: turn the view"));
            Assert.That(hints, Does.Contain("F | Enter"));
            Assert.That(hints, Does.Contain("\tundo"));
            if (Application.platform == RuntimePlatform.LinuxPlayer)
                Assert.That(hints, Does.Contain("\nControl+Z\tundo").And.Contain("\nShift+Wheel\tresize the sphere"));
            Controls.FindAction("Desktop/Undo").ApplyBindingOverride(1, "<Keyboard>/alt");
            Assert.That(DesktopHints.Describe(Controls), Does.Contain("Alt+Z"), "as bound at the moment");
            Assert.That(hints.Split('\n').Length, Is.EqualTo(19));
            Assert.That(DesktopHints.Describe(), Does.Contain("W/A/S/D\tmove the sphere"));
            Assert.That(DesktopHints.Describe(Keep(ScriptableObject.CreateInstance<InputActionAsset>())), Is.Empty);
        }

        OrbitView MakeView() => Add<OrbitView>(MakeCamera().gameObject, v =>
        {
            v.Controls = Controls;
            v.SmoothTime = 0f;
        });
    }
}
