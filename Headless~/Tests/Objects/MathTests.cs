using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools.Utils;

namespace AnatomyCarve.Headless.Tests.Objects
{
    /// <summary>Against values worked out by hand.</summary>
    public sealed class MathTests
    {
        static readonly Vector3EqualityComparer s_Near = new(1E-5f);

        [Test]
        public void Turn_By90AboutY_TakesForwardToRight() =>
            Assert.That(Quaternion.AngleAxis(90f, Vector3.up) * Vector3.forward, Is.EqualTo(Vector3.right).Using(s_Near));

        [Test]
        public void Turn_By90AboutX_TakesForwardToDown() =>
            Assert.That(Quaternion.Euler(90f, 0f, 0f) * Vector3.forward, Is.EqualTo(Vector3.down).Using(s_Near));

        [Test]
        public void Euler_AppliesZThenXThenY() =>
            // z: up -> left; x: left stays; y by 90: left (-x) -> forward (+z).
            Assert.That(Quaternion.Euler(90f, 90f, 90f) * Vector3.up, Is.EqualTo(Vector3.forward).Using(s_Near));

        [TestCase(10f, 20f, 30f)]
        [TestCase(350f, 100f, 200f)]
        [TestCase(45f, 0f, 0f)]
        [TestCase(80f, 300f, 1f)]
        public void EulerAngles_OfEuler_AreTheSame(float x, float y, float z) =>
            Assert.That(Quaternion.Euler(x, y, z).eulerAngles, Is.EqualTo(new Vector3(x, y, z)).Using(new Vector3EqualityComparer(1E-4f)));

        [Test]
        public void Product_AppliesTheRightHandSideFirst()
        {
            var p = Quaternion.AngleAxis(90f, Vector3.up) * Quaternion.AngleAxis(90f, Vector3.right);
            Assert.That(p * Vector3.forward, Is.EqualTo(Vector3.down).Using(s_Near));
        }

        [Test]
        public void LookRotation_TakesForwardAndUpThere()
        {
            var q = Quaternion.LookRotation(Vector3.left, Vector3.forward);
            Assert.That(q * Vector3.forward, Is.EqualTo(Vector3.left).Using(s_Near));
            Assert.That(q * Vector3.up, Is.EqualTo(Vector3.forward).Using(s_Near));
        }

        [Test]
        public void FromToRotation_OfOppositeVectors_TurnsByHalf() =>
            Assert.That(Quaternion.FromToRotation(Vector3.up, Vector3.down) * Vector3.up, Is.EqualTo(Vector3.down).Using(s_Near));

        [Test]
        public void Slerp_Halfway_IsHalfTheTurn() =>
            Assert.That(Quaternion.Slerp(Quaternion.identity, Quaternion.AngleAxis(90f, Vector3.up), 0.5f),
                Is.EqualTo(Quaternion.AngleAxis(45f, Vector3.up)).Using(QuaternionEqualityComparer.Instance));

        [Test]
        public void Cross_FollowsTheUsualFormula() => Assert.That(Vector3.Cross(Vector3.right, Vector3.up), Is.EqualTo(Vector3.forward));

        [Test]
        public void Matrix_Index_CountsDownTheColumns()
        {
            var m = Matrix4x4.identity;
            m[4] = 5f;
            Assert.That((m.m01, m[0, 1]), Is.EqualTo((5f, 5f)));
        }

        [Test]
        public void Trs_ScalesThenTurnsThenMoves()
        {
            var m = Matrix4x4.TRS(new Vector3(1f, 0f, 0f), Quaternion.AngleAxis(90f, Vector3.up), new Vector3(1f, 1f, 3f));
            Assert.That(m.MultiplyPoint3x4(Vector3.forward), Is.EqualTo(new Vector3(4f, 0f, 0f)).Using(s_Near));
        }

        [Test]
        public void Matrix_Product_AppliesTheRightHandSideFirst()
        {
            var m = Matrix4x4.Translate(Vector3.right) * Matrix4x4.Scale(Vector3.one * 2f);
            Assert.That(m.MultiplyPoint3x4(Vector3.one), Is.EqualTo(new Vector3(3f, 2f, 2f)));
        }

        [Test]
        public void Inverse_TimesMatrix_IsIdentity()
        {
            var m = new Matrix4x4(new Vector4(2f, 1f, 0f, 0f), new Vector4(0f, 3f, 1f, 0f), new Vector4(1f, 0f, 4f, 0.5f), new Vector4(5f, 6f, 7f, 2f));
            var p = m.inverse * m;
            for (var i = 0; i < 16; i++)
                Assert.That(p[i], Is.EqualTo(i % 5 == 0 ? 1f : 0f).Within(1E-5f));
        }

        [Test]
        public void Inverse_OfSingularMatrix_IsZero() => Assert.That(Matrix4x4.Scale(new Vector3(1f, 0f, 1f)).inverse, Is.EqualTo(Matrix4x4.zero));

        [Test]
        public void Determinant_OfScale_IsTheProduct() => Assert.That(Matrix4x4.Scale(new Vector3(2f, 3f, -4f)).determinant, Is.EqualTo(-24f));

        [Test]
        public void Perspective_MapsNearToMinusOneAndFarToOne()
        {
            var p = Matrix4x4.Perspective(90f, 2f, 1f, 10f);
            Assert.That((p.MultiplyPoint(new Vector3(0f, 0f, -1f)).z, p.MultiplyPoint(new Vector3(0f, 0f, -10f)).z), Is.EqualTo((-1f, 1f)).Using(new Near()));
        }

        [Test]
        public void Perspective_Of90Degrees_PutsTheEdgeAtTheDistance() =>
            Assert.That(Matrix4x4.Perspective(90f, 2f, 1f, 10f).MultiplyPoint(new Vector3(4f, 2f, -2f)),
                Is.EqualTo(new Vector3(1f, 1f, 0.1111111f)).Using(s_Near));

        [Test]
        public void DecomposeProjection_GivesBackThePlanes()
        {
            var planes = Matrix4x4.Frustum(-1f, 2f, -3f, 4f, 0.5f, 20f).decomposeProjection;
            Assert.That(new[] { planes.left, planes.right, planes.bottom, planes.top, planes.zNear, planes.zFar },
                Is.EqualTo(new[] { -1f, 2f, -3f, 4f, 0.5f, 20f }).Within(1E-3f));
        }

        [TestCase(0f, (ushort)0)]
        [TestCase(1f, (ushort)0x3c00)]
        [TestCase(-2f, (ushort)0xc000)]
        [TestCase(65504f, (ushort)0x7bff)]
        [TestCase(65520f, (ushort)0x7c00)]
        [TestCase(5.9604645E-08f, (ushort)1)]
        [TestCase(float.PositiveInfinity, (ushort)0x7c00)]
        public void FloatToHalf_GivesTheBits(float value, ushort bits) => Assert.That(Mathf.FloatToHalf(value), Is.EqualTo(bits));

        [Test]
        public void FloatToHalf_AgreesWithTheFrameworkForAllHalves()
        {
            for (var bits = 0; bits < 0x7c00; bits++)
                Assert.That((Mathf.FloatToHalf((float)System.BitConverter.UInt16BitsToHalf((ushort)bits)), Mathf.HalfToFloat((ushort)bits)),
                    Is.EqualTo(((ushort)bits, (float)System.BitConverter.UInt16BitsToHalf((ushort)bits))));
        }

        [Test]
        public void FloatToHalf_BetweenTwoHalves_RoundsToEven() =>
            Assert.That((Mathf.FloatToHalf(2049f), Mathf.FloatToHalf(2051f)), Is.EqualTo(((ushort)0x6800, (ushort)0x6802)));

        [Test]
        public void Linear_OfHalfGrey_FollowsTheSrgbCurve() => Assert.That(new Color(0.5f, 0f, 1f).linear.r, Is.EqualTo(0.2140411f).Within(1E-6f));

        [Test]
        public void Color32_OfColor_Rounds() => Assert.That((Color32)new Color(0.5f, 0f, 1f, 0.1f), Is.EqualTo(new Color32(128, 0, 255, 26)));

        [Test]
        public void Round_OfHalves_GoesToEven() => Assert.That((Mathf.Round(0.5f), Mathf.Round(1.5f)), Is.EqualTo((0f, 2f)));

        [Test]
        public void VectorEquality_IsApproximate() => Assert.That(Vector3.one == Vector3.one * 1.000001f, Is.True);

        [Test]
        public void VectorToString_HasTwoDecimals() =>
            Assert.That(new Vector3(1f, 2.345f, -3f).ToString(), Is.EqualTo("(1.00, 2.35, -3.00)").Or.EqualTo("(1.00, 2.34, -3.00)"));

        [Test]
        public void Plane_Raycast_FindsTheDistance()
        {
            new Plane(Vector3.up, new Vector3(0f, 2f, 0f)).Raycast(new Ray(new Vector3(0f, 5f, 0f), Vector3.down), out var enter);
            Assert.That(enter, Is.EqualTo(3f));
        }

        [Test]
        public void Plane_Translate_MovesAgainstTheTranslation()
        {
            var plane = new Plane(Vector3.up, Vector3.zero);
            plane.Translate(Vector3.up);
            Assert.That(plane.GetDistanceToPoint(Vector3.down), Is.Zero);
        }

        [Test]
        public void Bounds_IntersectRay_FindsTheEntry()
        {
            new Bounds(Vector3.zero, Vector3.one * 2f).IntersectRay(new Ray(new Vector3(0f, 0f, -5f), Vector3.forward), out var distance);
            Assert.That(distance, Is.EqualTo(4f));
        }

        sealed class Near : System.Collections.Generic.IEqualityComparer<(float, float)>
        {
            public bool Equals((float, float) x, (float, float) y) => Mathf.Abs(x.Item1 - y.Item1) < 1E-5f && Mathf.Abs(x.Item2 - y.Item2) < 1E-5f;

            public int GetHashCode((float, float) obj) => 0;
        }
    }
}
