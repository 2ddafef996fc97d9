using System;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Desktop.Tests
{
    /// <summary>Poses of a view around a centre, without a camera.</summary>
    sealed class OrbitTests
    {
        const float Tolerance = 1e-4f;

        [Test]
        public void Pose_Looking_SeesTheCentreFromWhereItStands(
            [Values(-80f, -10f, 0f, 45f)] float pitch, [Values(-170f, -90f, 0f, 30f, 120f)] float yaw)
        {
            var centre = new Vector3(0.3f, -0.2f, 0.5f);
            var pose = new OrbitPose(centre, yaw, pitch, 2f);
            OrbitPose again = OrbitPose.Looking(pose.Position(2f), Quaternion.identity, centre);
            Assert.That(again.Pitch, Is.EqualTo(pitch).Within(1e-3f));
            Assert.That(Mathf.DeltaAngle(again.Yaw, yaw), Is.EqualTo(0f).Within(1e-3f));
            Assert.That(again.Distance, Is.EqualTo(2f).Within(Tolerance));
            Assert.That(Vector3.Distance(pose.Position(2f) + pose.Rotation * Vector3.forward * 2f, centre), Is.LessThan(Tolerance));
        }

        [Test]
        public void Pose_InItsCentre_KeepsItsDirection()
        {
            OrbitPose pose = OrbitPose.Looking(Vector3.one, Quaternion.Euler(20f, 70f, 0f), Vector3.one);
            Assert.That(pose.Pitch, Is.EqualTo(20f).Within(1e-2f));
            Assert.That(pose.Yaw, Is.EqualTo(70f).Within(1e-2f));
        }

        [Test]
        public void Pose_StraightAbove_KeepsItsYaw()
        {
            OrbitPose pose = OrbitPose.Looking(new Vector3(0f, 3f, 0f), Quaternion.Euler(80f, 70f, 0f), Vector3.zero);
            Assert.That(pose.Pitch, Is.EqualTo(90f).Within(1e-2f));
            Assert.That(pose.Yaw, Is.EqualTo(70f).Within(1e-2f));
        }

        [TestCase(1f, 40f)]
        [TestCase(0.5f, 40f)]
        [TestCase(1.8f, 60f)]
        public void Pose_Framing_SeesAllOfTheBallAndNotMuchMore(float aspect, float fov)
        {
            OrbitPose pose = new OrbitPose(Vector3.zero, 30f, 20f, 1f).Framing(new Vector3(1f, 2f, 3f), 0.5f, fov, aspect);
            float vertical = 0.5f * fov * Mathf.Deg2Rad, horizontal = Mathf.Atan(Mathf.Tan(vertical) * aspect);
            float seen = Mathf.Asin(0.5f / pose.Distance);
            Assert.That(seen, Is.EqualTo(Mathf.Min(vertical, horizontal)).Within(1e-4f));
            Assert.That(pose.Centre, Is.EqualTo(new Vector3(1f, 2f, 3f)));
        }

        [Test]
        public void Step_InManyFramesOrInOne_ComesAsFar()
        {
            Orbit one = Sent(), many = Sent();
            one.Step(0.1f, 0.08f);
            for (int n = 0; n < 20; n++)
                many.Step(0.005f, 0.08f);
            Assert.That(many.Current.Yaw, Is.EqualTo(one.Current.Yaw).Within(1e-3f));
            Assert.That(many.Current.Distance, Is.EqualTo(one.Current.Distance).Within(1e-4f));
            Assert.That(one.Current.Yaw, Is.EqualTo(100f * (1f - Mathf.Exp(-0.1f / 0.08f))).Within(1e-3f));
        }

        [Test]
        public void Step_WithoutASmoothTime_Arrives()
        {
            Orbit orbit = Sent();
            orbit.Step(0.001f, 0f);
            Assert.That(orbit.Current.Yaw, Is.EqualTo(100f));
        }

        [Test]
        public void Step_LongEnough_ArrivesExactly()
        {
            Orbit orbit = Sent();
            for (int n = 0; n < 400; n++)
                orbit.Step(0.014f, 0.08f);
            Assert.That(orbit.Current, Is.EqualTo(orbit.Goal));
        }

        [Test]
        public void Scale_AgainAndAgain_StopsBeforeTheCentre()
        {
            Orbit orbit = Sent();
            for (int n = 0; n < 1000; n++)
                orbit.Scale(0.5f);
            Assert.That(orbit.Goal.Distance, Is.EqualTo(orbit.Limits.MinDistance));
            for (int n = 0; n < 1000; n++)
                orbit.Scale(2f);
            Assert.That(orbit.Goal.Distance, Is.EqualTo(orbit.Limits.MaxDistance));
        }

        [Test]
        public void Turn_BeyondThePoles_Stops()
        {
            Orbit orbit = Sent();
            orbit.Turn(0f, 500f);
            Assert.That(orbit.Goal.Pitch, Is.EqualTo(orbit.Limits.MaxPitch));
            orbit.Turn(0f, -500f);
            Assert.That(orbit.Goal.Pitch, Is.EqualTo(orbit.Limits.MinPitch));
        }

        [Test]
        public void Slide_ToTheRight_MovesTheCentreInThePicturesPlane()
        {
            var orbit = new Orbit(new OrbitPose(Vector3.zero, 90f, 0f, 1f));
            orbit.Slide(0.2f, 0.1f);
            // A view along +x has -z at its right.
            Assert.That(Vector3.Distance(orbit.Goal.Centre, new Vector3(0f, 0.1f, -0.2f)), Is.LessThan(Tolerance));
        }

        [Test]
        public void GoHome_AfterManyTurns_TakesTheShortWay()
        {
            var orbit = new Orbit(new OrbitPose(Vector3.zero, 10f, 5f, 1f));
            orbit.Turn(720f + 30f, 20f);
            orbit.Arrive();
            orbit.GoHome();
            Assert.That(orbit.Goal.Yaw, Is.EqualTo(730f).Within(Tolerance), "twice around is the same place");
            Assert.That(orbit.Goal.Pitch, Is.EqualTo(5f).Within(Tolerance));
        }

        [Test]
        public void Limits_MadeNarrower_MoveTheGoal()
        {
            Orbit orbit = Sent();
            orbit.Limits = new OrbitLimits(0.5f, 0.7f, -10f, 10f);
            Assert.That(orbit.Goal.Distance, Is.EqualTo(0.7f));
        }

        [TestCase(0f, 1f, -10f, 10f)]
        [TestCase(1f, 0.5f, -10f, 10f)]
        [TestCase(1f, float.PositiveInfinity, -10f, 10f)]
        [TestCase(float.NaN, 1f, -10f, 10f)]
        [TestCase(1f, 2f, -91f, 10f)]
        [TestCase(1f, 2f, 20f, 10f)]
        [TestCase(1f, 2f, 0f, 91f)]
        public void Limits_ThatAreNone_AreRefused(float near, float far, float low, float high) =>
            Assert.That(() => new OrbitLimits(near, far, low, high), Throws.TypeOf<ArgumentException>());

        [Test]
        public void Limits_OfAnEmptyInspector_BecomePossible()
        {
            OrbitLimits clamped = default(OrbitLimits).Clamped();
            Assert.That(clamped.MinDistance, Is.EqualTo(OrbitLimits.SmallestDistance));
            Assert.That(clamped.MaxDistance, Is.EqualTo(OrbitLimits.SmallestDistance));
            Assert.That(clamped.MaxPitch, Is.Zero);
        }

        static Orbit Sent()
        {
            var orbit = new Orbit(new OrbitPose(Vector3.zero, 0f, 0f, 1f));
            orbit.Turn(100f, 0f);
            orbit.Scale(2f);
            return orbit;
        }
    }
}
