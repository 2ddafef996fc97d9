using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using Random = System.Random;

namespace AnatomyCarve.Tests.Stress
{
    /// <summary>Rays that end where almost no light passes show what rays that go on to the end show.</summary>
    sealed class RayEndTests : StressScene
    {
        [Test]
        public void Pictures_OfRaysThatEndEarly_DifferByACodeAtMost([Values] OpacityFilter filter)
        {
            float worst = 0;
            long early = 0, complete = 0;
            for (int seed = 1; seed <= 6; seed++)
            {
                var random = new Random(seed);
                CarvedVolumeRenderer renderer = MakeVolume(RandomMatter.Volume(random, SegmentCount, 16, 32));
                renderer.TransferFunction = OpacityTransferFunction.Parse(seed % 2 == 0 ? "100:0,900:0.7" : "100:0,400:0.4,900:1");
                renderer.Quality.Filter = filter;
                renderer.CountSamples = true;
                for (int camera = 0; camera < 4; camera++)
                {
                    PictureRays rays = RandomMatter.Rays(renderer.Volume.Geometry, random, 32);
                    renderer.Quality.OpaqueAlpha = RenderQuality.Balanced().OpaqueAlpha;
                    CarvedPicture picture = renderer.Render(rays);
                    PictureData ended = picture.Read();
                    early += picture.ReadSampleCount();
                    renderer.Quality.OpaqueAlpha = 1f;
                    picture = renderer.Render(rays);
                    PictureData whole = picture.Read();
                    complete += picture.ReadSampleCount();
                    worst = Math.Max(worst, WorstColor(ended, whole));
                    Assert.That(ended.Segments, Is.EqualTo(whole.Segments), $"seed {seed}, camera {camera}");
                    Assert.That(ended.DepthMm, Is.EqualTo(whole.DepthMm), $"seed {seed}, camera {camera}");
                }
            }
            string figures = FormattableString.Invariant($"{255 * worst:g3} codes, {early} samples instead of {complete}");
            TestContext.WriteLine(figures);
            Assert.That(worst, Is.LessThanOrEqualTo(Code), figures);
            Assert.That(early, Is.LessThan(complete), figures);
        }
    }
}
