using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Carving
{
    /// <summary>The index names every sphere that can touch a brick, few others, and costs what differs.</summary>
    public sealed class SphereIndexTests
    {
        const int SegmentCount = 5;

        static readonly ushort[] AllSegments = { 0, 1, 2, 3, 4 };

        [Test]
        public void Gather_AfterRandomUpdates_NamesWhatCanClipAVoxel([Values] CutMode cut)
        {
            var scenes = new RandomScenes(71);
            int covered = 0;
            for (int scene = 0; scene < 30; scene++)
            {
                VolumeGeometry geometry = scenes.Geometry(40);
                var grid = new CentredGrid(geometry);
                var bricks = new BrickGrid(geometry);
                var index = new SphereIndex(bricks, grid);
                for (int update = 0; update < 4; update++)
                {
                    List<ClipSphere> spheres = scenes.Spheres(geometry, SegmentCount, 12);
                    index.Update(spheres);
                    Phantoms.Map(geometry, (i, j, k) =>
                    {
                        grid.Position(i, j, k, out float x, out float y, out float z);
                        int segment = scenes.Next(SegmentCount);
                        float most = spheres.Where(sphere => sphere.CanClip && sphere.Mask[segment])
                            .Select(sphere => ClipTest.Coverage(grid, grid.ToCentred(sphere), x, y, z, cut)).DefaultIfEmpty(0).Max();
                        var found = new List<int>();
                        index.Gather(i / 8, j / 8, k / 8, cut, AllSegments, found);
                        float ofFound = found.Where(slot => index.MaskOf(slot)[segment])
                            .Select(slot => ClipTest.Coverage(grid, index.PlaceOf(slot), x, y, z, cut)).DefaultIfEmpty(0).Max();
                        Assert.That(ofFound, Is.EqualTo(most), $"scene {scene}, update {update}, voxel {i} {j} {k}");
                        covered += most > 0 ? 1 : 0;
                        return 0;
                    });
                }
            }
            Assert.That(covered, Is.GreaterThan(1000));
        }

        [Test]
        public void Gather_BrickInsideASphereThatClipsAll_NamesOnlyThat()
        {
            SphereIndex index = Index(Cube(64));
            index.Update(new[] { Sphere(20, 20, 20, 6), Sphere(32, 32, 32, 60), Sphere(20, 20, 21, 9) });
            Assert.That(Gather(index, 2, 2, 2).Select(slot => index.PlaceOf(slot).Radius), Is.EqualTo(new[] { 60f }));
        }

        [Test]
        public void Gather_MaskWithoutTheBricksSegments_IsNotNamed()
        {
            SphereIndex index = Index(Cube(64));
            index.Update(new[] { new ClipSphere(new PointMm(32, 32, 32), 20, SegmentMask.FromIndices(SegmentCount, new[] { 3 })) });
            var found = new List<int>();
            index.Gather(4, 4, 4, CutMode.Binary, new ushort[] { 0, 1 }, found);
            Assert.That(found, Is.Empty);
            index.Gather(4, 4, 4, CutMode.Binary, new ushort[] { 3 }, found);
            Assert.That(found.Count, Is.EqualTo(1));
        }

        [Test]
        public void Update_OneOfThousandsMoved_ChangesOneSlot()
        {
            SphereIndex index = Index(Cube(128));
            var spheres = new List<ClipSphere>();
            for (int n = 0; n < 4096; n++)
                spheres.Add(Sphere(8 * (n % 16), 8 * (n / 16 % 16), 8 * (n / 256), 3));
            index.Update(spheres);
            Assert.That(index.ChangedSlots.Count, Is.EqualTo(4096));
            spheres[2000] = Sphere(1, 2, 3, 4);
            index.Update(spheres);
            Assert.That(index.ChangedSlots.Count, Is.EqualTo(1));
            Assert.That(index.SlotCount, Is.EqualTo(4096), "the slot of the one that went is used again");
            Assert.That(index.Count, Is.EqualTo(4096));
        }

        [Test]
        public void Update_EqualSpheres_ShareASlotUntilTheLastGoes()
        {
            SphereIndex index = Index(Cube(32));
            index.Update(new[] { Sphere(16, 16, 16, 5), Sphere(16, 16, 16, 5), Sphere(1, 1, 1, 1) });
            Assert.That(index.Count, Is.EqualTo(2));
            index.Update(new[] { Sphere(16, 16, 16, 5), Sphere(1, 1, 1, 1) });
            Assert.That(index.Count, Is.EqualTo(2));
            Assert.That(Gather(index, 2, 2, 2).Count, Is.EqualTo(1));
            index.Update(new[] { Sphere(1, 1, 1, 1) });
            Assert.That(Gather(index, 2, 2, 2), Is.Empty);
        }

        [Test]
        public void Gather_SpheresElsewhere_CostNoTest()
        {
            SphereIndex index = Index(Cube(256));
            index.Update(Enumerable.Range(0, 1000).Select(n => Sphere(200 + n % 10, 200 + n / 10 % 10, 200 + n / 100, 2)).Append(Sphere(20, 20, 20, 6)).ToArray());
            long before = index.Tests;
            Assert.That(Gather(index, 2, 2, 2).Count, Is.EqualTo(1));
            Assert.That(index.Tests - before, Is.EqualTo(1));
        }

        [Test]
        public void Dirty_EditsThatCannotMatter_TouchNothing()
        {
            SegmentedVolume volume = Phantoms.Cube(32, SegmentCount, (i, j, k) => i < 16 ? 100 : 0, (i, j, k) => i < 8 ? 1 : 2);
            var bricks = new BrickGrid(volume.Geometry);
            var grid = new CentredGrid(volume.Geometry);
            var index = new SphereIndex(bricks, grid);
            var dirty = new DirtyBrickSet(bricks, grid)
            {
                Contents = VisibleContents.Of(volume, new OpacityLookup(Phantoms.Ramp, volume.Intensity), new float[] { 1, 1, 1, 1, 1 }),
                Index = index,
            };
            int Count(ClipSphere[] before, ClipSphere[] after)
            {
                index.Update(before);
                index.Update(after);
                dirty.Compute(before, after, CutMode.Binary, 0);
                return dirty.Count;
            }
            ClipSphere[] none = { };
            Assert.That(Count(none, new[] { Sphere(26, 16, 16, 5) }), Is.Zero, "where nothing is visible");
            Assert.That(Count(none, new[] { Sphere(4, 16, 16, 3).WithMask(SegmentMask.FromIndices(SegmentCount, new[] { 2 })) }), Is.Zero, "a mask without what is visible there");
            ClipSphere large = Sphere(16, 16, 16, 40), small = Sphere(12, 12, 12, 3);
            Assert.That(Count(new[] { large }, new[] { large, small }), Is.Zero, "hidden by one that both have");
            Assert.That(Count(new[] { small, large }, new[] { large }), Is.Zero, "the same backwards");
            Assert.That(Count(new[] { large }, new[] { Sphere(17, 16, 16, 40) }), Is.Zero, "covered wholly before and after");
            ClipSphere everywhere = Sphere(8, 16, 16, 6);
            Assert.That(Count(new[] { everywhere }, new[] { everywhere.WithMask(everywhere.Mask.Toggled(3)) }), Is.Zero, "a toggled segment that is nowhere");
            Assert.That(Count(new[] { everywhere }, new[] { everywhere.WithMask(everywhere.Mask.Toggled(1)) }), Is.EqualTo(4), "a toggled segment: bricks on its side of i = 8");
            Assert.That(Count(none, new[] { everywhere }), Is.EqualTo(8), "the whole sphere");
            Assert.That(Count(none, new[] { small }), Is.GreaterThan(0));
        }

        static VolumeGeometry Cube(int size) => new VolumeGeometry(size, size, size, Affine.Identity);

        static SphereIndex Index(VolumeGeometry geometry) => new SphereIndex(new BrickGrid(geometry), new CentredGrid(geometry));

        static ClipSphere Sphere(double x, double y, double z, double radius) => new ClipSphere(new PointMm(x, y, z), radius, SegmentMask.All(SegmentCount));

        static List<int> Gather(SphereIndex index, int x, int y, int z)
        {
            var found = new List<int>();
            index.Gather(x, y, z, CutMode.Binary, AllSegments, found);
            return found;
        }
    }
}
