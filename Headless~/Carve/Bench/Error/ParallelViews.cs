using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>Parallel projections.</summary>
    static class ParallelViews
    {
        /// <summary>Along one axis, along none, and along a diagonal.</summary>
        public static readonly VectorMm[] Directions =
        [
            new VectorMm(0, 0, 1), new VectorMm(-0.53, 0.71, -0.46).Normalized(), new VectorMm(1, 1, 1).Normalized(), new VectorMm(0.9, -0.3, 0.2).Normalized(),
        ];

        /// <summary>A square picture of what lies around a point.</summary>
        /// <param name="direction">where the rays go, LPS</param>
        /// <param name="target">what is in the middle</param>
        /// <param name="heightMm">how much is shown</param>
        /// <param name="size">pixels along a side</param>
        /// <param name="distanceMm">from the eye's plane to the target</param>
        public static PictureRays Along(VectorMm direction, PointMm target, double heightMm, int size, double distanceMm)
        {
            // A direction that is not along the view, and odd enough that pixels do not line up with voxels.
            var up = Math.Abs(direction.Y) < 0.9 ? new VectorMm(0.11, 1, 0.05) : new VectorMm(0.05, 0.11, 1);
            return PictureRays.Orthographic(target - distanceMm * direction, target, up, heightMm, size, size);
        }
    }
}
