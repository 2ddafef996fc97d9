using System.Collections;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem.LowLevel;
using UnityEngine.TestTools;

namespace AnatomyCarve.Desktop.Tests
{
    /// <summary>What is under the mouse, and what a click does to it.</summary>
    sealed class MousePointerTests : DesktopScene
    {
        CarvedVolumeRenderer volume;
        Camera camera;
        SegmentPointer pointer;
        MousePointer mousePointer;

        [UnityTest]
        public IEnumerator Mouse_OverASegment_NamesIt_WithASignForTheMask()
        {
            yield return Begin();
            int changes = 0;
            mousePointer.Changed += () => changes++;
            yield return PointAt(new Vector3(0.009f, 0f, -Block.HalfWidth));
            Assert.That(mousePointer.Segment.Name, Is.EqualTo("Left"));
            Assert.That(mousePointer.WillBeClipped, Is.True, "a sphere clips all at first");
            Assert.That(mousePointer.Label, Is.EqualTo("\u00D7 Left"));
            yield return PointAt(new Vector3(-0.009f, 0f, -Block.HalfWidth));
            Assert.That(mousePointer.Label, Is.EqualTo("\u00D7 Right"));
            yield return PointAt(new Vector3(-0.009f, 0f, -Block.HalfWidth));
            Assert.That(changes, Is.EqualTo(2));
            MoveTo(new Vector2(1f, 1f));
            yield return Pass();
            Assert.That(mousePointer.Segment, Is.Null);
            Assert.That(mousePointer.Label, Is.Empty);
            Assert.That(changes, Is.EqualTo(3));
        }

        [UnityTest]
        public IEnumerator Click_OnASegment_TogglesWhatThePictureShows()
        {
            yield return Begin();
            // A sphere from above takes a bite of both halves, through which one sees what is behind the block: nothing.
            volume.Stack.SetActive(new Vector3(0f, 0.03f, 0f), 0.03f);
            int left = Count(Block.Left), right = Count(Block.Right);
            Vector3 place = new Vector3(0.014f, 0f, -Block.HalfWidth);
            yield return PointAt(place);
            Press(MouseButton.Left);
            yield return Pass();
            Assert.That(mousePointer.WillBeClipped, Is.False);
            Assert.That(mousePointer.Label, Is.EqualTo("+ Left"));
            Assert.That(Count(Block.Left), Is.GreaterThan(left), "the left half is whole");
            Assert.That(Count(Block.Right), Is.EqualTo(right), "the right half is not");
            yield return Pass(3);
            Assert.That(mousePointer.WillBeClipped, Is.False, "a button that is held is one click");
            Press(MouseButton.Left, false);
            yield return Pass();
            Press(MouseButton.Left);
            yield return Pass();
            Press(MouseButton.Left, false);
            Assert.That(mousePointer.WillBeClipped, Is.True);
            Assert.That(Count(Block.Left), Is.EqualTo(left));
        }

        [UnityTest]
        public IEnumerator Click_BesideTheVolume_DoesNothing()
        {
            yield return Begin();
            MoveTo(new Vector2(1f, 1f));
            yield return Pass();
            int version = volume.Stack.Carving.Version;
            Press(MouseButton.Left);
            yield return Pass();
            Press(MouseButton.Left, false);
            yield return Pass();
            Assert.That(volume.Stack.Carving.Version, Is.EqualTo(version));
        }

        [UnityTest]
        public IEnumerator Mouse_ThatLeavesThePicture_PointsAtNothing()
        {
            yield return Begin();
            yield return PointAt(new Vector3(0.009f, 0f, -Block.HalfWidth));
            MoveTo(new Vector2(-20f, 10f));
            yield return Pass();
            Assert.That(mousePointer.Segment, Is.Null);
            Assert.That(pointer.Current.Hit, Is.False);
        }

        [UnityTest]
        public IEnumerator Mouse_BesideTheCamerasPartOfTheWindow_PointsAtNothing()
        {
            yield return Begin();
            // So near that the block goes on beyond the picture's edge, and the picture is the window's left half.
            camera.transform.position = new Vector3(0f, 0f, -0.04f);
            camera.rect = new Rect(0f, 0f, 0.5f, 1f);
            Rect part = camera.pixelRect;
            MoveTo(new Vector2(part.xMax - 4f, part.center.y));
            yield return Pass();
            Assert.That(mousePointer.Segment, Is.Not.Null);
            MoveTo(new Vector2(part.xMax + 4f, part.center.y));
            yield return Pass();
            Assert.That(mousePointer.Segment, Is.Null);
        }

        [UnityTest]
        public IEnumerator Mouse_OverSomethingElse_PointsAtNothing_AndDoesNotClick()
        {
            yield return Begin();
            var gate = Make("Gate").AddComponent<TestGate>();
            mousePointer.Gate = gate;
            gate.Pointer = true;
            yield return PointAt(new Vector3(0.009f, 0f, -Block.HalfWidth));
            int version = volume.Stack.Carving.Version;
            Press(MouseButton.Left);
            yield return Pass();
            Press(MouseButton.Left, false);
            Assert.That(mousePointer.Segment, Is.Null);
            Assert.That(volume.Stack.Carving.Version, Is.EqualTo(version));
            gate.enabled = false;
            yield return Pass();
            Assert.That(mousePointer.Segment, Is.Not.Null, "a gate that is disabled is open");
        }

        [UnityTest]
        public IEnumerator Pointer_PointsByItself_OnlyWhileTheMouseDoesNot()
        {
            yield return Begin();
            Assert.That(pointer.AutoPoint, Is.False);
            mousePointer.enabled = false;
            Assert.That(pointer.AutoPoint, Is.True);
            yield return PointAt(new Vector3(0.009f, 0f, -Block.HalfWidth));
            Press(MouseButton.Left);
            yield return Pass();
            Press(MouseButton.Left, false);
            Assert.That(mousePointer.Segment, Is.Null);
            Assert.That(volume.Stack.Carving.ActiveMask[Block.Left], Is.True, "no click");
            mousePointer.enabled = true;
            Assert.That(pointer.AutoPoint, Is.False);
        }

        [UnityTest]
        public IEnumerator Pointer_SwitchedOff_TellsThatItPointsAtNothing()
        {
            yield return Begin();
            yield return PointAt(new Vector3(0.009f, 0f, -Block.HalfWidth));
            Assert.That(mousePointer.Label, Is.Not.Empty);
            string told = null;
            mousePointer.Changed += () => told = mousePointer.Label;
            mousePointer.enabled = false;
            Assert.That(told, Is.Empty, "a label that listens is empty now");
            Assert.That(mousePointer.Segment, Is.Null);
        }

        [UnityTest]
        public IEnumerator Component_WithoutAPointer_SaysSo()
        {
            LogAssert.Expect(LogType.Error, new Regex("^MousePointer on 'Camera' has no SegmentPointer and is disabled: set Pointer"));
            MousePointer lonely = Add<MousePointer>(MakeCamera().gameObject, p => p.Controls = Controls);
            yield return Pass();
            Assert.That(lonely.enabled, Is.False);
        }

        IEnumerator Begin()
        {
            volume = MakeVolume();
            camera = MakeCamera();
            pointer = camera.gameObject.AddComponent<SegmentPointer>();
            pointer.Target = volume;
            mousePointer = Add<MousePointer>(camera.gameObject, p => p.Controls = Controls);
            MoveTo(new Vector2(1f, 1f));
            yield return Pass();
        }

        IEnumerator PointAt(Vector3 world)
        {
            MoveTo(camera.WorldToScreenPoint(world));
            yield return Pass();
        }

        /// <summary>How many pixels of the camera's picture show a segment.</summary>
        int Count(int segment)
        {
            int count = 0;
            foreach (ushort s in volume.Render(camera, 96, 96).Read().Segments)
                count += s == segment ? 1 : 0;
            return count;
        }
    }
}
