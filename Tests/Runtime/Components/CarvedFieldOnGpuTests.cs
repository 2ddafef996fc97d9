using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Tests.Kernels;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using Random = System.Random;
using Range = NUnit.Framework.RangeAttribute;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>
    /// The package's two ways to the same field: <see cref="CarvedField"/> on the CPU and the renderer's textures on the GPU, voxel by voxel and ray by
    /// ray, on random small volumes: any spacing, rotation and shear, random segments, masks and semi-transparent transfer functions.
    /// </summary>
    sealed class CarvedFieldOnGpuTests : PlayModeScene
    {
        const int EditsPerScene = 4;
        const string OpacityName = "AnatomyCarve opacity";
        const string AntiAliasedName = "AnatomyCarve anti-aliased opacity";

        [Test]
        public void Textures_AfterRandomEdits_HoldWhatTheFieldSays([Range(1, 16)] int seed, [Values] CutMode cut)
        {
            var random = new Random(seed);
            CarvedVolumeRenderer renderer = MakeScene(random);
            VolumeGeometry geometry = renderer.Volume.Geometry;
            renderer.Quality = new RenderQuality { CutMode = cut, AntiAliasing = random.Next(4) == 0 ? 0 : 0.25f * (1 + random.Next(4)) };
            PictureRays rays = RandomMatter.Rays(geometry, random, 8);
            var raw = new Tally(geometry);
            var smoothed = new Tally(geometry);
            for (int n = 0; n < EditsPerScene; n++)
            {
                Edit(renderer.Stack.Carving, geometry, random);
                renderer.Render(rays);
                CarvedField field = renderer.Field;
                raw.Compare(Read(OpacityName, renderer), field.OpacityCode);
                smoothed.Compare(Read(AntiAliasedName, renderer), field.AntiAliasedCode);
            }
            string figures = $"seed {seed}: opacity {raw}; anti-aliased {smoothed}";
            TestContext.WriteLine(figures);
            Assert.That(raw.Visible, Is.GreaterThan(0), figures);
            Assert.That(raw.Worst, Is.LessThanOrEqualTo(1), figures + "; observed: 0");
            Assert.That(smoothed.Worst, Is.LessThanOrEqualTo(1), figures + "; observed: 0");
        }

        [Test]
        public void Textures_BinaryCut_AreEmptyExactlyWhereEq1Clips([Range(1, 8)] int seed)
        {
            var random = new Random(seed);
            CarvedVolumeRenderer renderer = MakeScene(random);
            VolumeGeometry geometry = renderer.Volume.Geometry;
            renderer.Quality = new RenderQuality { CutMode = CutMode.Binary };
            renderer.TransferFunction = OpacityTransferFunction.Constant(1);
            renderer.Segments = renderer.Volume.Segments;
            int clipped = 0, wrong = 0, voxels = 0;
            for (int n = 0; n < 3 * EditsPerScene; n++)
            {
                Edit(renderer.Stack.Carving, geometry, random);
                renderer.Render(RandomMatter.Rays(geometry, random, 8));
                byte[] texture = Read(OpacityName, renderer);
                CarvedField field = renderer.Field;
                ForEach(geometry, (v, i, j, k) =>
                {
                    bool isClipped = field.IsClipped(i, j, k);
                    voxels++;
                    clipped += isClipped ? 1 : 0;
                    wrong += texture[v] == (isClipped ? 0 : 255) ? 0 : 1;
                });
            }
            Assert.That(wrong, Is.EqualTo(0), $"of {voxels} voxels, {clipped} clipped, seed {seed}");
            Assert.That(clipped, Is.InRange(1, voxels - 1));
        }

        [Test]
        public void Pictures_OfSemiTransparentMatter_ShowWhatThePickerFinds([Range(1, 16)] int seed)
        {
            var random = new Random(seed);
            CarvedVolumeRenderer renderer = MakeScene(random);
            VolumeGeometry geometry = renderer.Volume.Geometry;
            renderer.Quality = new RenderQuality { CutMode = (CutMode)random.Next(2), Step = 0.3f + (float)random.NextDouble() };
            Edit(renderer.Stack.Carving, geometry, random);
            PictureRays rays = RandomMatter.Rays(geometry, random, 48);
            var tally = new RayTally(renderer.Field, renderer.RaySettings);
            tally.Compare(renderer.Render(rays).Read(), rays);
            TestContext.WriteLine($"seed {seed}: {tally}");
            Assert.That(tally.Hits, Is.GreaterThan(0));
            Assert.That(tally.Wrong, Is.EqualTo(0), tally.ToString());
            Assert.That(tally.Undecided, Is.LessThanOrEqualTo(0.01 * tally.Rays), tally + "; observed: 7");
            // Where a hair decides in which step alpha reaches the threshold, the depths of both differ by what the step's sum is off.
            Assert.That(tally.WorstDepthMm, Is.LessThanOrEqualTo(0.03), tally + "; observed: 0.016");
        }

        CarvedVolumeRenderer MakeScene(Random random)
        {
            int segments = random.Next(4) == 0 ? 300 : 2 + random.Next(30);
            CarvedVolumeRenderer renderer = MakeVolume(RandomMatter.Volume(random, segments));
            renderer.TransferFunction = new OpacityTransferFunction(new[]
            {
                new TransferPoint(0, 0), new TransferPoint(100 + 200 * random.NextDouble(), 0.3 * random.NextDouble()),
                new TransferPoint(400 + 200 * random.NextDouble(), random.NextDouble()), new TransferPoint(1000, random.NextDouble()),
            });
            SegmentTable table = renderer.Segments;
            for (int s = 0; s < segments; s++)
                table = random.Next(3) == 0 ? table.WithOpacity(s, (float)random.NextDouble()) : table;
            renderer.Segments = table;
            return renderer;
        }

        /// <summary>Places the active sphere anew with a random mask, and now and then fixes it or takes a step back.</summary>
        static void Edit(CarvingStack carving, VolumeGeometry geometry, Random random)
        {
            double Along(int size) => (size + 4) * random.NextDouble() - 2.5;
            PointMm centre = geometry.IjkToLps.TransformPoint(new PointMm(Along(geometry.SizeI), Along(geometry.SizeJ), Along(geometry.SizeK)));
            double size = Math.Max(geometry.SizeI, Math.Max(geometry.SizeJ, geometry.SizeK)) * geometry.SpacingMm.Length;
            if (random.Next(2) == 0 && carving.Active is object)
                carving.FixActive();
            carving.SetActive(centre, 0.4 * size * random.NextDouble());
            double share = random.NextDouble();
            carving.SetActiveMask(SegmentMask.FromIndices(carving.SegmentCount, Enumerable.Range(0, carving.SegmentCount).Where(_ => random.NextDouble() < share)));
            if (random.Next(6) == 0)
                carving.Undo();
        }

        static byte[] Read(string name, CarvedVolumeRenderer renderer)
        {
            RenderTexture[] found = Resources.FindObjectsOfTypeAll<RenderTexture>().Where(texture => texture.name == name && texture.IsCreated()).ToArray();
            Assert.That(found.Length, Is.EqualTo(1), name);
            return StoredVoxels.Whole(KernelRig.Read<byte>(found[0]), renderer);
        }

        static void ForEach(VolumeGeometry geometry, Action<int, int, int, int> action)
        {
            int v = 0;
            for (int k = 0; k < geometry.SizeK; k++)
                for (int j = 0; j < geometry.SizeJ; j++)
                    for (int i = 0; i < geometry.SizeI; i++)
                        action(v++, i, j, k);
        }

        /// <summary>How far a texture's codes are from the field's.</summary>
        sealed class Tally
        {
            readonly VolumeGeometry geometry;
            int voxels, different;

            public Tally(VolumeGeometry geometry) => this.geometry = geometry;

            /// <summary>Voxels above 0.</summary>
            public int Visible { get; private set; }

            public int Worst { get; private set; }

            public void Compare(byte[] texture, Func<int, int, int, byte> field) => ForEach(geometry, (v, i, j, k) =>
            {
                byte expected = field(i, j, k);
                voxels++;
                Visible += expected > 0 ? 1 : 0;
                different += texture[v] != expected ? 1 : 0;
                Worst = Math.Max(Worst, Math.Abs(texture[v] - expected));
            });

            public override string ToString() => $"{different} of {voxels} voxels ({Visible} visible) differ, by up to {Worst} codes";
        }
    }
}
