using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Carving
{
    /// <summary>Blocks' contents against the voxels themselves.</summary>
    public sealed class VisibleContentsTests
    {
        const int SegmentCount = 7;

        [Test]
        public void Blocks_RandomVolumes_ListEachSegmentWithItsIntensities()
        {
            var scenes = new RandomScenes(81);
            for (int scene = 0; scene < 20; scene++)
            {
                SegmentedVolume volume = scenes.Volume(22, SegmentCount);
                var bricks = new BrickGrid(volume.Geometry);
                var voxels = Phantoms.Map(volume.Geometry, (i, j, k) => bricks.IndexOfVoxel(i, j, k))
                    .Select((brick, voxel) => (brick, segment: volume.Labels.Indices[voxel], code: volume.Intensity.Codes[voxel])).ToLookup(v => v.brick);
                Assert.That(volume.Blocks.Count, Is.EqualTo(bricks.Count));
                for (int brick = 0; brick < bricks.Count; brick++)
                {
                    var expected = voxels[brick].GroupBy(v => v.segment).Select(g => (g.Key, g.Min(v => v.code), g.Max(v => v.code))).OrderBy(e => e.Key);
                    var found = volume.Blocks[brick].ToArray().Select(e => (e.Segment, e.LowestCode, e.HighestCode)).OrderBy(e => e.Segment);
                    Assert.That(found, Is.EqualTo(expected), $"scene {scene}, brick {brick}");
                }
            }
        }

        [Test]
        public void Visible_RandomTransferFunctions_MissNoVoxelThatIsShown()
        {
            var scenes = new RandomScenes(82);
            int empty = 0, shown = 0;
            for (int scene = 0; scene < 60; scene++)
            {
                SegmentedVolume volume = scenes.Volume(26, SegmentCount);
                var function = new OpacityTransferFunction(Enumerable.Range(0, 5).Select(n => new TransferPoint(scenes.Between(0, 100), scenes.Chance(0.6) ? 0 : scenes.Between(0.0, 1.0))));
                float[] opacities = Enumerable.Range(0, SegmentCount).Select(_ => scenes.Chance(0.5) ? 0f : (float)scenes.Between(0.0, 1.0)).ToArray();
                SegmentTable table = volume.Segments;
                for (int s = 0; s < SegmentCount; s++)
                    table = table.WithOpacity(s, opacities[s]);
                VisibleContents visible = VisibleContents.Of(volume, new OpacityLookup(function, volume.Intensity), opacities);
                var field = new CarvedField(volume);
                field.Update(new ClipSphere[0], function, table, CutMode.Binary, AntiAliasSettings.Default);
                Phantoms.Map(volume.Geometry, (i, j, k) =>
                {
                    int brick = field.Bricks.IndexOfVoxel(i, j, k), segment = volume.Labels.Indices[i + volume.Geometry.SizeI * (j + volume.Geometry.SizeJ * k)];
                    bool isListed = visible[brick].ToArray().Contains((ushort)segment);
                    if (field.OpacityCode(i, j, k) > 0)
                    {
                        shown++;
                        Assert.That(isListed, $"scene {scene}, voxel {i} {j} {k}");
                    }
                    empty += isListed ? 0 : 1;
                    if (field.AntiAliasedCode(i, j, k) > 0)
                        Assert.That(visible.IsNearMatter(brick), $"anti-aliased, scene {scene}, voxel {i} {j} {k}");
                    return 0;
                });
            }
            Assert.That(shown, Is.GreaterThan(1000));
            Assert.That(empty, Is.GreaterThan(1000), "voxels whose segment is known to be invisible in their brick");
        }
    }
}
