using System.Collections;
using System.Text.RegularExpressions;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.TestTools;

namespace AnatomyCarve.Desktop.Tests
{
    /// <summary>What is done with the active sphere, what is one step to undo, and when nothing is done.</summary>
    sealed class SphereEditTests : SphereScene
    {
        [UnityTest]
        public IEnumerator KeysOfTheMask_FixRemoveAndReset()
        {
            yield return Begin(false);
            yield return Type(Key.F);
            Assert.That(Carving.Spheres.Count, Is.Zero, "there is nothing to fix");
            volume.Stack.SetActive(Vector3.zero, 0.006f);
            yield return Type(Key.F);
            yield return Type(Key.Enter);
            Assert.That(Carving.Fixed.Count, Is.EqualTo(2));
            yield return Type(Key.Backspace);
            yield return Type(Key.Delete);
            Assert.That(Carving.Fixed.Count, Is.Zero);
            Assert.That(Carving.ActiveMask.IsNone, Is.False);
            yield return Type(Key.R);
            Assert.That(Carving.ActiveMask.IsNone, Is.True);
        }

        [UnityTest]
        public IEnumerator ADrag_OfManyFrames_IsOneStepToUndo()
        {
            yield return Begin(false);
            volume.Stack.SetActive(new Vector3(0.004f, 0f, 0f), 0.006f);
            PointMm before = Carving.Active.CentreLps;
            Vector2 at = ScreenOf(Sphere.Centre);
            MoveTo(at);
            Press(Key.LeftShift);
            yield return Pass();
            for (int n = 1; n <= 8; n++)
            {
                MoveTo(at + new Vector2(6f * n, -2f * n));
                if (n % 3 == 0)
                    Scroll(1f);
                yield return Pass();
            }
            Assert.That(mouseSphere.IsDragging, Is.True);
            Press(Key.LeftShift, false);
            yield return Pass();
            PointMm after = Carving.Active.CentreLps;
            Assert.That(after, Is.Not.EqualTo(before));
            yield return Type(Key.LeftCtrl, Key.Z);
            Assert.That(Carving.Active.CentreLps, Is.EqualTo(before));
            Assert.That(Carving.Active.RadiusMm, Is.EqualTo(6).Within(1e-4));
            yield return Type(Key.LeftCtrl, Key.Y);
            Assert.That(Carving.Active.CentreLps, Is.EqualTo(after));
            yield return Type(Key.LeftCtrl, Key.Z);
            yield return Type(Key.LeftCtrl, Key.Z);
            Assert.That(Carving.Spheres.Count, Is.Zero, "the step before is that the sphere was made");
            yield return Type(Key.RightCtrl, Key.LeftShift, Key.Z);
            Assert.That(Carving.Active.CentreLps, Is.EqualTo(before), "Ctrl+Shift+Z makes it again, and does not undo too");
        }

        [UnityTest]
        public IEnumerator MovingKeys_HeldTogether_AreOneStepToUndo()
        {
            yield return Begin(false);
            volume.Stack.SetActive(Vector3.zero, 0.006f);
            PointMm before = Carving.Active.CentreLps;
            Press(Key.D);
            yield return Pass(2);
            Press(Key.W);
            yield return Pass(2);
            Press(Key.D, false);
            yield return Pass(2);
            Press(Key.W, false);
            yield return Pass();
            yield return Type(Key.LeftCtrl, Key.Z);
            Assert.That(Carving.Active.CentreLps, Is.EqualTo(before));
        }

        [UnityTest]
        public IEnumerator TwoDrags_AreTwoStepsToUndo()
        {
            yield return Begin(false);
            volume.Stack.SetActive(Vector3.zero, 0.006f);
            Vector2 at = ScreenOf(Vector3.zero);
            yield return HoldAndMove(at, at + new Vector2(20f, 0f));
            PointMm between = Carving.Active.CentreLps;
            at = ScreenOf(Sphere.Centre);
            yield return HoldAndMove(at, at + new Vector2(0f, 20f));
            yield return Type(Key.LeftCtrl, Key.Z);
            Assert.That(Carving.Active.CentreLps, Is.EqualTo(between));
        }

        [UnityTest]
        public IEnumerator Disabled_DoesNothing_AndEndsItsDrag()
        {
            yield return Begin(false);
            yield return BeginDrag();
            Vector2 at = ScreenOf(Vector3.zero);
            mouseSphere.enabled = false;
            int version = Carving.Version;
            MoveTo(at + new Vector2(60f, 0f));
            Scroll(2f);
            yield return Type(Key.F);
            Assert.That(Carving.Version, Is.EqualTo(version));
            volume.Stack.SetActive(new Vector3(0.001f, 0f, 0f), 0.006f);
            volume.Stack.SetActive(new Vector3(0.002f, 0f, 0f), 0.006f);
            volume.Stack.Undo();
            Assert.That(Sphere.Centre.x, Is.EqualTo(0.001f).Within(1e-6f), "no gesture goes on");
        }

        [UnityTest]
        public IEnumerator Volume_ThatIsReplacedDuringADrag_EndsIt()
        {
            yield return Begin(false);
            yield return BeginDrag();
            Vector2 at = ScreenOf(Vector3.zero);
            volume.Loader.Unload();
            MoveTo(at + new Vector2(30f, 0f));
            yield return Pass(2);
            Assert.That(mouseSphere.IsDragging, Is.False);
            volume.Loader.SetVolume(Block.Make());
            yield return Pass();
            Press(Key.LeftShift, false);
            yield return Pass();
            Assert.That(Carving.Spheres.Count, Is.Zero);
        }

        [UnityTest]
        public IEnumerator Gate_ThatIsClosed_BeginsNothing()
        {
            yield return Begin(false);
            var gate = Make("Gate").AddComponent<TestGate>();
            mouseSphere.Gate = gate;
            volume.Stack.SetActive(Vector3.zero, 0.006f);
            int version = Carving.Version;
            Vector2 at = ScreenOf(Vector3.zero);
            gate.Pointer = true;
            yield return HoldAndMove(at, at + new Vector2(40f, 0f));
            gate.Pointer = false;
            gate.Keys = true;
            yield return Type(Key.F);
            yield return Type(Key.LeftCtrl, Key.Z);
            Press(Key.D);
            yield return Pass(2);
            Press(Key.D, false);
            yield return Pass();
            Assert.That(Carving.Version, Is.EqualTo(version));
        }

        [UnityTest]
        public IEnumerator Component_WithoutACameraOrACarving_SaysSo()
        {
            LogAssert.Expect(LogType.Error, new Regex("^MouseSphere on 'Lonely' has no Camera and is disabled: set View, or put it on the GameObject of one\\.$"));
            MouseSphere lonely = Add<MouseSphere>(Make("Lonely"), s => s.Controls = Controls);
            yield return Pass();
            Assert.That(lonely.enabled, Is.False);
            LogAssert.Expect(LogType.Error, new Regex("^MouseSphere on 'Camera' has no ClipSphereStack"));
            MouseSphere halfway = Add<MouseSphere>(MakeCamera().gameObject, s => s.Controls = Controls);
            yield return Pass();
            Assert.That(halfway.enabled, Is.False);
        }
    }
}
