using System.Collections;
using AnatomyCarve.Carving;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;

namespace AnatomyCarve.Desktop.Tests
{
    /// <summary>A block, a camera before it, and a sphere on the mouse.</summary>
    abstract class SphereScene : DesktopScene
    {
        protected CarvedVolumeRenderer volume;
        protected Camera camera;
        protected MouseSphere mouseSphere;

        protected CarvingStack Carving => volume.Stack.Carving;

        protected WorldSphere Sphere
        {
            get
            {
                Assert.That(WorldSphere.TryGet(volume.Stack, out WorldSphere sphere), Is.True);
                return sphere;
            }
        }

        /// <param name="findsTheSurface">Whether the sphere comes to the surface under the mouse.</param>
        protected IEnumerator Begin(bool findsTheSurface)
        {
            volume = MakeVolume();
            camera = MakeCamera();
            if (findsTheSurface)
                camera.gameObject.AddComponent<SegmentPointer>().Target = volume;
            mouseSphere = Add<MouseSphere>(camera.gameObject, s =>
            {
                s.Controls = Controls;
                s.Stack = volume.Stack;
            });
            MoveTo(new Vector2(2f, 2f));
            yield return Pass();
        }

        protected IEnumerator HoldAndMove(Vector2 from, Vector2 to)
        {
            MoveTo(from);
            yield return Pass();
            Press(Key.LeftShift);
            yield return Pass();
            MoveTo(Vector2.Lerp(from, to, 0.6f));
            yield return Pass();
            MoveTo(to);
            yield return Pass();
            Press(Key.LeftShift, false);
            yield return Pass();
        }

        /// <summary>A sphere in the middle of the block, held and dragged 20 pixels to the right; it is still held.</summary>
        protected IEnumerator BeginDrag()
        {
            volume.Stack.SetActive(Vector3.zero, 0.006f);
            Vector2 at = ScreenOf(Vector3.zero);
            MoveTo(at);
            Press(Key.LeftShift);
            yield return Pass();
            MoveTo(at + new Vector2(20f, 0f));
            yield return Pass();
        }

        protected Vector2 ScreenOf(Vector3 world) => camera.WorldToScreenPoint(world);
    }
}
