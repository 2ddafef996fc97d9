using AnatomyCarve.Editor;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>The box in the Scene view is the volume's.</summary>
    sealed class BoxFrameTests
    {
        /// <summary>Oblique and sheared.</summary>
        static readonly VolumeGeometry Volume = new VolumeGeometry(10, 20, 30, Affine.FromColumns(
            new VectorMm(2, 0.5, 0), new VectorMm(-0.5, 1.5, 0.25), new VectorMm(0.1, 0, -3), new PointMm(100, -40, 7)));

        [Test]
        public void Corners_OfTheUnitCube_BecomeTheVolumes()
        {
            Matrix4x4 frame = BoxFrame.UnitCubeToLocal(Volume);
            for (int corner = 0; corner < 8; corner++)
            {
                int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2 & 1;
                Vector3 expected = VolumeSpace.LpsToLocal(Volume, Volume.IjkToLps.TransformPoint(new PointMm(10 * i - 0.5, 20 * j - 0.5, 30 * k - 0.5)));
                Vector3 actual = frame.MultiplyPoint3x4(new Vector3(i - 0.5f, j - 0.5f, k - 0.5f));
                Assert.That(Vector3.Distance(actual, expected), Is.LessThan(1e-6f), $"corner {corner}");
            }
        }

        [Test]
        public void Extents_HoldAllCornersAndTouchThem()
        {
            Vector3 extents = BoxFrame.Extents(Volume), largest = Vector3.zero;
            Matrix4x4 frame = BoxFrame.UnitCubeToLocal(Volume);
            for (int corner = 0; corner < 8; corner++)
            {
                Vector3 point = frame.MultiplyPoint3x4(new Vector3((corner & 1) - 0.5f, (corner >> 1 & 1) - 0.5f, (corner >> 2 & 1) - 0.5f));
                largest = Vector3.Max(largest, new Vector3(Mathf.Abs(point.x), Mathf.Abs(point.y), Mathf.Abs(point.z)));
            }
            Assert.That(Vector3.Distance(extents, largest), Is.LessThan(1e-6f));
        }
    }
}
