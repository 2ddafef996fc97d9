using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Carving
{
    public sealed class CarvedFieldTests
    {
        const int SegmentCount = 12;

        [Test]
        public void Update_RandomEdits_GivesWhatAFreshFieldGives()
        {
            var scenes = new RandomScenes(61);
            for (int scene = 0; scene < 25; scene++)
            {
                SegmentedVolume volume = scenes.Volume(20, SegmentCount);
                var kept = new CarvedField(volume);
                var stack = new CarvingStack(SegmentCount);
                SegmentTable segments = volume.Segments;
                OpacityTransferFunction transferFunction = Phantoms.Ramp;
                CutMode cut = CutMode.Smooth;
                AntiAliasSettings antiAlias = AntiAliasSettings.Default;
                for (int n = 0; n < 12; n++)
                {
                    ClipSphere place = scenes.Sphere(volume.Geometry, SegmentCount);
                    stack.SetActive(place.CentreLps, place.RadiusMm);
                    stack.SetActiveMask(place.Mask);
                    if (scenes.Chance(0.4))
                        stack.FixActive();
                    if (scenes.Chance(0.2))
                        stack.Undo();
                    if (scenes.Chance(0.1))
                        segments = segments.WithOpacity(scenes.Next(SegmentCount), (float)scenes.Between(0.0, 1.0));
                    if (scenes.Chance(0.1))
                        transferFunction = new OpacityTransferFunction(new[] { new TransferPoint(10, scenes.Between(0.0, 1.0)), new TransferPoint(60, 1) });
                    if (scenes.Chance(0.1))
                        cut = cut == CutMode.Smooth ? CutMode.Binary : CutMode.Smooth;
                    if (scenes.Chance(0.1))
                        antiAlias = new AntiAliasSettings(strength: (float)scenes.Between(0.0, 1.0));
                    kept.Update(stack.Spheres, transferFunction, segments, cut, antiAlias);
                    var fresh = new CarvedField(volume);
                    fresh.Update(stack.Spheres.ToArray(), transferFunction, segments, cut, antiAlias);
                    Assert.That(Phantoms.Map(volume.Geometry, kept.AntiAliasedCode), Is.EqualTo(Phantoms.Map(volume.Geometry, fresh.AntiAliasedCode)));
                    Assert.That(Phantoms.Map(volume.Geometry, kept.OpacityCode), Is.EqualTo(Phantoms.Map(volume.Geometry, fresh.OpacityCode)));
                }
            }
        }

        [Test]
        public void OpacityCode_RandomVolumes_IsTransferFunctionTimesSegmentOpacityWithinOneCode()
        {
            var scenes = new RandomScenes(62);
            for (int scene = 0; scene < 100; scene++)
            {
                SegmentedVolume volume = scenes.Volume(8, SegmentCount);
                SegmentTable segments = volume.Segments.WithOpacity(3, 0.25f).WithOpacity(4, 0f);
                OpacityTransferFunction transferFunction = OpacityTransferFunction.Parse("10:0.1,30:0.9,30.5:0.2,80:1");
                var field = new CarvedField(volume);
                field.Update(Array.Empty<ClipSphere>(), transferFunction, segments, CutMode.Smooth, AntiAliasSettings.Off);
                double[] expected = volume.Intensity.Codes.Select((code, voxel) =>
                    255 * transferFunction.OpacityAt(volume.Intensity.ValueOf(code)) * segments[volume.Labels.Indices[voxel]].Opacity).ToArray();
                byte[] actual = Phantoms.Map(volume.Geometry, field.OpacityCode);
                for (int v = 0; v < actual.Length; v++)
                    Assert.That((double)actual[v], Is.EqualTo(expected[v]).Within(1.0));
            }
        }

        [Test]
        public void OpacityCode_ConstantTransferFunction_IsTheConstant()
        {
            SegmentedVolume volume = Phantoms.Cube(3, 2, (i, j, k) => 10 * i, (i, j, k) => 0);
            var field = new CarvedField(volume);
            field.Update(Array.Empty<ClipSphere>(), OpacityTransferFunction.Constant(0.6), volume.Segments, CutMode.Binary, AntiAliasSettings.Default);
            Assert.That(Phantoms.Map(volume.Geometry, field.AntiAliasedCode), Is.All.EqualTo((byte)153));
        }

        [Test]
        public void OpacityCode_HalfACode_RoundsToEven()
        {
            SegmentedVolume volume = Phantoms.Cube(1, 1, (i, j, k) => 0, (i, j, k) => 0);
            var field = new CarvedField(volume);
            field.Update(Array.Empty<ClipSphere>(), OpacityTransferFunction.Constant(0.5), volume.Segments, CutMode.Binary, AntiAliasSettings.Off);
            Assert.That(field.OpacityCode(0, 0, 0), Is.EqualTo(128));
        }

        [Test]
        public void SampleAntiAliased_BetweenCentres_IsTrilinearAndContinuesBeyondTheBorder()
        {
            SegmentedVolume volume = Phantoms.Cube(2, 1, (i, j, k) => 20 * i + 40 * j + (k == 1 ? 40 : 0), (i, j, k) => 0);
            CarvedField field = Phantoms.Field(volume, CutMode.Binary, AntiAliasSettings.Off);
            Assert.That(field.SampleAntiAliased(0.25, 0.5, 0.75), Is.EqualTo(0.05 + 0.2 + 0.3).Within(0.5 / 255));
            Assert.That(field.SampleAntiAliased(-0.5, 0, 0), Is.EqualTo(0));
            Assert.That(field.SampleAntiAliased(1.5, 7, 1e9), Is.EqualTo(1));
            Assert.That(field.SampleAntiAliased(double.NaN, 0, 0), Is.EqualTo(0));
        }

        [Test]
        public void SegmentAt_MostOpaqueOfEight_Wins()
        {
            SegmentedVolume volume = Phantoms.Cube(4, 3, (i, j, k) => i == 2 ? 90 : i == 1 ? 80 : 0, (i, j, k) => i == 2 ? 2 : 1);
            CarvedField field = Phantoms.Field(volume, CutMode.Binary, AntiAliasSettings.Off);
            Assert.That(field.SegmentAt(1.01, 1.5, 1.5), Is.EqualTo(2));
            Assert.That(field.SegmentAt(0.99, 1.5, 1.5), Is.EqualTo(1));
        }

        [Test]
        public void SegmentAt_Ties_TheLowestIndexWins()
        {
            SegmentedVolume volume = Phantoms.Cube(2, 8, (i, j, k) => i + j + k == 0 ? 0 : 50, (i, j, k) => i + 2 * j + 4 * k);
            CarvedField field = Phantoms.Field(volume, CutMode.Binary, AntiAliasSettings.Off);
            Assert.That(field.SegmentAt(0.9, 0.9, 0.9), Is.EqualTo(1));
        }

        [Test]
        public void SegmentAt_EightEmpty_LooksAtFourCubedAndThenNowhere()
        {
            SegmentedVolume volume = Phantoms.Cube(9, 2, (i, j, k) => i == 4 && j == 4 && k == 4 ? 100 : 0, (i, j, k) => i == 4 ? 1 : 0);
            CarvedField field = Phantoms.Field(volume, CutMode.Binary, AntiAliasSettings.Off);
            Assert.That(field.SegmentAt(2.5, 4, 4), Is.EqualTo(1));
            Assert.That(field.SegmentAt(5.9, 4, 4), Is.EqualTo(1));
            Assert.That(field.SegmentAt(1.9, 4, 4), Is.EqualTo(-1));
            Assert.That(field.SegmentAt(6.1, 4, 4), Is.EqualTo(-1));
        }

        [Test]
        public void Codes_OneVoxelAsked_ComputeItOnceAndOnlyWhatItNeeds()
        {
            SegmentedVolume volume = Phantoms.Cube(40, 1, (i, j, k) => 50, (i, j, k) => 0);
            CarvedField field = Phantoms.Field(volume, CutMode.Binary, AntiAliasSettings.Default);
            field.OpacityCode(20, 20, 20);
            field.OpacityCode(20, 20, 20);
            Assert.That(field.OpacityVoxelsComputed, Is.EqualTo(1));
            field.AntiAliasedCode(20, 20, 20);
            field.AntiAliasedCode(20, 20, 20);
            Assert.That(field.AntiAliasedVoxelsComputed, Is.EqualTo(1));
            Assert.That(field.OpacityVoxelsComputed, Is.EqualTo(27));
        }

        [Test]
        public void Update_SphereElsewhere_KeepsTheVoxel()
        {
            SegmentedVolume volume = Phantoms.Cube(40, 1, (i, j, k) => 50, (i, j, k) => 0);
            CarvedField field = Phantoms.Field(volume, CutMode.Smooth, AntiAliasSettings.Default);
            field.OpacityCode(2, 2, 2);
            field.Update(
                new[] { new ClipSphere(new PointMm(30, 30, 30), 5, SegmentMask.All(1)) }, Phantoms.Ramp, volume.Segments, CutMode.Smooth, AntiAliasSettings.Default);
            field.OpacityCode(2, 2, 2);
            Assert.That(field.OpacityVoxelsComputed, Is.EqualTo(1));
            Assert.That(field.OpacityCode(30, 30, 30), Is.EqualTo(0));
        }

        [Test]
        public void Update_ListThatChangesLater_IsCopied()
        {
            SegmentedVolume volume = Phantoms.Cube(8, 1, (i, j, k) => 50, (i, j, k) => 0);
            var spheres = new List<ClipSphere>();
            var field = new CarvedField(volume);
            field.Update(spheres, Phantoms.Ramp, volume.Segments, CutMode.Binary, AntiAliasSettings.Off);
            spheres.Add(new ClipSphere(new PointMm(4, 4, 4), 2, SegmentMask.All(1)));
            Assert.That(field.OpacityCode(4, 4, 4), Is.GreaterThan(0));
            field.Update(spheres, Phantoms.Ramp, volume.Segments, CutMode.Binary, AntiAliasSettings.Off);
            Assert.That(field.OpacityCode(4, 4, 4), Is.EqualTo(0));
        }

        [Test]
        public void Update_SameAgain_KeepsEveryVoxel()
        {
            SegmentedVolume volume = Phantoms.Cube(8, 1, (i, j, k) => 50, (i, j, k) => 0);
            var stack = new CarvingStack(1);
            stack.SetActive(new PointMm(4, 4, 4), 2);
            var field = new CarvedField(volume);
            for (int n = 0; n < 3; n++)
            {
                field.Update(stack.Spheres, Phantoms.Ramp, volume.Segments, CutMode.Binary, AntiAliasSettings.Default);
                field.AntiAliasedCode(0, 0, 0);
            }
            field.Update(stack.Spheres, OpacityTransferFunction.Parse("0:0,100:1"), volume.Segments.WithColor(0, new SegmentColor(1, 2, 3)), CutMode.Binary, new AntiAliasSettings());
            field.AntiAliasedCode(0, 0, 0);
            Assert.That(field.OpacityVoxelsComputed, Is.EqualTo(8));
            Assert.That(field.AntiAliasedVoxelsComputed, Is.EqualTo(1));
        }

        [Test]
        public void Codes_WithACacheLimit_AreTheSameInLittleMemory()
        {
            const long Limit = 20000;
            const long LargestCache = 2000; // of a brick that all of ten spheres reach
            var scenes = new RandomScenes(63);
            for (int scene = 0; scene < 10; scene++)
            {
                SegmentedVolume volume = scenes.Volume(40, SegmentCount);
                List<ClipSphere> spheres = scenes.Spheres(volume.Geometry, SegmentCount, 10);
                CarvedField free = Phantoms.Field(volume, CutMode.Smooth, AntiAliasSettings.Default, spheres.ToArray());
                var limited = new CarvedField(volume, Limit);
                limited.Update(spheres, Phantoms.Ramp, volume.Segments, CutMode.Smooth, AntiAliasSettings.Default);
                for (int n = 0; n < 2000; n++)
                {
                    int i = scenes.Next(volume.Geometry.SizeI), j = scenes.Next(volume.Geometry.SizeJ), k = scenes.Next(volume.Geometry.SizeK);
                    Assert.That(limited.AntiAliasedCode(i, j, k), Is.EqualTo(free.AntiAliasedCode(i, j, k)));
                    Assert.That(limited.CachedBytes, Is.LessThanOrEqualTo(Limit + LargestCache));
                }
            }
        }

        [Test]
        public void Update_WrongNumberOfSegments_Throws()
        {
            SegmentedVolume volume = Phantoms.Cube(2, 3, (i, j, k) => 50, (i, j, k) => 0);
            var field = new CarvedField(volume);
            Assert.That(() => field.OpacityCode(0, 0, 0), Throws.InstanceOf<InvalidOperationException>());
            Assert.That(
                () => field.Update(new[] { new ClipSphere(default, 1, SegmentMask.All(2)) }, Phantoms.Ramp, volume.Segments, CutMode.Binary, AntiAliasSettings.Off),
                Throws.InstanceOf<ArgumentException>());
            Assert.That(
                () => field.Update(Array.Empty<ClipSphere>(), Phantoms.Ramp, Phantoms.Segments(2), CutMode.Binary, AntiAliasSettings.Off),
                Throws.InstanceOf<ArgumentException>());
        }
    }
}
