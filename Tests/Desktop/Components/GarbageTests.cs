using System;
using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.LowLevel;
using UnityEngine.TestTools;

namespace AnatomyCarve.Desktop.Tests
{
    /// <summary>What the components leave to the garbage collector while the mouse moves, in what they do each frame.</summary>
    sealed class GarbageTests : DesktopScene
    {
        const int Frames = 40;

        [UnityTest]
        public IEnumerator View_ThatTurns_LeavesNone()
        {
            Camera camera = MakeCamera();
            OrbitView view = Add<OrbitView>(camera.gameObject, v => v.Controls = Controls);
            MoveTo(new Vector2(camera.pixelWidth, camera.pixelHeight) / 2f);
            Press(MouseButton.Right);
            yield return Pass();
            float pitch = view.Pose.Value.Pitch;
            Assert.That(BytesOf(() => view.Tick(0.014f)), Is.Zero);
            Assert.That(view.Pose.Value.Pitch, Is.Not.EqualTo(pitch), "it turned");
        }

        [UnityTest]
        public IEnumerator Pointer_ThatStaysOnASegment_LeavesNone()
        {
            CarvedVolumeRenderer volume = MakeVolume();
            Camera camera = MakeCamera();
            camera.gameObject.AddComponent<SegmentPointer>().Target = volume;
            MousePointer pointer = Add<MousePointer>(camera.gameObject, p => p.Controls = Controls);
            MoveTo(camera.WorldToScreenPoint(new Vector3(0.004f, 0.002f, -Block.HalfWidth)));
            yield return Pass();
            // Where the mouse comes to places that nobody looked at before, the volume's cache on the CPU grows; that is not the component's.
            // What the engine itself makes for a ray is not either: nothing in Unity.
            long ray = BytesOf(() => camera.ScreenPointToRay(Mouse.position.ReadValue()), 0f);
            Assert.That(BytesOf(() => pointer.Tick(), 0f), Is.LessThanOrEqualTo(ray));
            Assert.That(pointer.Label, Does.EndWith("Left"));
        }

        [UnityTest]
        public IEnumerator Sphere_ThatIsNotMoved_LeavesNone_AndAMovedOneOnlyItsEdits()
        {
            CarvedVolumeRenderer volume = MakeVolume();
            volume.Stack.Carving.HistoryLimit = 0;
            volume.Stack.SetActive(Vector3.zero, 0.006f);
            Camera camera = MakeCamera();
            MouseSphere sphere = Add<MouseSphere>(camera.gameObject, s =>
            {
                s.Controls = Controls;
                s.Stack = volume.Stack;
            });
            MoveTo(camera.WorldToScreenPoint(Vector3.zero));
            yield return Pass();
            Assert.That(BytesOf(() => sphere.Tick(0.014f)), Is.Zero);
            Press(Key.LeftShift);
            yield return Pass();
            int version = volume.Stack.Carving.Version;
            Assert.That(BytesOf(() => sphere.Tick(0.014f)) / Frames, Is.LessThan(512));
            Assert.That(volume.Stack.Carving.Version, Is.GreaterThan(version + Frames), "it moved");
        }

        /// <summary>Bytes that this thread allocated in all frames, after as many to grow buffers in and to compile; the mouse moves between them.</summary>
        /// <param name="frame">A component's frame.</param>
        /// <param name="drift">Pixels that the mouse gets on in a frame, besides going to and fro.</param>
        long BytesOf(Action frame, float drift = 1f)
        {
            long bytes = 0, known = GC.GetAllocatedBytesForCurrentThread();
            GC.KeepAlive(new byte[1000]);
            Assume.That(GC.GetAllocatedBytesForCurrentThread() - known, Is.GreaterThanOrEqualTo(1000), "this runtime does not count what threads allocate");
            for (int n = 0; n < 2 * Frames; n++)
            {
                MoveBy(new Vector2(n % 2 == 0 ? 3f : -3f, drift));
                InputSystem.Update();
                long before = GC.GetAllocatedBytesForCurrentThread();
                frame();
                if (n >= Frames)
                    bytes += GC.GetAllocatedBytesForCurrentThread() - before;
            }
            return bytes;
        }
    }
}
