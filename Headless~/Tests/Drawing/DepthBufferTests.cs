using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Drawing
{
    /// <summary>Stored depths as millimetres, against values computed by hand.</summary>
    public sealed class DepthBufferTests
    {
        /// <summary>90 degrees both ways, so that the ray of the pixel at (x, y) of 2 x 2 has the slopes -1/2 or 1/2.</summary>
        static readonly Matrix4x4 Square = Matrix4x4.Frustum(-1f, 1f, -1f, 1f, 1f, 4f);

        [TestCase(1f, 1f)]
        [TestCase(0.2f, 2.5f)] // 1 / (0.2 * (1 - 1/4) + 1/4)
        [TestCase(0f, float.PositiveInfinity)]
        public void ToMillimetres_OfAStoredValue_IsTheDistanceAlongTheRay(float stored, float alongTheView)
        {
            float expected = 1000f * alongTheView * Mathf.Sqrt(1.5f);
            Assert.That(DepthBuffer.ToMillimetres([stored, stored, stored, stored], 2, Square, 1f, 4f), Is.All.EqualTo(expected).Within(1e-3f));
        }

        [Test]
        public void ToMillimetres_OfAnOffCentreProjection_KnowsWhereThePixelIs()
        {
            // From straight ahead to 2 to the right: the two pixels look 0.5 and 1.5 to the right.
            float[] distances = DepthBuffer.ToMillimetres([1f, 1f], 2, Matrix4x4.Frustum(0f, 2f, -1f, 1f, 1f, 4f), 1f, 4f);
            Assert.That(distances[0], Is.EqualTo(1000f * Mathf.Sqrt(1.25f)).Within(1e-3f));
            Assert.That(distances[1], Is.EqualTo(1000f * Mathf.Sqrt(3.25f)).Within(1e-3f));
        }
    }
}
