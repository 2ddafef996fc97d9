using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Carving
{
    /// <summary>Dirty bricks never miss a voxel that an edit changes, and are few where few change.</summary>
    public sealed class DirtyBrickSetTests
    {
        const int SegmentCount = 9;

        [Test]
        public void Compute_RandomCarvings_HoldsEveryVoxelThatChanges()
        {
            var scenes = new RandomScenes(51);
            int changed = 0, clean = 0, cleanBricks = 0;
            for (int scene = 0; scene < 150; scene++)
            {
                SegmentedVolume volume = scenes.Volume(26, SegmentCount);
                CutMode cut = scenes.Chance(0.5) ? CutMode.Binary : CutMode.Smooth;
                List<ClipSphere> before = scenes.Spheres(volume.Geometry, SegmentCount, 4);
                List<ClipSphere> after = Edited(scenes, volume.Geometry, before);
                CarvedField old = Phantoms.Field(volume, cut, AntiAliasSettings.Default, before.ToArray());
                CarvedField now = Phantoms.Field(volume, cut, AntiAliasSettings.Default, after.ToArray());
                DirtyBrickSet opacity = Between(before, after, volume.Geometry, cut, 0);
                DirtyBrickSet antiAliased = Between(before, after, volume.Geometry, cut, CarvingReach.AntiAliasVoxels);
                DirtyBrickSet normals = Set(volume.Geometry);
                normals.ComputeNormals(before, after, cut);
                Func<int, int, int, bool> holdsOpacity = VoxelsOf(opacity), holdsAntiAliased = VoxelsOf(antiAliased), holdsNormal = VoxelsOf(normals);
                Phantoms.Map(volume.Geometry, (i, j, k) =>
                {
                    if (now.OpacityCode(i, j, k) != old.OpacityCode(i, j, k))
                    {
                        changed++;
                        Assert.That(holdsOpacity(i, j, k), $"scene {scene}, voxel {i} {j} {k}");
                    }
                    if (now.AntiAliasedCode(i, j, k) != old.AntiAliasedCode(i, j, k))
                    {
                        Assert.That(holdsAntiAliased(i, j, k), $"anti-aliased, scene {scene}, voxel {i} {j} {k}");
                        for (int near = 0; near < 27; near++) // the corners, edges and faces of what SobelNormals reads
                        {
                            int ni = i + Offset(near % 3), nj = j + Offset(near / 3 % 3), nk = k + Offset(near / 9);
                            Assert.That(!IsIn(volume.Geometry, ni, nj, nk) || holdsNormal(ni, nj, nk), $"normal, scene {scene}, voxel {ni} {nj} {nk}");
                        }
                    }
                    clean += holdsOpacity(i, j, k) ? 0 : 1;
                    return 0;
                });
                cleanBricks += now.Bricks.Count - opacity.Count;
            }
            Assert.That(changed, Is.GreaterThan(10000));
            Assert.That(cleanBricks, Is.GreaterThan(150));
            TestContext.WriteLine($"{changed} voxels changed, {clean} were known not to");
            Assert.That(clean, Is.GreaterThan(90000)); // 100,487
            int Offset(int step) => (step - 1) * CarvingReach.SobelVoxels;
            bool IsIn(VolumeGeometry geometry, int i, int j, int k) =>
                i >= 0 && j >= 0 && k >= 0 && i < geometry.SizeI && j < geometry.SizeJ && k < geometry.SizeK;
        }

        [Test]
        public void Compute_SameSpheresInAnotherOrder_IsNone()
        {
            var scenes = new RandomScenes(52);
            VolumeGeometry geometry = scenes.Geometry(40);
            List<ClipSphere> spheres = scenes.Spheres(geometry, SegmentCount, 20);
            Assert.That(Between(spheres, scenes.Shuffled(spheres.Concat(spheres)), geometry, CutMode.Smooth, 2).IsNone);
        }

        [TestCase(0, 4.0, 4)]
        [TestCase(0, 2.0, 1)]
        [TestCase(CarvingReach.AntiAliasVoxels, 2.0, 1)]
        [TestCase(CarvingReach.NormalsVoxels, 2.0, 27)]
        [TestCase(0, 5.0, 7)]
        public void Compute_SmallMove_IsTheBricksThatHoldADifferenceOrAreNearOne(int halo, double radius, int expected)
        {
            var geometry = new VolumeGeometry(64, 64, 64, Affine.Identity);
            var stack = new CarvingStack(1);
            stack.SetActive(new PointMm(11, 11, 11), radius);
            CarvingChange last = default;
            stack.Changed += change => last = change;

            stack.SetActive(new PointMm(11.25, 11, 11), radius);

            Assert.That(Between(last.BeforeState, last.AfterState, geometry, CutMode.Binary, halo).Count, Is.EqualTo(expected));
        }

        [Test]
        public void Compute_SphereThatClipsNothing_IsNone()
        {
            var geometry = new VolumeGeometry(64, 64, 64, Affine.Identity);
            SegmentMask all = SegmentMask.All(1);
            var none = Array.Empty<ClipSphere>();
            foreach (ClipSphere idle in new[]
            {
                new ClipSphere(new PointMm(30, 30, 30), 0, all),
                new ClipSphere(new PointMm(30, 30, 30), 9, SegmentMask.None(1)),
                new ClipSphere(new PointMm(-30, 30, 30), 25, all),
                new ClipSphere(new PointMm(30, 30, 1e9), 25, all),
            })
            {
                Assert.That(Between(none, new[] { idle }, geometry, CutMode.Smooth, 2).IsNone, idle.ToString());
            }
        }

        [TestCase(1e6, 0.0)]
        [TestCase(ClipSphere.LargestMm, 0.0)]
        [TestCase(ClipSphere.LargestMm, ClipSphere.LargestMm)]
        public void Compute_SphereBeyondAllMeasure_IsAll(double radius, double place)
        {
            var geometry = new VolumeGeometry(20, 30, 40, Affine.Identity);
            ClipSphere[] huge = { new ClipSphere(new PointMm(place, 0, 0), radius, SegmentMask.All(1)) };
            Assert.That(Between(Array.Empty<ClipSphere>(), huge, geometry, CutMode.Binary, 0).IsAll);
        }

        [Test]
        public void Compute_OnAUsedSet_GivesWhatAFreshSetGives()
        {
            var scenes = new RandomScenes(53);
            VolumeGeometry geometry = scenes.Geometry(60);
            DirtyBrickSet used = Set(geometry);
            List<ClipSphere> before = scenes.Spheres(geometry, SegmentCount, 4);
            for (int n = 0; n < 100; n++)
            {
                List<ClipSphere> after = Edited(scenes, geometry, before);
                used.Compute(before, after, CutMode.Smooth, n % 3);
                DirtyBrickSet fresh = Between(before, after, geometry, CutMode.Smooth, n % 3);
                Assert.That(used.Indices, Is.EqualTo(fresh.Indices));
                Assert.That(Enumerable.Range(0, used.Bricks.Count).Where(brick => used[brick]), Is.EqualTo(fresh.Indices), "ascending, and no other");
                before = after;
            }
        }

        [Test]
        public void Compute_MovedSphereInALargeVolume_AllocatesNothingOfTheVolumesSize()
        {
            DirtyBrickSet dirty = Set(new VolumeGeometry(800, 800, 800, Affine.Identity));
            var stack = new CarvingStack(1);
            stack.SetActive(new PointMm(400, 400, 400), 20);
            CarvingSnapshot before = stack.State;
            stack.SetActive(new PointMm(401, 400, 400), 20);
            for (int n = 0; n < 3; n++)
                dirty.Compute(before, stack.State, CutMode.Smooth, 2);
            long allocated = GC.GetAllocatedBytesForCurrentThread();
            dirty.Compute(before, stack.State, CutMode.Smooth, 2);
            allocated = GC.GetAllocatedBytesForCurrentThread() - allocated;
            Assert.That(dirty.Count, Is.EqualTo(177), "of 252 in the box of both places");
            Assert.That(allocated, Is.LessThan(1000), "bytes; the volume has a million bricks");
        }

        [Test]
        public void Indices_TwoPlaces_AreAscending()
        {
            var geometry = new VolumeGeometry(24, 24, 24, Affine.Identity);
            ClipSphere At(double place) => new ClipSphere(new PointMm(place, place, place), 1, SegmentMask.All(1));
            DirtyBrickSet dirty = Between(new[] { At(20) }, new[] { At(4) }, geometry, CutMode.Binary, 0);
            Assert.That(dirty.Indices, Is.EqualTo(new[] { dirty.Bricks.IndexOf(0, 0, 0), dirty.Bricks.IndexOf(2, 2, 2) }));
            Assert.That(dirty.Parts.Count, Is.EqualTo(2));
        }

        [Test]
        public void BrickGrid_OddSizes_CountsPartialBricksAndPacksBothWays()
        {
            var bricks = new BrickGrid(17, 8, 1);
            Assert.That(new[] { bricks.BricksX, bricks.BricksY, bricks.BricksZ, bricks.Count }, Is.EqualTo(new[] { 3, 1, 1, 3 }));
            Assert.That(bricks.PackAll(), Is.EqualTo(new uint[] { 0, 1, 2 }));
            BrickGrid.Unpack(BrickGrid.Pack(1023, 512, 7), out int x, out int y, out int z);
            Assert.That(new[] { x, y, z }, Is.EqualTo(new[] { 1023, 512, 7 }));
            Assert.That(() => new BrickGrid(8193, 1, 1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }

        static DirtyBrickSet Set(VolumeGeometry geometry) => new DirtyBrickSet(new BrickGrid(geometry), new CentredGrid(geometry));

        static DirtyBrickSet Between(
            IReadOnlyList<ClipSphere> before, IReadOnlyList<ClipSphere> after, VolumeGeometry geometry, CutMode cut, int haloVoxels)
        {
            DirtyBrickSet dirty = Set(geometry);
            dirty.Compute(before, after, cut, haloVoxels);
            return dirty;
        }

        /// <summary>Whether a set holds a voxel.</summary>
        static Func<int, int, int, bool> VoxelsOf(DirtyBrickSet dirty)
        {
            Dictionary<int, BrickPart> parts = dirty.Indices.Zip(dirty.Parts, (brick, part) => (brick, part)).ToDictionary(pair => pair.brick, pair => pair.part);
            return (i, j, k) => parts.TryGetValue(dirty.Bricks.IndexOfVoxel(i, j, k), out BrickPart part) && part.Holds(i % 8, j % 8, k % 8);
        }

        static List<ClipSphere> Edited(RandomScenes scenes, VolumeGeometry geometry, List<ClipSphere> spheres)
        {
            var edited = new List<ClipSphere>(spheres);
            if (edited.Count > 0 && scenes.Chance(0.7))
            {
                int index = scenes.Next(edited.Count);
                ClipSphere sphere = edited[index];
                if (scenes.Chance(0.3))
                    edited.RemoveAt(index);
                else if (scenes.Chance(0.3))
                    edited[index] = sphere.WithMask(sphere.Mask.Toggled(scenes.Next(SegmentCount)));
                else
                    edited[index] = sphere.WithCenter(sphere.CentreLps + scenes.Between(0.1, 5) * scenes.Direction());
            }
            else
            {
                edited.Add(scenes.Sphere(geometry, SegmentCount));
            }
            return edited;
        }
    }
}
