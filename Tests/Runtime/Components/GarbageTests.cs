using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>
    /// What frames leave to the garbage collector. The headless engine itself allocates in a dispatch and in an upload, but nothing that depends on the
    /// volume.
    /// </summary>
    sealed class GarbageTests : PlayModeScene
    {
        const int Frames = 50;

        [Test]
        public void Frames_InWhichNothingChanged_LeaveNone()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera camera = MakeCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            renderer.Stack.SetActive(new Vector3(0f, 0f, -0.014f), 0.004f);
            Assert.That(BytesOf(frame => renderer.Render(camera, 16, 16)), Is.Zero);
        }

        [Test]
        public void Sphere_Moved_LeavesAsMuchInALargeVolumeAsInASmallOne()
        {
            long small = BytesPerMove(Phantoms.Markers(20)), large = BytesPerMove(Phantoms.Markers(160));
            TestContext.WriteLine($"{small} and {large} bytes a move in volumes of 27 and 8,000 bricks");
            Assert.That(large - small, Is.LessThan(1024));
        }

        [Test]
        public void Snapshot_AndDirtyBricks_OfAMove_AreSmall()
        {
            SegmentedVolume volume = Phantoms.Markers(160);
            var stack = new CarvingStack(volume.Segments.Count) { HistoryLimit = 0 };
            var grid = new CentredGrid(volume.Geometry);
            var dirty = new DirtyBrickSet(new BrickGrid(volume.Geometry), grid);
            long bytes = BytesOf(frame =>
            {
                CarvingSnapshot before = stack.State;
                stack.SetActive(Place(volume, frame), 4);
                dirty.Compute(before, stack.State, CutMode.Smooth, CarvingReach.NormalsVoxels);
            });
            Assert.That(bytes / Frames, Is.LessThan(1024));
        }

        long BytesPerMove(SegmentedVolume volume)
        {
            CarvedVolumeRenderer renderer = MakeVolume(volume);
            Camera camera = MakeCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            renderer.Stack.Carving.HistoryLimit = 0;
            return BytesOf(frame =>
            {
                renderer.Stack.Carving.SetActive(Place(volume, frame), 4);
                renderer.Render(camera, 16, 16);
            }) / Frames;
        }

        static PointMm Place(SegmentedVolume volume, int frame) => volume.Geometry.CentreLps + new VectorMm(frame % 7, frame % 5, 0);

        /// <summary>Bytes that this thread allocated in all frames, after as many to grow buffers in and to compile.</summary>
        static long BytesOf(Action<int> frame)
        {
            for (int n = 0; n < Frames; n++)
                frame(n);
            long before = AllocatedBytes.OfThisThread();
            for (int n = 0; n < Frames; n++)
                frame(n);
            return GC.GetAllocatedBytesForCurrentThread() - before;
        }
    }
}
