using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Desktop.Tests
{
    /// <summary>A point in a plane on the mouse, and what a wheel reports.</summary>
    sealed class PlaneDragTests
    {
        [Test]
        public void Point_Dragged_StaysInItsPlaneAndAtItsDistanceFromTheMouse()
        {
            var random = new System.Random(7);
            for (int n = 0; n < 200; n++)
            {
                Vector3 eye = Any(random), forward = Any(random).normalized, point = eye + forward * 2f + Any(random) * 0.3f;
                var first = new Ray(eye, point + Any(random) * 0.2f - eye);
                Assert.That(PlaneDrag.TryBegin(first, forward, point, out PlaneDrag drag), Is.True, $"seed 7, case {n}");
                Assert.That(drag.TryMove(first, out Vector3 still), Is.True);
                Assert.That(Vector3.Distance(still, point), Is.LessThan(1e-4f), "where the mouse did not move");
                var second = new Ray(eye, point + Any(random) * 0.2f - eye);
                Assert.That(drag.TryMove(second, out Vector3 moved), Is.True);
                Assert.That(Vector3.Dot(moved - point, forward), Is.EqualTo(0f).Within(1e-4f), "in the plane");
                Assert.That(Vector3.Distance(moved - point, Meets(second, forward, point) - Meets(first, forward, point)), Is.LessThan(1e-4f));
            }
        }

        [Test]
        public void Point_BehindTheView_IsNotDragged()
        {
            Assert.That(PlaneDrag.TryBegin(new Ray(Vector3.zero, Vector3.forward), Vector3.forward, new Vector3(0f, 0f, -1f), out _), Is.False);
            Assert.That(PlaneDrag.TryBegin(new Ray(Vector3.zero, Vector3.right), Vector3.forward, new Vector3(0f, 0f, 1f), out _), Is.False, "parallel");
        }

        [TestCase(1f, false, 1f)]
        [TestCase(-0.25f, false, -0.25f)]
        [TestCase(120f, true, 1f)]
        [TestCase(-240f, true, -2f)]
        [TestCase(500f, false, 10f)]
        public void Wheel_InEitherRange_CountsNotches(float reported, bool isWindowsRange, float expected) =>
            Assert.That(Wheel.Notches(reported, isWindowsRange), Is.EqualTo(expected));

        static Vector3 Any(System.Random random) =>
            new Vector3((float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f);

        static Vector3 Meets(Ray ray, Vector3 normal, Vector3 point) =>
            ray.GetPoint(Vector3.Dot(point - ray.origin, normal) / Vector3.Dot(ray.direction, normal));
    }
}
