using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>LineRenderer: bands that are turned to the camera.</summary>
    public sealed class LineTests : DrawTest
    {
        const int Middle = Size / 2;

        [Test]
        public void Line_HasItsWidthAndColours()
        {
            var target = Target();
            var line = Line(new Vector3(-1.5f, 0, 0), new Vector3(1.5f, 0, 0));
            line.startWidth = 0.5f;
            line.endWidth = 0.5f;
            (line.startColor, line.endColor) = (Color.red, Color.blue);
            Parallel(target).Render();
            // 32 pixels for 4 units.
            Assert.That(Column(target, Middle), Is.EqualTo(4), "pixels of its width");
            Assert.That(Row(target, Middle), Is.EqualTo(24), "and of its length");
            var (left, right) = (Pixel(target, 5, Middle), Pixel(target, Size - 6, Middle));
            Assert.That(left.r > 0.9f && left.b < 0.1f, Is.True, left.ToString());
            Assert.That(right.b > 0.9f && right.r < 0.1f, Is.True, right.ToString());
        }

        [Test]
        public void Line_FacesEveryCamera()
        {
            Line(new Vector3(0, -1, 0), new Vector3(0, 1, 0)).widthMultiplier = 0.5f;
            foreach (var turn in new[] { 0f, 90f, 200f })
            {
                var target = Target();
                var camera = Parallel(target);
                camera.transform.SetPositionAndRotation(Quaternion.Euler(0, turn, 0) * new Vector3(0, 0, -5), Quaternion.Euler(0, turn, 0));
                camera.Render();
                Assert.That(Row(target, Middle), Is.EqualTo(4), $"from {turn} degrees");
            }
        }

        [Test]
        public void Line_ThatFacesItsTransform_IsThinFromTheSide()
        {
            var line = Line(new Vector3(0, -1, 0), new Vector3(0, 1, 0));
            line.widthMultiplier = 0.5f;
            line.alignment = LineAlignment.TransformZ;
            var (front, side) = (Target(), Target());
            Parallel(front).Render();
            var camera = Parallel(side);
            camera.transform.SetPositionAndRotation(new Vector3(-5, 0, 0), Quaternion.Euler(0, 90, 0));
            camera.Render();
            Assert.That(Row(front, Middle), Is.EqualTo(4));
            Assert.That(Row(side, Middle), Is.Zero);
        }

        [Test]
        public void Width_FollowsItsCurve()
        {
            var target = Target();
            var line = Line(new Vector3(-2, 0, 0), new Vector3(2, 0, 0));
            line.widthCurve = AnimationCurve.Linear(0, 0, 1, 1);
            line.widthMultiplier = 2;
            Parallel(target).Render();
            Assert.That(Column(target, 8), Is.EqualTo(4).Within(1), "a quarter of 16 pixels");
            Assert.That(Column(target, 24), Is.EqualTo(12).Within(1), "three quarters");
        }

        [Test]
        public void Line_OfItsTransformsSpace_MovesWithIt()
        {
            var target = Target();
            var line = Line(new Vector3(-0.5f, 0, 0), new Vector3(0.5f, 0, 0));
            line.widthMultiplier = 0.5f;
            line.useWorldSpace = false;
            line.transform.position = new Vector3(1, 1, 0);
            Assert.That(line.bounds.Contains(new Vector3(1, 1, 0)) && !line.bounds.Contains(Vector3.zero), Is.True);
            Parallel(target).Render();
            Assert.That(Pixel(target, Middle + 8, Middle + 8).a, Is.EqualTo(1));
            Assert.That(Pixel(target, Middle, Middle).a, Is.Zero);
        }

        [Test]
        public void Loop_ClosesTheLine()
        {
            var (open, closed) = (Target(), Target());
            var line = Line(new Vector3(-1, -1, 0), new Vector3(-1, 1, 0), new Vector3(1, 1, 0), new Vector3(1, -1, 0));
            line.widthMultiplier = 0.25f;
            var camera = Parallel(open);
            camera.Render();
            line.loop = true;
            camera.targetTexture = closed;
            camera.Render();
            Assert.That(Pixel(open, Middle, Middle - 8).a, Is.Zero, "the side between the last and the first point");
            Assert.That(Pixel(closed, Middle, Middle - 8).a, Is.EqualTo(1));
        }

        [Test]
        public void Caps_ReachBeyondTheEnds()
        {
            var (flat, round) = (Target(), Target());
            var line = Line(new Vector3(-0.5f, 0, 0), new Vector3(0.5f, 0, 0));
            var camera = Parallel(flat);
            camera.Render();
            line.numCapVertices = 8;
            camera.targetTexture = round;
            camera.Render();
            Assert.That(Row(flat, Middle), Is.EqualTo(8));
            Assert.That(Row(round, Middle), Is.EqualTo(16).Within(1), "half a width at both ends");
            Assert.That(Pixel(round, 9, Middle + 3).a, Is.Zero, "and round");
        }

        [TestCase(0)]
        [TestCase(4)]
        public void Corner_IsWhole(int vertices)
        {
            var target = Target();
            var line = Line(new Vector3(-1, -1, 0), new Vector3(-1, 1, 0), new Vector3(1, 1, 0));
            line.widthMultiplier = 0.5f;
            line.numCornerVertices = vertices;
            Parallel(target).Render();
            foreach (var (x, y) in new[] { (8, 8), (8, 16), (8, 23), (9, 24), (16, 24), (23, 24) })
                Assert.That(Pixel(target, x, y).a, Is.EqualTo(1), $"pixel {x}, {y}");
        }

        [Test]
        public void Line_OutOfSight_IsNotDrawn_NorIsOneWithoutLength()
        {
            var target = Target();
            var line = Line(new Vector3(10, 0, 0), new Vector3(12, 0, 0));
            var camera = Parallel(target);
            var before = Drawer.DrawCount;
            camera.Render();
            line.positionCount = 1;
            line.SetPosition(0, Vector3.zero);
            camera.Render();
            line.positionCount = 0;
            camera.Render();
            Assert.That(Drawer.DrawCount, Is.EqualTo(before));
        }

        [Test]
        public void Positions_AreTakenAsFarAsThereIsRoom()
        {
            var line = Line(Vector3.zero, Vector3.one);
            line.SetPositions(new[] { Vector3.up, Vector3.down, Vector3.left });
            Assert.That(line.positionCount, Is.EqualTo(2));
            Assert.That(line.GetPosition(1), Is.EqualTo(Vector3.down));
            Assert.That(() => line.GetPosition(2), Throws.TypeOf<System.IndexOutOfRangeException>());
            line.positionCount = 3;
            Assert.That(line.GetPosition(2), Is.EqualTo(Vector3.zero));
            var copy = Own(UnityEngine.Object.Instantiate(line.gameObject)).GetComponent<LineRenderer>();
            Assert.That((copy.positionCount, copy.GetPosition(0), copy.startWidth), Is.EqualTo((3, Vector3.up, 1f)));
        }

        [Test]
        public void TextureModes_SayHowCoordinatesRun()
        {
            var line = Line(Vector3.zero, new Vector3(1, 0, 0), new Vector3(4, 0, 0));
            Assert.That(Ends(LineTextureMode.Stretch), Is.EqualTo(new[] { 0, 0.25f, 1 }));
            Assert.That(Ends(LineTextureMode.Tile), Is.EqualTo(new[] { 0, 1f, 4 }));
            Assert.That(Ends(LineTextureMode.DistributePerSegment), Is.EqualTo(new[] { 0, 0.5f, 1 }));
            Assert.That(Ends(LineTextureMode.RepeatPerSegment), Is.EqualTo(new[] { 0, 1f, 2 }));

            float[] Ends(LineTextureMode mode)
            {
                line.textureMode = mode;
                var mesh = Own(new Mesh());
                line.BakeMesh(mesh, Parallel(null));
                return mesh.uv.Select(c => c.x).Where((_, i) => i % 2 == 0).ToArray();
            }
        }

        LineRenderer Line(params Vector3[] points)
        {
            var line = Own(new GameObject("line")).AddComponent<LineRenderer>();
            line.sharedMaterial = BuiltinAssets.Material(BuiltinAssets.DefaultLine);
            line.positionCount = points.Length;
            line.SetPositions(points);
            return line;
        }

        /// <summary>Sees four units.</summary>
        Camera Parallel(RenderTexture target)
        {
            var camera = Camera(target);
            camera.orthographic = true;
            camera.orthographicSize = 2;
            return camera;
        }

        static int Column(RenderTexture target, int x) => Pixels(target).Where((c, i) => i % Size == x && c.a > 0.5f).Count();

        static int Row(RenderTexture target, int y) => Pixels(target).Where((c, i) => i / Size == y && c.a > 0.5f).Count();
    }
}
