using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>A picture's axes in LPS, which the light's direction counts in: those of the ray in its middle.</summary>
    readonly record struct ViewAxes(VectorMm Right, VectorMm Up, VectorMm Backward)
    {
        public static ViewAxes Of(PictureRays rays)
        {
            var middle = rays.Direction + 0.5 * rays.Width * rays.DirectionDx + 0.5 * rays.Height * rays.DirectionDy;
            var backward = (-middle).Normalized();
            var across = rays.OriginDx + rays.DirectionDx;
            var right = (across - across.Dot(backward) * backward).Normalized();
            var upward = rays.OriginDy + rays.DirectionDy;
            upward -= upward.Dot(backward) * backward;
            return new ViewAxes(right, (upward - upward.Dot(right) * right).Normalized(), backward);
        }

        /// <summary>A direction that is given by the view's axes, as a unit vector.</summary>
        public VectorMm Towards(Vector3 direction) => (direction.x * Right + direction.y * Up + direction.z * Backward).Normalized();
    }
}
