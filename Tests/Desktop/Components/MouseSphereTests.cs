using System;
using System.Collections;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.TestTools;

namespace AnatomyCarve.Desktop.Tests
{
    /// <summary>Where the active sphere goes with the mouse and with keys.</summary>
    sealed class MouseSphereTests : SphereScene
    {
        const float Pixel = 0.5f;

        [UnityTest]
        public IEnumerator Shift_AndAMove_TakeTheSphereAlong_InItsPlane_UnderTheMouse()
        {
            yield return Begin(false);
            volume.Stack.SetActive(new Vector3(0.004f, -0.003f, 0.01f), 0.006f);
            Vector3 before = Sphere.Centre;
            Vector2 grip = new Vector2(7f, 5f), from = ScreenOf(before) + grip;
            yield return HoldAndMove(from, from + new Vector2(80f, -50f));
            Vector2 seen = ScreenOf(Sphere.Centre) + grip;
            Assert.That(Vector2.Distance(seen, from + new Vector2(80f, -50f)), Is.LessThan(Pixel), "what was grabbed is under the mouse");
            Assert.That(Sphere.Centre.z, Is.EqualTo(before.z).Within(1e-6f), "in the plane");
            Assert.That(Carving.Active.RadiusMm, Is.EqualTo(6).Within(1e-4));
        }

        [UnityTest]
        public IEnumerator Shift_InAVolumeThatIsTurnedAndScaled_KeepsTheSphereUnderTheMouse()
        {
            yield return Begin(false);
            volume.transform.SetPositionAndRotation(new Vector3(0.01f, 0.02f, 0.1f), Quaternion.Euler(20f, 130f, -40f));
            volume.transform.localScale = new Vector3(3f, 3f, 3f);
            camera.transform.position = new Vector3(0.1f, 0.2f, -0.4f);
            camera.transform.LookAt(volume.transform.position);
            volume.Stack.SetActive(volume.transform.position, 0.02f);
            Vector2 from = ScreenOf(Sphere.Centre);
            yield return HoldAndMove(from, from + new Vector2(-40f, 30f));
            Assert.That(Vector2.Distance(ScreenOf(Sphere.Centre), from + new Vector2(-40f, 30f)), Is.LessThan(Pixel));
        }

        [UnityTest]
        public IEnumerator Shift_OnTheVolumeBesideTheSphere_BringsTheSphereToTheSurface()
        {
            yield return Begin(true);
            volume.Stack.SetActive(new Vector3(-0.012f, 0f, -0.018f), 0.003f);
            Vector2 from = ScreenOf(new Vector3(0.01f, 0.006f, -Block.HalfWidth));
            yield return HoldAndMove(from, from + new Vector2(5f, 0f));
            Assert.That(Sphere.Centre.z, Is.EqualTo(-Block.HalfWidth).Within(0.001f));
            Assert.That(Vector2.Distance(ScreenOf(Sphere.Centre), from + new Vector2(5f, 0f)), Is.LessThan(2f));
        }

        [UnityTest]
        public IEnumerator Shift_OnTheSphere_TakesItWhereItIs()
        {
            yield return Begin(true);
            volume.Stack.SetActive(new Vector3(0f, 0f, -0.02f), 0.006f);
            Vector2 from = ScreenOf(Sphere.Centre);
            yield return HoldAndMove(from, from + new Vector2(30f, 0f));
            Assert.That(Sphere.Centre.z, Is.EqualTo(-0.02f).Within(1e-5f), "and not to the surface behind it");
            Assert.That(Sphere.Centre.x, Is.GreaterThan(0.001f));
        }

        [UnityTest]
        public IEnumerator Shift_WithoutASphere_PlacesOneOnTheSurface_WithAThirdOfTheVolume()
        {
            yield return Begin(true);
            Vector2 from = ScreenOf(new Vector3(0.01f, 0.006f, -Block.HalfWidth));
            yield return HoldAndMove(from, from + new Vector2(4f, 0f));
            Assert.That(Carving.Active.RadiusMm, Is.EqualTo(40 / 6.0).Within(1e-6));
            Assert.That(Sphere.Centre.z, Is.EqualTo(-Block.HalfWidth).Within(0.001f));
        }

        [UnityTest]
        public IEnumerator Shift_WithoutASphere_BesideTheVolume_PlacesOneInItsMiddle()
        {
            yield return Begin(true);
            var from = new Vector2(5f, 5f);
            yield return HoldAndMove(from, from + new Vector2(4f, 0f));
            Vector2 moved = ScreenOf(Sphere.Centre) - ScreenOf(Vector3.zero);
            Assert.That(Vector2.Distance(moved, new Vector2(4f, 0f)), Is.LessThan(Pixel));
        }

        [UnityTest]
        public IEnumerator Shift_AndALittleTremble_MoveNothing()
        {
            yield return Begin(false);
            volume.Stack.SetActive(Vector3.zero, 0.006f);
            int version = Carving.Version;
            Vector2 from = ScreenOf(Vector3.zero);
            yield return HoldAndMove(from, from + new Vector2(2f, 1f));
            Assert.That(Carving.Version, Is.EqualTo(version));
        }

        [UnityTest]
        public IEnumerator ShiftAndWheel_Resize_AndLeaveTheCentre()
        {
            yield return Begin(false);
            volume.Stack.SetActive(new Vector3(0.004f, 0.002f, 0.001f), 0.006f);
            PointMm centre = Carving.Active.CentreLps;
            double radius = Carving.Active.RadiusMm;
            Press(Key.RightShift);
            yield return Pass();
            Scroll(3f);
            yield return Pass();
            Assert.That(Carving.Active.RadiusMm, Is.EqualTo(radius * Math.Exp(0.3)).Within(1e-6));
            Scroll(-3f);
            yield return Pass();
            Assert.That(Carving.Active.RadiusMm, Is.EqualTo(radius).Within(1e-6));
            Assert.That(Carving.Active.CentreLps, Is.EqualTo(centre));
            for (int n = 0; n < 12; n++)
            {
                Scroll(-10f);
                yield return Pass();
            }
            Assert.That(Carving.Active.RadiusMm, Is.EqualTo(WorldSphere.SmallestRadiusMm));
            Press(Key.RightShift, false);
            yield return Pass();
            Scroll(1f);
            yield return Pass();
            Assert.That(Carving.Active.RadiusMm, Is.EqualTo(WorldSphere.SmallestRadiusMm), "without Shift the wheel is the view's");
        }

        [UnityTest]
        public IEnumerator Keys_Held_MoveAlongTheCamerasAxes([Values(Key.D, Key.W, Key.E)] Key key)
        {
            yield return Begin(false);
            camera.transform.position = new Vector3(0.2f, 0.1f, 0f);
            camera.transform.LookAt(Vector3.zero);
            volume.Stack.SetActive(Vector3.zero, 0.006f);
            Transform eye = camera.transform;
            Vector3 axis = key == Key.D ? eye.right : key == Key.W ? eye.up : eye.forward;
            Press(key);
            yield return Pass(3);
            Press(key, false);
            yield return Pass();
            Vector3 moved = Sphere.Centre;
            Assert.That(moved.magnitude, Is.GreaterThan(1e-4f));
            Assert.That(Vector3.Angle(moved, axis), Is.LessThan(0.1f));
            yield return Pass(3);
            Assert.That(Sphere.Centre, Is.EqualTo(moved), "released");
        }

        [UnityTest]
        public IEnumerator Brackets_Held_Resize()
        {
            yield return Begin(false);
            volume.Stack.SetActive(Vector3.zero, 0.006f);
            double radius = Carving.Active.RadiusMm;
            Press(Key.RightBracket);
            yield return Pass(3);
            Assert.That(Carving.Active.RadiusMm, Is.GreaterThan(radius));
            double larger = Carving.Active.RadiusMm;
            Press(Key.RightBracket, false);
            Press(Key.LeftBracket);
            yield return Pass(2);
            Assert.That(Carving.Active.RadiusMm, Is.LessThan(larger));
        }

        [UnityTest]
        public IEnumerator View_ThatTurnsDuringADrag_LeavesTheSphereWhereItIs()
        {
            yield return Begin(false);
            yield return BeginDrag();
            Vector3 before = Sphere.Centre;
            camera.transform.RotateAround(Vector3.zero, Vector3.up, 30f);
            yield return Pass(2);
            Assert.That(Sphere.Centre, Is.EqualTo(before));
            Vector2 seen = ScreenOf(before);
            MoveBy(new Vector2(0f, 25f));
            yield return Pass();
            Assert.That(Vector2.Distance(ScreenOf(Sphere.Centre), seen + new Vector2(0f, 25f)), Is.LessThan(Pixel));
            Press(Key.LeftShift, false);
            yield return Pass();
        }

        [UnityTest]
        public IEnumerator Sphere_DraggedFarAway_StaysInReach()
        {
            yield return Begin(false);
            volume.Stack.SetActive(Vector3.zero, 0.006f);
            Vector2 at = ScreenOf(Vector3.zero);
            yield return HoldAndMove(at, new Vector2(0f, at.y));
            Assert.That(Sphere.Centre.x, Is.EqualTo(-0.026f).Within(1e-5f), "the volume's side and the radius");
        }
    }
}
