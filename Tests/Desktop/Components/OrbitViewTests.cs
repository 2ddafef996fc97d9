using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.LowLevel;
using UnityEngine.TestTools;

namespace AnatomyCarve.Desktop.Tests
{
    /// <summary>The camera around its target, moved with a mouse and keys.</summary>
    sealed class OrbitViewTests : DesktopScene
    {
        static readonly Vector3 Target = new Vector3(0.4f, 1.2f, -0.3f);

        Camera camera;
        OrbitView view;

        [UnityTest]
        public IEnumerator Drag_WithTheRightButton_TurnsByTheAngle_AndKeepsTheTargetInTheMiddle()
        {
            yield return Begin();
            yield return Drag(MouseButton.Right, new Vector2(camera.pixelHeight / 4f, camera.pixelHeight / 8f));
            // A quarter of the height to the right is 45 degrees, and what is dragged goes along: the view goes left, and down.
            Assert.That(view.Pose.Value.Yaw, Is.EqualTo(45f).Within(0.01f));
            Assert.That(view.Pose.Value.Pitch, Is.EqualTo(-22.5f).Within(0.01f));
            AssertSeesTarget(0.2f);
            Assert.That(camera.transform.position.x, Is.LessThan(Target.x - 0.1f));
            Assert.That(camera.transform.position.y, Is.LessThan(Target.y - 0.05f));
        }

        [UnityTest]
        public IEnumerator Drag_WithoutAButton_DoesNothing()
        {
            yield return Begin();
            MoveBy(new Vector2(50f, 50f));
            yield return Pass();
            Assert.That(view.Pose.Value.Yaw, Is.EqualTo(0f).Within(1e-4f));
        }

        [UnityTest]
        public IEnumerator Drag_WithTheMiddleButton_TakesTheTargetAlong()
        {
            yield return Begin();
            Vector3 before = camera.WorldToScreenPoint(Target);
            yield return Drag(MouseButton.Middle, new Vector2(60f, -40f));
            Vector3 moved = camera.WorldToScreenPoint(Target) - before;
            Assert.That(moved.x, Is.EqualTo(60f).Within(0.1f));
            Assert.That(moved.y, Is.EqualTo(-40f).Within(0.1f));
            Assert.That(view.Pose.Value.Distance, Is.EqualTo(0.2f).Within(1e-4f));
        }

        [UnityTest]
        public IEnumerator Wheel_Forwards_ComesNearer_AndStopsBeforeTheTarget()
        {
            yield return Begin();
            Scroll(1f);
            yield return Pass();
            Assert.That(view.Pose.Value.Distance, Is.EqualTo(0.2f * Mathf.Exp(-0.12f)).Within(1e-4f));
            AssertSeesTarget(0.2f * Mathf.Exp(-0.12f));
            for (int n = 0; n < 30; n++)
            {
                Scroll(10f);
                yield return Pass();
            }
            AssertSeesTarget(0.05f);
            Scroll(-1f);
            yield return Pass();
            AssertSeesTarget(0.05f * Mathf.Exp(0.12f));
        }

        [UnityTest]
        public IEnumerator Wheel_WithAParallelCamera_ChangesItsSize_AndNotItsPlace()
        {
            camera = MakeCamera(Target);
            camera.orthographic = true;
            camera.orthographicSize = 0.1f;
            yield return Begin();
            Vector3 place = camera.transform.position;
            Scroll(2f);
            yield return Pass();
            Assert.That(camera.orthographicSize, Is.EqualTo(0.1f * Mathf.Exp(-0.24f)).Within(1e-4f));
            Assert.That(Vector3.Distance(camera.transform.position, place), Is.LessThan(1e-5f));
        }

        [UnityTest]
        public IEnumerator Wheel_WhileTheSphereIsHeld_IsTheSpheres()
        {
            yield return Begin();
            Press(Key.LeftShift);
            Scroll(1f);
            yield return Pass();
            Assert.That(view.Pose.Value.Distance, Is.EqualTo(0.2f).Within(1e-5f));
        }

        [UnityTest]
        public IEnumerator Keys_Held_TurnAndApproach()
        {
            yield return Begin();
            Press(Key.RightArrow);
            Press(Key.UpArrow);
            Press(Key.PageUp);
            yield return Pass(4);
            Assert.That(view.Pose.Value.Yaw, Is.LessThan(-0.1f), "the view goes to the right");
            Assert.That(view.Pose.Value.Pitch, Is.GreaterThan(0.1f), "and up");
            Assert.That(view.Pose.Value.Distance, Is.LessThan(0.2f));
            Press(Key.RightArrow, false);
            Press(Key.UpArrow, false);
            Press(Key.PageUp, false);
            yield return Pass();
            OrbitPose after = view.Pose.Value;
            yield return Pass(3);
            Assert.That(view.Pose.Value, Is.EqualTo(after), "released");
        }

        [UnityTest]
        public IEnumerator Keys_HeldForSlides_MoveTheView()
        {
            yield return Begin();
            Press(Key.L);
            Press(Key.I);
            yield return Pass(3);
            Assert.That(view.Pose.Value.Centre.x, Is.GreaterThan(1e-4f));
            Assert.That(view.Pose.Value.Centre.y, Is.GreaterThan(1e-4f));
            Assert.That(view.Pose.Value.Centre.z, Is.EqualTo(0f).Within(1e-5f));
        }

        [UnityTest]
        public IEnumerator Home_AfterMoves_LeadsBack()
        {
            yield return Begin();
            Vector3 place = camera.transform.position;
            yield return Drag(MouseButton.Right, new Vector2(200f, 30f));
            yield return Drag(MouseButton.Middle, new Vector2(20f, 30f));
            Scroll(-3f);
            yield return Type(Key.Home);
            Assert.That(Vector3.Distance(camera.transform.position, place), Is.LessThan(1e-4f));
            AssertSeesTarget(0.2f);
        }

        [UnityTest]
        public IEnumerator Frame_OfABox_ShowsAllOfIt_AndIsHome()
        {
            yield return Begin();
            yield return Drag(MouseButton.Right, new Vector2(100f, -50f));
            var bounds = new Bounds(Target + new Vector3(0.1f, 0f, 0f), new Vector3(0.5f, 0.2f, 0.8f));
            view.Frame(bounds);
            yield return Pass();
            AssertShows(bounds);
            float yaw = view.Pose.Value.Yaw;
            yield return Drag(MouseButton.Right, new Vector2(100f, 0f));
            yield return Type(Key.Home);
            AssertShows(bounds);
            Assert.That(view.Pose.Value.Yaw, Is.EqualTo(yaw).Within(1e-3f));
        }

        [UnityTest]
        public IEnumerator LookFrom_AnAngle_LooksFromThere()
        {
            yield return Begin();
            view.LookFrom(-90f, 30f);
            yield return Pass();
            Assert.That(camera.transform.forward.x, Is.LessThan(-0.8f));
            Assert.That(camera.transform.forward.y, Is.EqualTo(-0.5f).Within(1e-3f));
            AssertSeesTarget(0.2f);
        }

        [UnityTest]
        public IEnumerator Target_ThatMoves_StaysInTheMiddle()
        {
            yield return Begin();
            Transform moving = Make("Target").transform;
            moving.position = Target;
            view.Target = moving;
            yield return Pass();
            moving.position += new Vector3(1f, 2f, 3f);
            yield return Pass();
            Assert.That(Vector3.Distance(camera.transform.position + camera.transform.forward * 0.2f, moving.position), Is.LessThan(1e-4f));
        }

        [UnityTest]
        public IEnumerator SmoothTime_Set_TakesItsTime()
        {
            yield return Begin();
            view.SmoothTime = 0.3f;
            yield return Drag(MouseButton.Right, new Vector2(camera.pixelHeight / 2f, 0f));
            Assert.That(view.Pose.Value.Yaw, Is.GreaterThan(1f).And.LessThan(80f));
            for (int n = 0; n < 400 && view.Pose.Value.Yaw < 89.9f; n++)
                yield return null;
            Assert.That(view.Pose.Value.Yaw, Is.EqualTo(90f).Within(0.1f));
        }

        [UnityTest]
        public IEnumerator Gate_ThatIsClosed_BeginsNothing_ButLetsADragGoOn()
        {
            yield return Begin();
            var gate = Make("Gate").AddComponent<TestGate>();
            view.Gate = gate;
            gate.Pointer = gate.Keys = true;
            yield return Drag(MouseButton.Right, new Vector2(50f, 0f));
            Scroll(1f);
            Press(Key.LeftArrow);
            yield return Pass(2);
            Press(Key.LeftArrow, false);
            Assert.That(view.Pose.Value.Yaw, Is.EqualTo(0f).Within(1e-4f));
            Assert.That(view.Pose.Value.Distance, Is.EqualTo(0.2f).Within(1e-4f));
            gate.Pointer = false;
            Press(MouseButton.Right);
            yield return Pass();
            gate.Pointer = true;
            MoveBy(new Vector2(camera.pixelHeight / 4f, 0f));
            yield return Pass();
            Press(MouseButton.Right, false);
            Assert.That(view.Pose.Value.Yaw, Is.EqualTo(45f).Within(0.01f));
        }

        [UnityTest]
        public IEnumerator Disabled_ItLeavesTheCamera()
        {
            yield return Begin();
            view.enabled = false;
            Vector3 place = camera.transform.position;
            yield return Drag(MouseButton.Right, new Vector2(90f, 0f));
            Scroll(2f);
            yield return Pass();
            Assert.That(camera.transform.position, Is.EqualTo(place));
            Assert.That(Controls.enabled, Is.False);
            view.enabled = true;
            yield return Drag(MouseButton.Right, new Vector2(camera.pixelHeight / 4f, 0f));
            Assert.That(view.Pose.Value.Yaw, Is.EqualTo(45f).Within(0.01f));
        }

        [UnityTest]
        public IEnumerator Time_ThatStandsStill_DoesNotStopTheView()
        {
            yield return Begin();
            view.SmoothTime = 0.01f;
            float scale = Time.timeScale;
            try
            {
                Time.timeScale = 0f;
                yield return Drag(MouseButton.Right, new Vector2(camera.pixelHeight / 4f, 0f));
                yield return Pass(20);
            }
            finally
            {
                Time.timeScale = scale;
            }
            Assert.That(view.Pose.Value.Yaw, Is.EqualTo(45f).Within(0.5f));
        }

        /// <summary>A view whose mouse is in the middle of the picture.</summary>
        IEnumerator Begin()
        {
            if (camera == null)
                camera = MakeCamera(Target);
            view = Add<OrbitView>(camera.gameObject, v =>
            {
                v.Controls = Controls;
                v.TargetPoint = Target;
                v.SmoothTime = 0f;
            });
            MoveTo(new Vector2(camera.pixelWidth, camera.pixelHeight) / 2f);
            yield return Pass();
        }

        IEnumerator Drag(MouseButton button, Vector2 pixels)
        {
            Press(button);
            yield return Pass();
            // In two moves, which an update may take in together.
            MoveBy(pixels * 0.5f);
            MoveBy(pixels * 0.5f);
            yield return Pass();
            Press(button, false);
            yield return Pass();
            MoveBy(-pixels);
            yield return Pass();
        }

        void AssertSeesTarget(float distance)
        {
            Vector3 place = camera.WorldToViewportPoint(Target);
            Assert.That(place.x, Is.EqualTo(0.5f).Within(1e-3f));
            Assert.That(place.y, Is.EqualTo(0.5f).Within(1e-3f));
            Assert.That(place.z, Is.EqualTo(distance).Within(1e-4f));
        }

        void AssertShows(Bounds bounds)
        {
            for (int corner = 0; corner < 8; corner++)
            {
                Vector3 sign = new Vector3((corner & 1) * 2 - 1, (corner >> 1 & 1) * 2 - 1, (corner >> 2 & 1) * 2 - 1);
                Vector3 place = camera.WorldToViewportPoint(bounds.center + Vector3.Scale(bounds.extents, sign));
                Assert.That(place.x, Is.InRange(0f, 1f));
                Assert.That(place.y, Is.InRange(0f, 1f));
                Assert.That(place.z, Is.GreaterThan(0f));
            }
        }

        [SetUp]
        public void Forget()
        {
            camera = null;
            view = null;
        }
    }
}
