using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Tests.Carving;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Picking
{
    /// <summary>The pointer's walk against plain marches and against bodies whose surface is known.</summary>
    public sealed class SegmentPickerTests
    {
        static readonly RaySettings Default = new RaySettings();

        [Test]
        public void Pick_RandomCarvedVolumes_IsThePlainMarchOverAllSamples()
        {
            var scenes = new RandomScenes(91);
            int hits = 0, misses = 0;
            for (int scene = 0; scene < 60; scene++)
            {
                const int SegmentCount = 5;
                SegmentedVolume volume = Blobs(scenes, SegmentCount);
                CutMode cut = scenes.Chance(0.5) ? CutMode.Smooth : CutMode.Binary;
                CarvedField field = Phantoms.Field(volume, cut, AntiAliasSettings.Default, scenes.Spheres(volume.Geometry, SegmentCount, 3).ToArray());
                for (int n = 0; n < 30; n++)
                {
                    RayMm ray = RayThrough(scenes, volume.Geometry);
                    var settings = new RaySettings { StepReference = scenes.Between(0.2, 2), FirstVisibleAlpha = scenes.Between(0.1, 0.9) };
                    SegmentHit expected = PlainMarch(field, ray, settings);
                    SegmentHit actual = SegmentPicker.Pick(field, ray, settings);
                    Assert.That(actual.Hit, Is.EqualTo(expected.Hit));
                    Assert.That(actual.Segment, Is.EqualTo(expected.Segment));
                    if (expected.Hit)
                        Assert.That(actual.DistanceMm, Is.EqualTo(expected.DistanceMm).Within(1e-9 * (1 + expected.DistanceMm)));
                    hits += expected.Hit ? 1 : 0;
                    misses += expected.Hit ? 0 : 1;
                }
            }
            TestContext.WriteLine(FormattableString.Invariant($"{hits} hits, {misses} misses"));
            Assert.That(hits, Is.GreaterThan(400));
            Assert.That(misses, Is.GreaterThan(100));
        }

        [Test]
        public void Pick_OpaqueBall_HitsItsSurfaceFromAllSides()
        {
            var scenes = new RandomScenes(92);
            VectorMm a = scenes.Direction();
            VectorMm b = a.Cross(scenes.Direction()).Normalized();
            var geometry = new VolumeGeometry(40, 44, 36, Affine.FromColumns(a, 1.1 * b, 1.2 * a.Cross(b), new PointMm(50, -80, 20)));
            const double Radius = 14;
            SegmentedVolume volume = Phantoms.On(
                geometry, 3,
                (i, j, k) => Depth(geometry, Radius, i, j, k) > 0 ? 100 : 0,
                (i, j, k) => Depth(geometry, Radius, i, j, k) > 0 ? 2 : 1);
            CarvedField field = Phantoms.Field(volume, CutMode.Binary, AntiAliasSettings.Default);
            for (int n = 0; n < 400; n++)
            {
                VectorMm outwards = scenes.Direction();
                PointMm aim = geometry.CentreLps + 0.7 * Radius * scenes.Between(0.0, 1.0) * scenes.Direction();
                PointMm eye = geometry.CentreLps + 200 * outwards;
                SegmentHit hit = SegmentPicker.Pick(field, new RayMm(eye, aim - eye), Default);
                Assert.That(hit.Segment, Is.EqualTo(2));
                Assert.That(hit.PositionLps.DistanceTo(geometry.CentreLps), Is.EqualTo(Radius).Within(1.3), "the ball is of voxels of up to 1.2 mm");
                Assert.That(hit.PositionLps.DistanceTo(eye), Is.EqualTo(hit.DistanceMm).Within(1e-9));
            }
            SegmentHit miss = SegmentPicker.Pick(field, new RayMm(geometry.CentreLps + 200 * a + (Radius + 2) * b, -a), Default);
            Assert.That(miss.Hit, Is.False);
            Assert.That(miss.DistanceMm, Is.EqualTo(double.PositiveInfinity));
        }

        /// <summary>
        /// Opacity rises linearly over a voxel: alpha reaches 0.5 far up the ramp, but the slab's edge is in its middle, and matter of less than opacity 1
        /// reaches 0.5 so far behind the edge as if that were sharp.
        /// </summary>
        [Test]
        public void Pick_Slab_HitsWhereASharpEdgeWouldBeHit()
        {
            double worst = 0;
            foreach (double opacity in new[] { 1, 0.98, 0.95, 0.9 })
            {
                var table = OpacityTransferFunction.Parse(FormattableString.Invariant($"0:0,100:{opacity}"));
                var field = new CarvedField(Slab(10, 20));
                field.Update(new ClipSphere[0], table, field.Volume.Segments, CutMode.Binary, AntiAliasSettings.Off);
                double stored = Math.Round(255 * opacity) / 255, sharp = 9.5 + (stored < 1 ? Math.Log(0.5) / Math.Log(1 - stored) : 0);
                foreach (double step in new[] { 1, 0.5, 0.25, 1.0 / 16 })
                {
                    for (int n = 0; n < 16; n++)
                    {
                        SegmentHit hit = SegmentPicker.Pick(field, new RayMm(new PointMm(15.3, 14.8, -60), new VectorMm(0, 0, 2)), new RaySettings { StepReference = step },
                            double.PositiveInfinity, 50 + n / 16.0);
                        Assert.That(hit.Segment, Is.EqualTo(1));
                        worst = Math.Max(worst, Math.Abs(hit.PositionLps.Z - sharp));
                    }
                }
            }
            TestContext.WriteLine(FormattableString.Invariant($"{worst:g3} voxel"));
            Assert.That(worst, Is.LessThanOrEqualTo(1e-9));
        }

        /// <summary>Alpha of translucent matter reaches 0.5 far behind its edge, wherever that is: no edge moves the hit.</summary>
        [Test]
        public void Pick_TranslucentSlabWithFineSteps_ConvergesToTheIntegral()
        {
            CarvedField field = new CarvedField(Slab(10, 30));
            field.Update(new ClipSphere[0], OpacityTransferFunction.Parse("0:0,100:0.2"), field.Volume.Segments, CutMode.Binary, AntiAliasSettings.Off);
            double passed = 0, z = 9; // of ln 2
            while (passed < Math.Log(2))
            {
                passed -= 1e-4 * Math.Log(1 - 0.2 * Math.Min(1, z - 9));
                z += 1e-4;
            }
            SegmentHit hit = SegmentPicker.Pick(field, new RayMm(new PointMm(15.3, 14.8, -60), new VectorMm(0, 0, 2)), new RaySettings { StepReference = 1.0 / 512 });
            Assert.That(hit.PositionLps.Z, Is.EqualTo(z).Within(1e-3));
        }

        /// <summary>
        /// A translucent layer stops hardly more, or hardly less, light than what counts as visible: whether a ray stops there must not hang on where its steps lie.
        /// </summary>
        [TestCase(4, -0.0004, 1)]
        [TestCase(4, 0.0004, 2)]
        [TestCase(5, -0.0003, 1)]
        [TestCase(5, 0.0003, 2)]
        public void Pick_LayerAtTheThreshold_FinerSumDecidesWhetherItOrTheWallBehindIsSeen(int thickness, double beyond, int segment)
        {
            var ray = new RayMm(new PointMm(15, 15, -60), new VectorMm(0, 0, 1));
            const int First = 12, Wall = 28;
            bool IsLayer(int k) => k >= First && k < First + thickness;
            var field = new CarvedField(Phantoms.Cube(
                32, 3, (i, j, k) => IsLayer(k) ? 50 : k >= Wall ? 100 : 0, (i, j, k) => IsLayer(k) ? 1 : k >= Wall ? 2 : 0));
            int rays = 0, otherwise = 0;
            for (int code = 80; code <= 140; code += 10) // reached two steps or more after nearly
            {
                double opacity = code / 255.0, alpha = 1 - Math.Exp(LogThroughLayer(opacity, thickness, 1.0 / 256, 0));
                var table = OpacityTransferFunction.Parse(FormattableString.Invariant($"0:0,50:{opacity},100:1"));
                field.Update(new ClipSphere[0], table, field.Volume.Segments, CutMode.Binary, AntiAliasSettings.Off);
                var settings = new RaySettings { StepReference = 0.5, FirstVisibleAlpha = alpha + beyond };
                for (int n = 0; n < 32; n++, rays++)
                {
                    double phase = n / 64.0;
                    SegmentHit hit = SegmentPicker.Pick(field, ray, settings, double.PositiveInfinity, 60 + phase);
                    Assert.That(hit.Segment, Is.EqualTo(segment), FormattableString.Invariant($"opacity {code} / 255, steps at {phase}"));
                    otherwise += (1 - Math.Exp(LogThroughLayer(opacity, thickness, 0.5, phase)) >= settings.FirstVisibleAlpha ? 1 : 2) != segment ? 1 : 0;
                }
            }
            TestContext.WriteLine(FormattableString.Invariant($"{rays} rays; by whole steps {otherwise} would see another segment"));
            Assert.That(otherwise, Is.GreaterThan(rays / 10));
        }

        /// <summary>The log of the light that passes some voxels of an opacity, which rises and falls linearly over a voxel, by steps.</summary>
        static double LogThroughLayer(double opacity, int thickness, double step, double phase)
        {
            double sum = 0;
            for (double z = phase - 2 + 0.5 * step; z < thickness + 1; z += step)
                sum += step * Math.Log(1 - opacity * Math.Max(0, Math.Min(1, Math.Min(z + 1, thickness - z))));
            return sum;
        }

        [Test]
        public void Pick_OpaqueMatterInAShortLastStep_StopsAllLight()
        {
            CarvedField field = Phantoms.Field(Phantoms.Cube(9, 2, (i, j, k) => 100, (i, j, k) => 1), CutMode.Binary, AntiAliasSettings.Default);
            SegmentHit hit = SegmentPicker.Pick(field, new RayMm(new PointMm(4, -100, 4), new VectorMm(0, 1, 0)), Default, 99.501);
            Assert.That(hit.DistanceMm, Is.EqualTo(99.5).Within(1e-9));
        }

        [TestCase(2.0)]
        [TestCase(1.0)]
        [TestCase(0.5)]
        [TestCase(0.25)]
        [TestCase(0.37)]
        public void Pick_UniformFog_IsIndependentOfTheStep(double step)
        {
            SegmentedVolume volume = Phantoms.Cube(32, 2, (i, j, k) => 10, (i, j, k) => 1);
            CarvedField field = Phantoms.Field(volume, CutMode.Binary, AntiAliasSettings.Default);
            double opacity = field.OpacityCode(0, 0, 0) / 255.0;
            SegmentHit hit = SegmentPicker.Pick(
                field, new RayMm(new PointMm(16, -100, 16), new VectorMm(0, 1, 0)), new RaySettings { StepReference = step });
            Assert.That(hit.DistanceMm, Is.EqualTo(99.5 + Math.Log(0.5) / Math.Log(1 - opacity)).Within(1e-9));
        }

        [Test]
        public void Pick_FogThatIsTooThinUnlessTheLastFractionOfAStepCounts_IsFound()
        {
            SegmentedVolume volume = Phantoms.Cube(10, 1, (i, j, k) => 10, (i, j, k) => 0);
            CarvedField field = Phantoms.Field(volume, CutMode.Binary, AntiAliasSettings.Off);
            double all = 1 - Math.Pow(1 - field.OpacityCode(0, 0, 0) / 255.0, 10);
            var ray = new RayMm(new PointMm(5, 5, -9), new VectorMm(0, 0, 1));
            Assert.That(SegmentPicker.Pick(field, ray, new RaySettings { StepReference = 0.7, FirstVisibleAlpha = all - 1e-6 }).Hit);
            Assert.That(SegmentPicker.Pick(field, ray, new RaySettings { StepReference = 0.7, FirstVisibleAlpha = all + 1e-6 }).Hit, Is.False);
        }

        [Test]
        public void Pick_SlabCarvedAway_SeesWhatLiesBehind()
        {
            SegmentedVolume volume = Phantoms.Cube(32, 3, (i, j, k) => k >= 8 && k < 12 || k >= 20 ? 100 : 0, (i, j, k) => k < 16 ? 1 : 2);
            var ray = new RayMm(new PointMm(15, 16, -5), new VectorMm(0, 0, 1));
            var cut = new ClipSphere(new PointMm(15, 16, 10), 8, SegmentMask.FromIndices(3, new[] { 1 }));
            var everything = new ClipSphere(new PointMm(15, 16, 10), 100, SegmentMask.All(3));
            CarvedField field = Phantoms.Field(volume, CutMode.Binary, AntiAliasSettings.Default);
            Assert.That(SegmentPicker.Pick(field, ray, Default).Segment, Is.EqualTo(1));
            field.Update(new[] { cut }, Phantoms.Ramp, volume.Segments, CutMode.Binary, AntiAliasSettings.Default);
            Assert.That(SegmentPicker.Pick(field, ray, Default).Segment, Is.EqualTo(2));
            field.Update(new[] { cut, everything }, Phantoms.Ramp, volume.Segments, CutMode.Binary, AntiAliasSettings.Default);
            Assert.That(SegmentPicker.Pick(field, ray, Default), Is.EqualTo(SegmentHit.None));
        }

        [Test]
        public void Pick_FromInsideMatter_HitsAtOnce()
        {
            CarvedField field = Phantoms.Field(Slab(4, 28), CutMode.Binary, AntiAliasSettings.Default);
            SegmentHit hit = SegmentPicker.Pick(field, new RayMm(new PointMm(16, 16, 16), new VectorMm(1, 1, 1)), Default);
            Assert.That(hit.DistanceMm, Is.EqualTo(0));
            Assert.That(hit.Segment, Is.EqualTo(1));
        }

        [TestCase(9.0, false)]
        [TestCase(40.0, true)]
        public void Pick_MaxDistance_EndsTheRay(double maxDistanceMm, bool expected)
        {
            CarvedField field = Phantoms.Field(Slab(10, 20), CutMode.Binary, AntiAliasSettings.Off);
            var ray = new RayMm(new PointMm(16, 16, 0), new VectorMm(0, 0, 1));
            Assert.That(SegmentPicker.Pick(field, ray, Default, maxDistanceMm).Hit, Is.EqualTo(expected));
            Assert.That(SegmentPicker.Pick(field, ray, Default, minDistanceMm: 25).Hit, Is.False);
        }

        [TestCase(-1.0, 0, 0)]
        [TestCase(1.0, 0, 0)]
        [TestCase(0, 0, -1.0)]
        public void Pick_RayBesideOrAwayFromTheVolume_IsNone(double x, double y, double z)
        {
            CarvedField field = Phantoms.Field(Slab(0, 32), CutMode.Binary, AntiAliasSettings.Off);
            Assert.That(SegmentPicker.Pick(field, new RayMm(new PointMm(16, 16, -2), new VectorMm(x, y, z)), Default).Hit, Is.False);
        }

        [Test]
        public void Pick_LittleMatterInALargeVolume_ComputesFewVoxels()
        {
            SegmentedVolume volume = Phantoms.Cube(96, 2, (i, j, k) => k >= 90 ? 100 : 0, (i, j, k) => 1);
            CarvedField field = Phantoms.Field(volume, CutMode.Binary, AntiAliasSettings.Default);
            Assert.That(SegmentPicker.Pick(field, new RayMm(new PointMm(44, 44, -10), new VectorMm(0, 0, 1)), Default).Hit);
            Assert.That(field.AntiAliasedVoxelsComputed, Is.LessThanOrEqualTo(100), "of 884,736; last seen: 44");
        }

        [Test]
        public void Pick_RayThatWasNeverMade_Throws()
        {
            CarvedField field = Phantoms.Field(Slab(0, 32), CutMode.Binary, AntiAliasSettings.Off);
            Assert.That(() => SegmentPicker.Pick(field, default, Default), Throws.InstanceOf<ArgumentException>());
            Assert.That(() => SegmentPicker.Pick(field, new RayMm(default, new VectorMm(1, 0, 0)), Default, double.NaN), Throws.InstanceOf<ArgumentException>());
        }

        static SegmentedVolume Slab(int first, int end) =>
            Phantoms.Cube(32, 2, (i, j, k) => k >= first && k < end ? 100 : 0, (i, j, k) => k >= first && k < end ? 1 : 0);

        static double Depth(VolumeGeometry geometry, double radius, int i, int j, int k) =>
            radius - geometry.IjkToLps.TransformPoint(new PointMm(i, j, k)).DistanceTo(geometry.CentreLps);

        /// <summary>A few balls of different opacity, mostly empty space around them.</summary>
        static SegmentedVolume Blobs(RandomScenes scenes, int segmentCount)
        {
            VolumeGeometry geometry = scenes.Geometry(40);
            List<(VectorMm Place, double Radius, int Code)> balls = Enumerable.Range(0, 6).Select(_ => (
                new VectorMm(scenes.Next(geometry.SizeI), scenes.Next(geometry.SizeJ), scenes.Next(geometry.SizeK)),
                scenes.Between(1.0, 6.0), scenes.Between(5, 100))).ToList();
            int BallAt(int i, int j, int k) => balls.FindIndex(ball => (new VectorMm(i, j, k) - ball.Place).Length < ball.Radius);
            return Phantoms.On(
                geometry, segmentCount,
                (i, j, k) => BallAt(i, j, k) < 0 ? 0 : balls[BallAt(i, j, k)].Code,
                (i, j, k) => Math.Max(0, BallAt(i, j, k)) % segmentCount);
        }

        static RayMm RayThrough(RandomScenes scenes, VolumeGeometry geometry)
        {
            PointMm through = geometry.IjkToLps.TransformPoint(new PointMm(
                scenes.Between(0.0, geometry.SizeI - 1), scenes.Between(0.0, geometry.SizeJ - 1), scenes.Between(0.0, geometry.SizeK - 1)));
            VectorMm direction = scenes.Chance(0.3) ? geometry.IjkToLps.TransformVector(new VectorMm(0, scenes.Chance(0.5) ? 1 : -1, 0)) : scenes.Direction();
            return new RayMm(scenes.Chance(0.2) ? through : through - scenes.Between(10.0, 200.0) * direction, direction);
        }

        /// <summary>The definition, sample after sample, without skipping anything.</summary>
        static SegmentHit PlainMarch(CarvedField field, RayMm ray, RaySettings settings)
        {
            VolumeGeometry geometry = field.Volume.Geometry;
            PointMm o = geometry.LpsToIjk.TransformPoint(ray.Origin);
            VectorMm d = geometry.LpsToIjk.TransformVector(ray.Direction);
            double near = 0, far = double.PositiveInfinity;
            foreach ((double start, double velocity, int size) in new[] { (o.X, d.X, geometry.SizeI), (o.Y, d.Y, geometry.SizeJ), (o.Z, d.Z, geometry.SizeK) })
            {
                if (velocity == 0)
                    continue;
                double a = (-0.5 - start) / velocity, b = (size - 0.5 - start) / velocity;
                near = Math.Max(near, Math.Min(a, b));
                far = Math.Min(far, Math.Max(a, b));
            }
            double step = settings.StepReference * geometry.ReferenceLengthMm;
            double Passing(double from, double to) => Math.Pow(1 - Sample(field, o + 0.5 * (from + to) * d), (to - from) / geometry.ReferenceLengthMm);
            SegmentHit HitAt(double distance, double sampleAt, double depth)
            {
                PointMm there = o + distance * d, sample = o + sampleAt * d;
                int segment = field.SegmentAt(there.X, there.Y, there.Z);
                return new SegmentHit(segment >= 0 ? segment : field.SegmentAt(sample.X, sample.Y, sample.Z), ray.At(depth), depth);
            }
            var light = new List<double> { 1 }; // that comes to each step
            while (near + (light.Count - 1) * step < far && 1 - light[light.Count - 1] < settings.OpaqueAlpha)
            {
                double begin = near + (light.Count - 1) * step;
                light.Add(light[light.Count - 1] * Passing(begin, Math.Min(begin + step, far)));
            }
            double wanted = 1 - settings.FirstVisibleAlpha;
            int StepThatReaches(double alpha) => light.FindIndex(left => 1 - left >= alpha) - 1;
            int nearly = StepThatReaches(0.9 * settings.FirstVisibleAlpha), reached = StepThatReaches(settings.FirstVisibleAlpha);
            if (nearly < 0)
                return SegmentHit.None;
            int around = reached >= 0 && reached <= nearly + 1 ? reached : nearly;
            if (around != reached)
            {
                int matter = around; // where it begins
                while (matter > 0 && light[matter] < light[matter - 1])
                    matter--;
                around = around > matter + 32 ? around : matter;
            }
            int first = Math.Max(around - 1, 0);
            double passing = light[first], furthest = Math.Min(near + (Math.Max(nearly, reached) + 33) * step, far);
            double OpacityAt(double place) => Sample(field, o + (near + place * step) * d); // in steps
            double length = settings.StepReference, plateau = 2.5 / length, last = Math.Max(nearly, reached);
            double peak = OpacityAt(Math.Min(last + 1 + plateau, (far - near) / step));
            bool IsNear(int n) => n <= nearly + plateau || (reached >= 0 && n >= reached && n <= reached + plateau);
            for (int n = nearly; n < light.Count - 1 && 1 - light[n] < RaySettings.DefaultOpaqueAlpha; n++)
                peak = !IsNear(n) ? peak : Math.Max(peak, OpacityAt(0.5 * (n + Math.Min(n + 1, (far - near) / step))));
            double thickness = Math.Log(1 - settings.FirstVisibleAlpha) / Math.Log(Math.Max(1 - peak, 1 / 255.0)) * Math.Min(255 * (1 - peak), 1);
            double DepthOf(double position, double sampled)
            {
                double begin = Math.Max(first + 0.5 - Math.Max(Math.Ceiling(0.5 / length), 1), 0), edge = -1, before = 0, at = begin;
                for (double place = begin + 0.125; place < sampled + 1e-9; place += 0.25)
                {
                    double middle = Math.Abs(place - sampled) < 0.13 ? sampled : place, opacity = OpacityAt(middle); // the last one may be short
                    if (opacity < 0.5 * peak)
                        edge = double.NaN;
                    else if (double.IsNaN(edge))
                        edge = at + (0.5 * peak - before) / (opacity - before) * (middle - at);
                    else if (edge < 0)
                        edge = begin;
                    (before, at) = (opacity, middle);
                }
                return double.IsNaN(edge) ? position : Math.Min(position, Math.Max(edge, position - 0.5 / length) + thickness / length);
            }
            for (double from = near + first * step; from < furthest - 1e-12 * furthest; from += step / 4)
            {
                double to = Math.Min(from + step / 4, furthest), after = passing * Passing(from, to);
                if (after <= wanted)
                {
                    double share = after > 0 ? Math.Log(wanted / passing) / Math.Log(after / passing) : 0;
                    double found = from + Math.Max(0, Math.Min(1, share)) * (to - from), middle = 0.5 * (from + to);
                    return HitAt(found, middle, near + step * DepthOf((found - near) / step, (middle - near) / step));
                }
                passing = after;
            }
            double reachedEnd = Math.Min(near + (reached + 1) * step, far);
            return reached < 0 ? SegmentHit.None : HitAt(reachedEnd, 0.5 * (near + reached * step + reachedEnd), reachedEnd);
        }

        static double Sample(CarvedField field, PointMm index)
        {
            double sum = 0;
            for (int corner = 0; corner < 8; corner++)
            {
                double i = Math.Floor(index.X) + (corner & 1), j = Math.Floor(index.Y) + (corner >> 1 & 1), k = Math.Floor(index.Z) + (corner >> 2);
                double weight = (1 - Math.Abs(index.X - i)) * (1 - Math.Abs(index.Y - j)) * (1 - Math.Abs(index.Z - k));
                sum += weight * field.AntiAliasedCode(Within(i, field.Bricks.SizeI), Within(j, field.Bricks.SizeJ), Within(k, field.Bricks.SizeK)) / 255;
            }
            return sum;
        }

        static int Within(double index, int size) => (int)Math.Max(0, Math.Min(size - 1, index));
    }
}
