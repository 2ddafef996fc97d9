using System;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>Settings refuse what lies outside their ranges, and presets differ.</summary>
    sealed class SettingsTests
    {
        [TestCase(0f)]
        [TestCase(5f)]
        [TestCase(float.NaN)]
        public void Step_OutsideItsRange_IsRefused(float step) =>
            Assert.That(() => new RenderQuality { Step = step }, Throws.TypeOf<ArgumentOutOfRangeException>());

        [TestCase(-0.1f)]
        [TestCase(1.1f)]
        public void AntiAliasing_OutsideItsRange_IsRefused(float strength) =>
            Assert.That(() => new RenderQuality { AntiAliasing = strength }, Throws.TypeOf<ArgumentOutOfRangeException>());

        [Test]
        public void Presets_FromFastToBest_HaveShorterSteps()
        {
            float before = float.PositiveInfinity;
            foreach (string name in RenderQuality.Names)
            {
                float step = RenderQuality.Named(name).Step;
                Assert.That(step, Is.LessThan(before), name);
                before = step;
            }
        }

        [Test]
        public void Preset_OfAnUnknownName_IsRefusedWithTheKnownNames() =>
            Assert.That(() => RenderQuality.Named("finest"), Throws.ArgumentException.With.Message.Contain("fast, balanced, best"));

        [Test]
        public void LightDirection_ThatIsNone_IsRefused([Values(0f, float.NaN, float.PositiveInfinity)] float z) =>
            Assert.That(() => new LightSettings { Direction = new Vector3(0f, 0f, z) }, Throws.TypeOf<ArgumentOutOfRangeException>());

        [Test]
        public void LightDirection_OfAnyLength_IsADirection([Values(1e-42f, 1e-20f, 1e-5f, 1f, 1e30f)] float length)
        {
            var light = new LightSettings { Direction = new Vector3(0f, length, 0f) };
            Assert.That((light.UnitDirection - Vector3.up).magnitude, Is.LessThan(1e-6f));
        }

        [TestCase(0.5f)]
        [TestCase(float.NaN)]
        public void Shininess_OutsideItsRange_IsRefused(float shininess) =>
            Assert.That(() => new LightSettings { Shininess = shininess }, Throws.TypeOf<ArgumentOutOfRangeException>());

        [TestCase(1, 1, 1)]
        [TestCase(65535, 65535, 1)]
        [TestCase(65536, 32768, 2)]
        [TestCase(1073741824, 65533, 16385)]
        public void Groups_OfManyBricks_StayWithinTheLimitOfAnAxis(int bricks, int perRow, int rows)
        {
            Assert.That(ComputeKernel.SplitGroups(bricks), Is.EqualTo((perRow, rows)));
            Assert.That((long)perRow * rows, Is.GreaterThanOrEqualTo(bricks));
        }
    }
}
