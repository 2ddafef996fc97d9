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
            PictureRays rays = Rays(geometry, random, 8);
            var raw = new Tally(geometry);
            var smoothed = new Tally(geometry);
            for (int n = 0; n < EditsPerScene; n++)
            {
                Edit(renderer.Stack.Carving, geometry, random);
                renderer.Render(rays);
                CarvedField field = renderer.Field;
                raw.Compare(Read(OpacityName), field.OpacityCode);
                smoothed.Compare(Read(AntiAliasedName), field.AntiAliasedCode);
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
                renderer.Render(Rays(geometry, random, 8));
                byte[] texture = Read(OpacityName);
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
            PictureRays rays = Rays(geometry, random, 48);
            var tally = new RayTally(renderer.Field, renderer.RaySettings);
            tally.Compare(renderer.Render(rays).Read(), rays);
            TestContext.WriteLine($"seed {seed}: {tally}");
            Assert.That(tally.Hits, Is.GreaterThan(0));
            Assert.That(tally.Wrong, Is.EqualTo(0), tally.ToString());
            Assert.That(tally.Undecided, Is.LessThanOrEqualTo(0.01 * tally.Rays), tally + "; observed: 7");
            Assert.That(tally.WorstDepthMm, Is.LessThanOrEqualTo(0.01), tally + "; observed: 0.0004");
        }

        CarvedVolumeRenderer MakeScene(Random random)
        {
            int segments = random.Next(4) == 0 ? 300 : 2 + random.Next(30);
            CarvedVolumeRenderer renderer = MakeVolume(RandomVolume(random, segments));
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

        /// <summary>Soft blobs of intensities up to 1000 in a noise of up to 100, and blocky random segments.</summary>
        static SegmentedVolume RandomVolume(Random random, int segments)
        {
            KernelGrid grid = KernelGrid.Random(random, 6, 36);
            VectorMm Column(int c) => new VectorMm(grid.IndexToMm[0, c], grid.IndexToMm[1, c], grid.IndexToMm[2, c]);
            var origin = new PointMm(300 * random.NextDouble() - 150, 300 * random.NextDouble() - 150, 300 * random.NextDouble() - 150);
            var geometry = new VolumeGeometry(grid.SizeI, grid.SizeJ, grid.SizeK, Affine.FromColumns(Column(0), Column(1), Column(2), origin));
            byte[] balls = OpacityFields.Balls(grid, random);
            int block = 1 + random.Next(6), salt = random.Next();
            var codes = new ushort[grid.VoxelCount];
            var indices = new ushort[grid.VoxelCount];
            grid.ForEach((i, j, k) =>
            {
                int v = grid.Index(i, j, k);
                codes[v] = (ushort)(Math.Max(random.Next(100), balls[v] * 1000 / 255 - random.Next(100)));
                indices[v] = (ushort)(new Random(salt + i / block + 100 * (j / block) + 10000 * (k / block)).Next(segments));
            });
            var table = new SegmentTable(Enumerable.Range(0, segments).Select(s => new Segment(s, s, "segment " + s, new SegmentColor(10, 20, 30))));
            return new SegmentedVolume(new IntensityVolume(geometry, codes, 0, 1, 1000), new LabelMap(geometry, indices, table));
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

        static PictureRays Rays(VolumeGeometry geometry, Random random, int pixels)
        {
            VectorMm Direction()
            {
                double[] d = RayScene.RandomDirection(random);
                return new VectorMm(d[0], d[1], d[2]);
            }
            double radius = (geometry.IjkToLps.TransformPoint(new PointMm(-0.5, -0.5, -0.5)) - geometry.CentreLps).Length;
            PointMm eye = geometry.CentreLps + Direction() * (2.5 * radius);
            return random.Next(2) == 0
                ? PictureRays.Perspective(eye, geometry.CentreLps, Direction(), 40, pixels, pixels)
                : PictureRays.Orthographic(eye, geometry.CentreLps, Direction(), 1.6 * radius, pixels, pixels);
        }

        static byte[] Read(string name)
        {
            RenderTexture[] found = Resources.FindObjectsOfTypeAll<RenderTexture>().Where(texture => texture.name == name).ToArray();
            Assert.That(found.Length, Is.EqualTo(1), name);
            return KernelRig.Read<byte>(found[0]);
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
