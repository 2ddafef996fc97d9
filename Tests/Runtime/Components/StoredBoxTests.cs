using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using Random = System.Random;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>Opacities and normals are stored of the bricks around what can be visible, and nobody sees that there are no others.</summary>
    sealed class StoredBoxTests : PlayModeScene
    {
        const int SizeI = 75, SizeJ = 67, SizeK = 85, Ball = 1, Speck = 2, Layer = 3;

        /// <summary>One renderer once showed a speck in a corner and goes on storing the whole volume, the other never did.</summary>
        [Test]
        public void Pictures_OfWhatIsStoredInPart_AreThoseOfAVolumeThatIsStoredWhole(
            [Values] CutMode cut, [Values(TextureLayout.Compact, TextureLayout.Portable)] TextureLayout layout)
        {
            var random = new Random(5);
            SegmentedVolume volume = BallAndSpeck(26);
            CarvedVolumeRenderer whole = Renderer(volume, cut, layout), part = Renderer(volume, cut, layout);
            whole.Render(FrontView(volume, 8));
            whole.Segments = part.Segments = volume.Segments.WithOpacity(Speck, 0);
            for (int edit = 0; edit < 4; edit++)
            {
                PictureRays rays = RandomMatter.Rays(volume.Geometry, random, 40);
                AssertSamePicture(whole.Render(rays).Read(), part.Render(rays).Read());
                Assert.That(Size(whole), Is.EqualTo((75, 67, 80)), "all bricks but the last along k");
                Assert.That(Size(part), Is.EqualTo((67, 67, 72)), "but the first along i and along k too");
                PointMm centre = volume.Geometry.IjkToLps.TransformPoint(new PointMm(random.Next(SizeI), random.Next(SizeJ), random.Next(SizeK)));
                double radius = 8 + random.Next(20);
                foreach (CarvedVolumeRenderer renderer in new[] { whole, part })
                {
                    renderer.Stack.Carving.SetActive(centre, radius);
                    renderer.Stack.Carving.SetActiveMask(SegmentMask.All(4).With(Layer, edit % 2 == 1));
                    renderer.Stack.Carving.FixActive();
                }
            }
            whole.Segments = part.Segments = volume.Segments;
            AssertSamePicture(whole.Render(FrontView(volume)).Read(), part.Render(FrontView(volume)).Read());
            Assert.That(Size(part), Is.EqualTo((75, 67, 80)), "with the speck");
        }

        [Test]
        public void Bytes_OfAVolumeWithMatterInTheMiddle_AreThoseOfTheBricksAroundIt([Values(TextureLayout.Compact, TextureLayout.Portable)] TextureLayout layout)
        {
            SegmentedVolume volume = BallAndSpeck(9);
            CarvedVolumeRenderer renderer = Renderer(volume, CutMode.Binary, layout);
            renderer.Segments = volume.Segments.WithOpacity(Speck, 0);
            renderer.Render(FrontView(volume, 8));
            VoxelBox box = renderer.Statistics.StoredVoxels.Value;
            Assert.That((box.MinI, box.MinJ, box.MinK), Is.EqualTo((24, 16, 24)), "the ball begins in the bricks 4, 3 and 4");
            Assert.That((box.MaxI, box.MaxJ, box.MaxK), Is.EqualTo((63, 63, 63)), "and ends in 6, 6 and 6");
            int opacities = SizeI * SizeJ * Rounded(SizeK, layout, 4), normals = SizeI * SizeJ * Rounded(SizeK, layout, 2), stored = 40 * 48 * 40;
            Assert.That(MemoryForecast.Of(volume, "volume", layout).GpuBytes - renderer.Statistics.VolumeBytesResident, Is.EqualTo(2 * (opacities - stored) + 2 * (normals - stored)));
        }

        [Test]
        public void StoredBox_FollowsWhatIsShown()
        {
            SegmentedVolume volume = BallAndSpeck(9);
            CarvedVolumeRenderer renderer = Renderer(volume, CutMode.Binary, TextureLayout.Compact);
            Assert.That(renderer.Statistics.StoredVoxels, Is.Null);
            renderer.Segments = volume.Segments.WithOpacity(Ball, 0).WithOpacity(Layer, 0).WithOpacity(Speck, 0);
            Assert.That(Count(renderer.Render(FrontView(volume)).Read(), Ball), Is.Zero);
            Assert.That(Size(renderer), Is.EqualTo((8, 8, 8)), "nothing");
            renderer.Segments = volume.Segments.WithOpacity(Speck, 0);
            Assert.That(Count(renderer.Render(FrontView(volume)).Read(), Ball), Is.GreaterThan(50));
            Assert.That(Size(renderer), Is.EqualTo((40, 48, 40)), "the ball");
            renderer.Segments = volume.Segments;
            renderer.Render(FrontView(volume));
            Assert.That(Size(renderer), Is.EqualTo((64, 64, 64)), "ball and speck");
            renderer.Segments = volume.Segments.WithOpacity(Ball, 0).WithOpacity(Layer, 0);
            renderer.Render(FrontView(volume));
            Assert.That(Size(renderer), Is.EqualTo((16, 16, 16)), "the speck");
        }

        /// <summary>A texture filter's weights round differently in a texture of another size.</summary>
        [Test]
        public void Picture_WithTheHardwareFilter_DiffersByRoundingOnly()
        {
            SegmentedVolume volume = BallAndSpeck(26);
            CarvedVolumeRenderer whole = Renderer(volume, CutMode.Smooth, TextureLayout.Compact), part = Renderer(volume, CutMode.Smooth, TextureLayout.Compact);
            whole.Quality.Filter = part.Quality.Filter = OpacityFilter.Hardware;
            whole.Render(FrontView(volume, 8));
            whole.Segments = part.Segments = volume.Segments.WithOpacity(Speck, 0);
            PictureData expected = whole.Render(FrontView(volume)).Read(), actual = part.Render(FrontView(volume)).Read();
            Assert.That(Size(part), Is.Not.EqualTo(Size(whole)));
            float worst = 0;
            for (int p = 0; p < expected.Color.Length; p++)
                for (int channel = 0; channel < 4; channel++)
                    worst = Math.Max(worst, Math.Abs(expected.Color[p][channel] - actual.Color[p][channel]));
            Assert.That(255 * worst, Is.LessThanOrEqualTo(0.05f), "codes; observed: 0.004");
        }

        CarvedVolumeRenderer Renderer(SegmentedVolume volume, CutMode cut, TextureLayout layout)
        {
            CarvedVolumeRenderer renderer = MakeVolume(volume);
            renderer.TransferFunction = OpacityTransferFunction.Parse("100:0,900:0.7");
            renderer.Layout = layout;
            renderer.Quality = new RenderQuality { CutMode = cut };
            return renderer;
        }

        static (int I, int J, int K) Size(CarvedVolumeRenderer renderer)
        {
            VoxelBox box = renderer.Statistics.StoredVoxels.Value;
            return (box.MaxI - box.MinI + 1, box.MaxJ - box.MinJ + 1, box.MaxK - box.MinK + 1);
        }

        static int Rounded(int voxels, TextureLayout layout, int perTexel) =>
            layout == TextureLayout.Compact ? voxels : (voxels + perTexel - 1) / perTexel * perTexel;

        /// <summary>A ball of layers of random matter, and a voxel in the first corner.</summary>
        static SegmentedVolume BallAndSpeck(double radius)
        {
            var random = new Random(7);
            var geometry = new VolumeGeometry(SizeI, SizeJ, SizeK, Phantoms.Centred(new VectorMm(1, 0, 0), new VectorMm(0, 1, 0), new VectorMm(0, 0, 1), SizeI, SizeJ, SizeK));
            var codes = new ushort[geometry.VoxelCount];
            var labels = new ushort[geometry.VoxelCount];
            for (int k = 0, v = 0; k < SizeK; k++)
                for (int j = 0; j < SizeJ; j++)
                    for (int i = 0; i < SizeI; i++, v++)
                    {
                        bool isBall = new VectorMm(i - 46, j - 40, k - 44).Length <= radius;
                        bool isSpeck = v == 0;
                        labels[v] = (ushort)(isSpeck ? Speck : isBall ? (j + k) % 7 < 3 ? Layer : Ball : 0);
                        codes[v] = (ushort)(isSpeck ? 1000 : isBall ? 200 + random.Next(800) : 0);
                    }
            var segments = new SegmentTable(new[]
            {
                new Segment(0, 0, "Air", new SegmentColor(128, 128, 128)), new Segment(1, 1, "Ball", new SegmentColor(200, 80, 60)),
                new Segment(2, 2, "Speck", new SegmentColor(60, 80, 200)), new Segment(3, 3, "Layer", new SegmentColor(220, 220, 120)),
            });
            return new SegmentedVolume(new IntensityVolume(geometry, codes, 0, 1, 1000), new LabelMap(geometry, labels, segments));
        }
    }
}
