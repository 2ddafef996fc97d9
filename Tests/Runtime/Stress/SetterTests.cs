using System;
using System.Collections.Generic;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Stress
{
    /// <summary>Every public setter of a number refuses what is not one, by an error that names the setting, and keeps what it had; -0 is 0.</summary>
    sealed class SetterTests : StressScene
    {
        static readonly float[] NotFinite = { float.NaN, float.PositiveInfinity, float.NegativeInfinity };

        static readonly RenderQuality Quality = new RenderQuality();
        static readonly LightSettings Lighting = new LightSettings();
        static readonly RaySettings Rays = new RaySettings();
        static readonly CarvingStack Carving = new CarvingStack(3);

        /// <summary>Name, setter, getter, and whether -0 (which is 0) lies within the range.</summary>
        static IEnumerable<TestCaseData> Settings()
        {
            yield return Setting("Step", v => Quality.Step = v, () => Quality.Step, false);
            yield return Setting("AntiAliasing", v => Quality.AntiAliasing = v, () => Quality.AntiAliasing, true);
            yield return Setting("OpaqueAlpha", v => Quality.OpaqueAlpha = v, () => Quality.OpaqueAlpha, false);
            yield return Setting("FirstVisibleAlpha", v => Quality.FirstVisibleAlpha = v, () => Quality.FirstVisibleAlpha, false);
            yield return Setting("Ambient", v => Lighting.Ambient = v, () => Lighting.Ambient, true);
            yield return Setting("Diffuse", v => Lighting.Diffuse = v, () => Lighting.Diffuse, true);
            yield return Setting("Specular", v => Lighting.Specular = v, () => Lighting.Specular, true);
            yield return Setting("Shininess", v => Lighting.Shininess = v, () => Lighting.Shininess, false);
            yield return Setting("Direction", v => Lighting.Direction = new Vector3(0f, v, 0f), () => Lighting.Direction.y, false);
            yield return Setting("value", v => Rays.StepReference = v, () => (float)Rays.StepReference, false).SetName("{m}(RaySettings.StepReference)");
            yield return Setting("value", v => Rays.FirstVisibleAlpha = v, () => (float)Rays.FirstVisibleAlpha, false)
                .SetName("{m}(RaySettings.FirstVisibleAlpha)");
            yield return Setting("value", v => Rays.OpaqueAlpha = v, () => (float)Rays.OpaqueAlpha, false).SetName("{m}(RaySettings.OpaqueAlpha)");
            yield return Setting("value", v => Carving.ActiveRadiusFactor = v, () => Carving.ActiveRadiusFactor, false)
                .SetName("{m}(CarvingStack.ActiveRadiusFactor)");
        }

        /// <summary>What cannot be made of numbers that are none: the argument's name, and the making.</summary>
        static IEnumerable<TestCaseData> Makings()
        {
            SegmentMask mask = SegmentMask.All(3);
            SegmentTable table = SegmentTable.UnlabelledOnly();
            yield return Value("radiusMm", v => new ClipSphere(default, v, mask), "ClipSphere, radius");
            yield return Value("centerLps", v => new ClipSphere(new PointMm(0, v, 0), 1, mask), "ClipSphere, centre");
            yield return Value("radiusMm", v => Carving.SetActive(default, v), "CarvingStack.SetActive, radius");
            yield return Value("centerLps", v => Carving.SetActive(new PointMm(0, 0, v), 1), "CarvingStack.SetActive, centre");
            yield return Value("opacity", v => table.WithOpacity(0, v), "SegmentTable.WithOpacity");
            yield return Value("opacity", v => new SegmentAppearance(1, Color.white, v), "SegmentAppearance");
            yield return Value("value", v => new TransferPoint(v, 0.5), "TransferPoint, value");
            yield return Value("opacity", v => new TransferPoint(0, v), "TransferPoint, opacity");
            yield return Value("thresholdAbsolute", v => new AntiAliasSettings(thresholdAbsolute: v), "AntiAliasSettings, absolute threshold");
            yield return Value("thresholdRelative", v => new AntiAliasSettings(thresholdRelative: v), "AntiAliasSettings, relative threshold");
            yield return Value("gradientMinimum", v => new AntiAliasSettings(gradientMinimum: v), "AntiAliasSettings, gradient");
            yield return Value("strength", v => new AntiAliasSettings(strength: v), "AntiAliasSettings, strength");
        }

        [TestCaseSource(nameof(Settings))]
        public void Setter_OfWhatIsNoNumber_NamesItAndChangesNothing(string name, Action<float> set, Func<float> get, bool takesZero)
        {
            float before = get();
            foreach (float value in NotFinite)
            {
                AssertRefused(name, value, set);
                Assert.That(get(), Is.EqualTo(before));
            }
        }

        [TestCaseSource(nameof(Settings))]
        public void Setter_OfMinusZero_TakesItAsZero(string name, Action<float> set, Func<float> get, bool takesZero)
        {
            float before = get();
            if (!takesZero)
            {
                AssertRefused(name, -0f, set);
                return;
            }
            set(-0f);
            Assert.That(get(), Is.Zero);
            set(before);
        }

        [TestCaseSource(nameof(Makings))]
        public void Value_OfWhatIsNoNumber_IsRefusedByName(string name, Action<float> make)
        {
            foreach (float value in NotFinite)
                AssertRefused(name, value, make);
        }

        [Test]
        public void Components_GivenWhatIsNoNumber_RefuseItByNameAndShowWhatTheyShowed()
        {
            CarvedVolumeRenderer renderer = MakeRamp(Ball(Grid(12, 11, 10, 1, 1, 1)));
            var pointer = renderer.gameObject.AddComponent<SegmentPointer>();
            renderer.Stack.SetActive(Vector3.zero, 0.003f);
            VectorMm towardsEye = new VectorMm(0, -1, 0);
            PictureData before = renderer.Render(Look(renderer.Volume.Geometry, towardsEye, 16)).Read();
            int version = renderer.Stack.Carving.Version;
            foreach (float value in NotFinite)
            {
                AssertRefused("ActiveRadiusFactor", value, v => renderer.Stack.ActiveRadiusFactor = v);
                Assert.That(() => renderer.Stack.SetActive(new Vector3(value, 0f, 0f), 0.001f), Throws.InstanceOf<ArgumentException>(), "centre");
                Assert.That(() => renderer.Stack.SetActive(Vector3.zero, value), Throws.InstanceOf<ArgumentException>(), "radius");
            }
            AssertRefused("MaxDistance", float.NaN, v => pointer.MaxDistance = v);
            AssertRefused("MaxDistance", float.NegativeInfinity, v => pointer.MaxDistance = v);
            Assert.That(renderer.Stack.Carving.Version, Is.EqualTo(version));
            AssertSamePicture(before, renderer.Render(Look(renderer.Volume.Geometry, towardsEye, 16)).Read());
        }

        [Test]
        public void Light_OfAColourThatIsNone_IsRefusedOrShownAsAColour(
            [Values(float.NaN, float.PositiveInfinity, float.NegativeInfinity, -1f)] float channel)
        {
            CarvedVolumeRenderer renderer = MakeRamp(Ball(Grid(12, 11, 10, 1, 1, 1)));
            try
            {
                renderer.Light.Color = new Color(channel, 1f, 1f);
            }
            catch (ArgumentException)
            {
                Assert.That(renderer.Light.Color, Is.EqualTo(Color.white));
            }
            AssertSane(renderer.Render(Look(renderer.Volume.Geometry, new VectorMm(0, -1, 0), 16)).Read(), SegmentCount, "light");
        }

        [Test]
        public void Segment_OfAColourThatIsNone_IsRefusedOrShownAsAColour(
            [Values(float.NaN, float.PositiveInfinity, float.NegativeInfinity, -1f)] float channel)
        {
            CarvedVolumeRenderer renderer = MakeRamp(Ball(Grid(12, 11, 10, 1, 1, 1)));
            try
            {
                renderer.Appearance.SetSegment(new SegmentAppearance(1, new Color(channel, 1f, 1f), 1f));
            }
            catch (ArgumentException)
            {
                Assert.That(renderer.Appearance.Segments, Is.Empty);
            }
            AssertSane(renderer.Render(Look(renderer.Volume.Geometry, new VectorMm(0, -1, 0), 16)).Read(), SegmentCount, "segment");
        }

        static TestCaseData Setting(string name, Action<float> set, Func<float> get, bool takesZero) =>
            new TestCaseData(name, set, get, takesZero).SetName("{m}(" + name + ")");

        static TestCaseData Value(string argument, Action<float> make, string what) =>
            new TestCaseData(argument, make).SetName("{m}(" + what + ")");

        /// <summary>The error names the setting and says something of its range.</summary>
        static void AssertRefused(string name, float value, Action<float> set)
        {
            var error = Assert.Catch<ArgumentException>(() => set(value), $"{name} = {value}");
            Assert.That(error.ParamName, Is.EqualTo(name));
            Assert.That(error.Message.Length, Is.GreaterThan(name.Length + 10), "the range is said");
        }
    }
}
