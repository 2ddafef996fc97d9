using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Carving
{
    /// <summary>The laws of Eq. 1, each over 1,000 random scenes, for binary and smooth cuts where both have them.</summary>
    public sealed class CarvingAlgebraTests
    {
        const int Cases = 1000;
        const int SegmentCount = 35;
        const int MaxSize = 6;

        [Test]
        public void Order_OfSpheres_IsIrrelevant() => ForAll(1, (scenes, volume, spheres, cut) =>
            Assert.That(Codes(volume, scenes.Shuffled(spheres), cut), Is.EqualTo(Codes(volume, spheres, cut))));

        [Test]
        public void Adding_ASphere_NeverUnhides() => ForAll(2, (scenes, volume, spheres, cut) =>
        {
            var more = new List<ClipSphere>(spheres) { scenes.Sphere(volume.Geometry, SegmentCount) };
            bool[] before = Clipped(volume, spheres), after = Clipped(volume, more);
            byte[] opacityBefore = Codes(volume, spheres, cut), opacityAfter = Codes(volume, more, cut);
            for (int v = 0; v < before.Length; v++)
            {
                Assert.That(after[v] || !before[v]);
                Assert.That(opacityAfter[v], Is.LessThanOrEqualTo(opacityBefore[v]));
            }
        });

        [Test]
        public void EmptyMask_HasNoEffect() => ForAll(3, (scenes, volume, spheres, cut) =>
        {
            ClipSphere idle = scenes.Sphere(volume.Geometry, SegmentCount).WithMask(SegmentMask.None(SegmentCount));
            Assert.That(Codes(volume, spheres.Append(idle), cut), Is.EqualTo(Codes(volume, spheres, cut)));
            Assert.That(Clipped(volume, spheres.Append(idle)), Is.EqualTo(Clipped(volume, spheres)));
        });

        [Test]
        public void FullMask_IsPlainClipping() => ForAll(4, (scenes, volume, spheres, cut) =>
        {
            IEnumerable<ClipSphere> full = spheres.Select(sphere => sphere.WithMask(SegmentMask.All(SegmentCount)));
            var grid = new CentredGrid(volume.Geometry);
            bool[] plain = Phantoms.Map(volume.Geometry, (i, j, k) =>
            {
                grid.Position(i, j, k, out float x, out float y, out float z);
                return spheres.Any(sphere => ClipTest.Inside(grid.ToCentred(sphere), x, y, z));
            });
            Assert.That(Clipped(volume, full), Is.EqualTo(plain));
        });

        [Test]
        public void Duplicates_AreIdempotent() => ForAll(5, (scenes, volume, spheres, cut) =>
            Assert.That(Codes(volume, spheres.Concat(scenes.Shuffled(spheres)), cut), Is.EqualTo(Codes(volume, spheres, cut))));

        [Test]
        public void RadiusZero_HidesNothing() => ForAll(6, (scenes, volume, spheres, cut) =>
        {
            PointMm voxel = volume.Geometry.IjkToLps.TransformPoint(new PointMm(
                scenes.Next(volume.Geometry.SizeI), scenes.Next(volume.Geometry.SizeJ), scenes.Next(volume.Geometry.SizeK)));
            var point = new ClipSphere(voxel, 0, SegmentMask.All(SegmentCount));
            Assert.That(Codes(volume, spheres.Append(point), cut), Is.EqualTo(Codes(volume, spheres, cut)));
            Assert.That(Clipped(volume, spheres.Append(point)), Is.EqualTo(Clipped(volume, spheres)));
        });

        [Test]
        public void BinaryCut_IsZeroExactlyWhereClipped() => ForAll(7, (scenes, volume, spheres, _) =>
        {
            byte[] uncut = Codes(volume, Array.Empty<ClipSphere>(), CutMode.Binary);
            bool[] clipped = Clipped(volume, spheres);
            byte[] expected = uncut.Select((code, v) => clipped[v] ? (byte)0 : code).ToArray();
            Assert.That(Codes(volume, spheres, CutMode.Binary), Is.EqualTo(expected));
        });

        static void ForAll(int seed, Action<RandomScenes, SegmentedVolume, List<ClipSphere>, CutMode> law)
        {
            var scenes = new RandomScenes(seed);
            for (int n = 0; n < Cases; n++)
            {
                SegmentedVolume volume = scenes.Volume(MaxSize, SegmentCount);
                law(scenes, volume, scenes.Spheres(volume.Geometry, SegmentCount, 4), n % 2 == 0 ? CutMode.Binary : CutMode.Smooth);
            }
        }

        static byte[] Codes(SegmentedVolume volume, IEnumerable<ClipSphere> spheres, CutMode cut)
        {
            CarvedField field = Phantoms.Field(volume, cut, AntiAliasSettings.Off, spheres.ToArray());
            return Phantoms.Map(volume.Geometry, field.OpacityCode);
        }

        static bool[] Clipped(SegmentedVolume volume, IEnumerable<ClipSphere> spheres)
        {
            CarvedField field = Phantoms.Field(volume, CutMode.Smooth, AntiAliasSettings.Off, spheres.ToArray());
            return Phantoms.Map(volume.Geometry, field.IsClipped);
        }
    }
}
