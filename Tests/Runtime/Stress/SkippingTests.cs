using System;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Tests.Kernels;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using Random = System.Random;

namespace AnatomyCarve.Tests.Stress
{
    /// <summary>Rays that skip what is empty see, bit by bit, what rays that take every sample see, from wherever one looks, and take fewer samples.</summary>
    sealed class SkippingTests : StressScene
    {
        /// <summary>Cameras of one test; five scenes, two filters and two layouts make 200 of them.</summary>
        const int Cameras = 10;

        const int Pixels = 16;

        [Test]
        public void Picture_OfRaysThatSkip_IsBitByBitThatOfRaysThatDoNot(
            [Range(1, 5)] int scene, [Values] OpacityFilter filter, [Values(TextureLayout.Compact, TextureLayout.Portable)] TextureLayout layout)
        {
            var random = new Random(100 * scene + 10 * (int)filter + (int)layout);
            CarvedVolumeRenderer renderer = MakeRamp(scene < 3 ? Ball(Grid(30, 27, 24, 1, 1, scene)) : RandomMatter.Volume(random, SegmentCount, 14, 30));
            renderer.Layout = layout;
            renderer.CountSamples = true;
            renderer.Quality = new RenderQuality { Filter = filter, CutMode = (CutMode)(scene % 2), Step = 0.3f + 0.2f * scene };
            if (scene == 5)
                renderer.TransferFunction = OpacityTransferFunction.Parse("600:0,601:1"); // islands in empty space
            VolumeGeometry geometry = renderer.Volume.Geometry;
            long skipping = 0, complete = 0;
            int seen = 0;
            for (int camera = 0; camera < Cameras; camera++)
            {
                if (camera % 3 == 0)
                    Edit(renderer.Stack.Carving, geometry, random);
                PictureRays rays = Rays(geometry, camera, random);
                renderer.Quality.SkipEmptySpace = true;
                CarvedPicture picture = renderer.Render(rays);
                PictureData withSkipping = picture.Read();
                skipping += picture.ReadSampleCount();
                renderer.Quality.SkipEmptySpace = false;
                picture = renderer.Render(rays);
                PictureData without = picture.Read();
                complete += picture.ReadSampleCount();
                string what = $"scene {scene}, camera {camera}";
                AssertIdentical(without, withSkipping, what);
                AssertSane(withSkipping, SegmentCount, what);
                seen += CountSeen(withSkipping);
            }
            TestContext.WriteLine($"samples: {skipping} with skipping, {complete} without; {seen} pixels show a segment");
            Assert.That(seen, Is.GreaterThan(0));
            Assert.That(skipping, Is.LessThan(complete));
        }

        /// <summary>The only step is a fraction of one: its middle lies in matter, and where a whole step would have its middle there is nothing.</summary>
        [Test]
        public void Ray_ThatEndsWithinAStep_SeesTheSameWithSkipping()
        {
            VolumeGeometry geometry = Grid(12, 12, 12, 1, 1, 1);
            ushort[] codes = Enumerable.Range(0, 12 * 12 * 12).Select(v => (ushort)(v / 144 == 3 ? 1000 : 0)).ToArray(); // the slice k = 3
            CarvedVolumeRenderer renderer = MakeRamp(Volume(geometry, codes, new ushort[codes.Length], 1));
            renderer.Quality = new RenderQuality { Step = 4f, AntiAliasing = 0f };
            PointMm eye = geometry.IjkToLps.TransformPoint(new PointMm(5.5, 5.5, 3));
            PictureRays rays = PictureRays.Orthographic(eye, eye + Superior, new VectorMm(0, 1, 0), 4, 4, 4).WithRange(0, 0.6);
            PictureData skipping = renderer.Render(rays).Read();
            renderer.Quality.SkipEmptySpace = false;
            PictureData complete = renderer.Render(rays).Read();
            Assert.That(complete.Color[0].a, Is.GreaterThan(0.1f));
            AssertIdentical(complete, skipping, "one step of 0.15");
        }

        static void Edit(CarvingStack carving, VolumeGeometry geometry, Random random)
        {
            if (carving.Active is object)
                carving.FixActive();
            carving.SetActive(geometry.CentreLps + 0.5 * Radius(geometry) * Direction(random), (0.1 + 0.3 * random.NextDouble()) * Radius(geometry));
            carving.SetActiveMask(SegmentMask.FromIndices(SegmentCount, Enumerable.Range(0, SegmentCount).Where(_ => random.Next(4) > 0)));
        }

        static PictureRays Rays(VolumeGeometry geometry, int camera, Random random)
        {
            PointMm centre = geometry.CentreLps;
            double radius = Radius(geometry);
            switch (camera)
            {
                case 0: // from within
                case 1:
                    PointMm inside = centre + 0.3 * radius * Direction(random);
                    return PictureRays.Perspective(inside, inside + Direction(random), Direction(random), 80, Pixels, Pixels);
                case 2: // along each of the grid's axes, parallel
                case 3:
                case 4:
                    VectorMm axis = geometry.IjkToLps.Column(camera - 2).Normalized(), other = geometry.IjkToLps.Column((camera - 1) % 3);
                    return PictureRays.Orthographic(centre - 2 * radius * axis, centre, other, 2 * radius, Pixels, Pixels);
                case 5: // along an edge of the box: every ray of the middle column lies in a face
                case 6:
                    VectorMm along = geometry.IjkToLps.Column(camera - 5).Normalized();
                    PointMm corner = centre + geometry.CornerOffset(random.Next(VolumeGeometry.Corners));
                    return PictureRays.Orthographic(corner - 3 * radius * along, corner, geometry.IjkToLps.Column(2), 0.5 * radius, Pixels + 1, Pixels + 1);
                case 7: // grazing, in perspective
                    PointMm edge = centre + geometry.CornerOffset(random.Next(VolumeGeometry.Corners));
                    return PictureRays.Perspective(edge - 2 * radius * geometry.IjkToLps.Column(2).Normalized(), edge, Direction(random), 20, Pixels, Pixels);
                case 8: // from afar
                    return PictureRays.Perspective(centre + 500 * radius * Direction(random), centre, Direction(random), 0.2, Pixels, Pixels);
                default:
                    return RandomMatter.Rays(geometry, random, Pixels);
            }
        }

        static VectorMm Direction(Random random)
        {
            double[] d = RayScene.RandomDirection(random);
            return new VectorMm(d[0], d[1], d[2]);
        }
    }
}
