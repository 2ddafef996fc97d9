using System;
using System.Collections;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>What a renderer computes again after a change, and that it shows the change.</summary>
    sealed class RendererUpdateTests : PlayModeScene
    {
        [UnityTest]
        public IEnumerator Frames_InWhichNothingChanged_ComputeNothing()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.Stack.SetActive(Vector3.zero, 0.01f);
            CarvedPicture picture = renderer.Render(FrontView(renderer.Volume));
            int dispatches = renderer.Statistics.VolumeDispatches, version = picture.Version;
            for (int frame = 0; frame < 3; frame++)
            {
                yield return null;
                renderer.Render(FrontView(renderer.Volume));
            }
            Assert.That(renderer.Statistics.VolumeDispatches, Is.EqualTo(dispatches));
            Assert.That(picture.Version, Is.EqualTo(version), "the same picture is not made again");
        }

        [Test]
        public void Sphere_Moved_IsSeenInTheSameFrame()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Assert.That(Count(renderer.Render(FrontView(renderer.Volume)).Read(), Phantoms.Right), Is.GreaterThan(0));
            renderer.Stack.SetActive(new Vector3(-0.014f, 0f, 0f), 0.006f);
            Assert.That(Count(renderer.Render(FrontView(renderer.Volume)).Read(), Phantoms.Right), Is.Zero);
            renderer.Stack.Undo();
            Assert.That(Count(renderer.Render(FrontView(renderer.Volume)).Read(), Phantoms.Right), Is.GreaterThan(0));
        }

        [Test]
        public void Sphere_WithoutASegmentInItsMask_LeavesItWhole()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            PictureData whole = renderer.Render(FrontView(renderer.Volume)).Read();
            renderer.Stack.SetActive(Vector3.zero, 0.05f);
            renderer.Stack.ToggleSegment(Phantoms.Superior);
            PictureData carved = renderer.Render(FrontView(renderer.Volume)).Read();
            Assert.That(Count(carved, Phantoms.Superior), Is.EqualTo(Count(whole, Phantoms.Superior)));
            Assert.That(Count(carved, Phantoms.Body) + Count(carved, Phantoms.Anterior), Is.Zero);
        }

        [Test]
        public void Edit_OfASmallSphere_ComputesTheBricksItTouches()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers(80));
            renderer.Render(FrontView(renderer.Volume));
            long all = renderer.Statistics.AntiAlias.Bricks;
            renderer.Statistics.Reset();
            renderer.Stack.SetActive(new Vector3(-0.014f, 0f, 0f), 0.002f);
            renderer.Render(FrontView(renderer.Volume));
            Assert.That(renderer.Statistics.ClipVoxels.Bricks, Is.GreaterThan(0).And.LessThan(all / 4));
            Assert.That(renderer.Statistics.AntiAlias.Bricks, Is.GreaterThanOrEqualTo(renderer.Statistics.ClipVoxels.Bricks).And.LessThan(all / 4));
            Assert.That(renderer.Statistics.SobelNormals.Bricks, Is.GreaterThanOrEqualTo(renderer.Statistics.AntiAlias.Bricks).And.LessThan(all / 4));
        }

        [TestCase(40)]
        [TestCase(21)]
        public void Statistics_OfAFirstPicture_CountBricksWithAndAroundMatter(int size)
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers(size));
            renderer.Render(FrontView(renderer.Volume));
            RenderStatistics done = renderer.Statistics;
            VisibleContents visible = VisibleContents.Of(
                renderer.Volume, new OpacityLookup(renderer.TransferFunction, renderer.Volume.Intensity), Enumerable.Repeat(1f, renderer.Volume.Segments.Count).ToArray());
            int withMatter = Enumerable.Range(0, visible.Count).Count(brick => visible[brick].Length > 0);
            int near = Enumerable.Range(0, visible.Count).Count(visible.IsNearMatter);
            Assert.That(new[] { done.ClipVoxels.Bricks, done.AntiAlias.Bricks, done.SobelNormals.Bricks }, Is.EqualTo(new long[] { withMatter, near, near }));
            Assert.That(done.ClearBricks.Bricks, Is.EqualTo(visible.Count - withMatter), "the others are emptied");
        }

        [Test]
        public void Edit_WhereNothingIsVisible_MakesNoPictureAgain()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            PictureRays rays = FrontView(renderer.Volume);
            CarvedPicture picture = renderer.Render(rays);
            int version = picture.Version, dispatches = renderer.Statistics.VolumeDispatches;
            renderer.Stack.SetActive(new Vector3(5f, 0f, 0f), 0.002f);
            renderer.Render(rays);
            Assert.That(picture.Version, Is.EqualTo(version));
            Assert.That(renderer.Statistics.VolumeDispatches, Is.EqualTo(dispatches));
        }

        [Test]
        public void Statistics_AfterResourcesWereReleased_CountOn()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.Stack.SetActive(Vector3.zero, 0.01f);
            renderer.Render(FrontView(renderer.Volume));
            long inBricks = renderer.Statistics.SpheresInBricks;
            renderer.ReleaseResources();
            renderer.Render(FrontView(renderer.Volume));
            Assert.That(inBricks, Is.GreaterThan(0));
            Assert.That(renderer.Statistics.SpheresInBricks, Is.EqualTo(2 * inBricks));
        }

        [Test]
        public void TransferFunction_ThatHidesAll_EmptiesWhatWasVisible()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Assert.That(renderer.Render(FrontView(renderer.Volume)).Read().Color.Max(color => color.a), Is.GreaterThan(0.9f));
            renderer.TransferFunction = OpacityTransferFunction.Constant(0);
            Assert.That(renderer.Render(FrontView(renderer.Volume)).Read().Color.Max(color => color.a), Is.Zero);
        }

        [Test]
        public void Edits_OneByOne_EndInThePictureOfAFreshRenderer([Values(1, 2, 3)] int seed)
        {
            var random = new System.Random(seed);
            CarvedVolumeRenderer edited = MakeVolume(Phantoms.Markers());
            for (int edit = 0; edit < 12; edit++)
            {
                Edit(edited.Stack, random);
                edited.Render(FrontView(edited.Volume, 8));
            }
            CarvedVolumeRenderer fresh = MakeVolume(edited.Volume);
            fresh.Stack.Carving.Replace(edited.Stack.Carving.Fixed, edited.Stack.Carving.Active);
            AssertSamePicture(fresh.Render(FrontView(fresh.Volume)).Read(), edited.Render(FrontView(edited.Volume)).Read());
        }

        [Test]
        public void Settings_ChangedOneByOne_EndInThePictureOfAFreshRenderer()
        {
            CarvedVolumeRenderer changed = MakeVolume(Phantoms.Markers());
            changed.Stack.SetActive(new Vector3(0f, 0f, -0.007f), 0.006f);
            changed.Render(FrontView(changed.Volume));
            Action<CarvedVolumeRenderer>[] changes =
            {
                r => r.Quality.CutMode = CutMode.Smooth,
                r => r.Quality.AntiAliasing = 0.5f,
                r => r.Segments = r.Volume.Segments.WithOpacity(Phantoms.Body, 0.25f),
                r => r.Segments = r.Segments.WithColor(Phantoms.Left, new SegmentColor(255, 0, 0)),
                r => r.TransferFunction = OpacityTransferFunction.Parse("100:0,900:0.75"),
                r => r.Light.Direction = new Vector3(1f, 0f, 0f),
                r => r.Quality.Step = 0.75f,
            };
            CarvedVolumeRenderer fresh = MakeVolume(changed.Volume);
            fresh.Stack.Carving.Replace(changed.Stack.Carving.Fixed, changed.Stack.Carving.Active);
            PictureData before = changed.Render(FrontView(changed.Volume)).Read();
            foreach (Action<CarvedVolumeRenderer> change in changes)
            {
                change(changed);
                PictureData after = changed.Render(FrontView(changed.Volume)).Read();
                Assert.That(after.Color, Is.Not.EqualTo(before.Color), "each change is seen");
                before = after;
                change(fresh);
            }
            AssertSamePicture(fresh.Render(FrontView(fresh.Volume)).Read(), before);
        }

        [Test]
        public void Colors_Changed_ComputeNoVoxel()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.Render(FrontView(renderer.Volume));
            int dispatches = renderer.Statistics.VolumeDispatches;
            renderer.Segments = renderer.Segments.WithColor(Phantoms.Body, new SegmentColor(1, 2, 3));
            renderer.Render(FrontView(renderer.Volume));
            Assert.That(renderer.Statistics.VolumeDispatches, Is.EqualTo(dispatches));
        }

        [Test]
        public void Stack_WithThousandsOfSpheres_IsShown()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            var spheres = new ClipSphere[4096];
            SegmentMask mask = SegmentMask.FromIndices(renderer.Segments.Count, new[] { Phantoms.Body });
            for (int s = 0; s < spheres.Length; s++)
                spheres[s] = new ClipSphere(renderer.Volume.Geometry.CentreLps + new VectorMm(s % 16 - 8, s / 16 % 16 - 8, s / 256 - 8), 0.9, mask);
            renderer.Stack.Carving.Replace(spheres);
            PictureData picture = renderer.Render(FrontView(renderer.Volume)).Read();
            Assert.That(Count(picture, Phantoms.Body), Is.Zero);
            Assert.That(Count(picture, Phantoms.Anterior), Is.GreaterThan(0));
        }

        [Test]
        public void Segments_OfAnotherCount_AreRefused()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Assert.That(() => renderer.Segments = SegmentTable.UnlabelledOnly(), Throws.ArgumentException);
        }

        static void Edit(ClipSphereStack stack, System.Random random)
        {
            float Coordinate() => (float)(random.NextDouble() - 0.5) * 0.04f;
            switch (random.Next(6))
            {
                case 0 when stack.Carving.Active != null:
                    stack.FixActive();
                    break;
                case 1:
                    stack.RemoveLast();
                    break;
                case 2 when stack.Carving.Active != null:
                    stack.ToggleSegment(random.Next(stack.Carving.SegmentCount));
                    break;
                case 3:
                    stack.Undo();
                    break;
                default:
                    stack.SetActive(new Vector3(Coordinate(), Coordinate(), Coordinate()), 0.002f + (float)random.NextDouble() * 0.008f);
                    break;
            }
        }
    }
}
