using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// A picture's rays in LPS millimetres, as a value: P(t) = (Origin + x OriginDx + y OriginDy) + t (Direction + x DirectionDx + y DirectionDy)
    /// with x, y = pixel + 0.5, row 0 at the bottom.
    /// </summary>
    readonly struct PictureRayBundle : IEquatable<PictureRayBundle>
    {
        public PictureRayBundle(
            int width, int height, PointMm origin, VectorMm originDx, VectorMm originDy, VectorMm direction, VectorMm directionDx, VectorMm directionDy,
            double nearT, double farT, VectorMm right, VectorMm up, VectorMm backward)
        {
            Width = width;
            Height = height;
            Origin = origin;
            OriginDx = originDx;
            OriginDy = originDy;
            Direction = direction;
            DirectionDx = directionDx;
            DirectionDy = directionDy;
            NearT = nearT;
            FarT = farT;
            Right = right;
            Up = up;
            Backward = backward;
        }

        /// <summary>Rays without a camera: the viewer's axes are those of the ray in the picture's middle.</summary>
        public PictureRayBundle(PictureRays rays)
            : this(rays.Width, rays.Height, rays.Origin, rays.OriginDx, rays.OriginDy, rays.Direction, rays.DirectionDx, rays.DirectionDy,
                rays.NearT, rays.FarT, default, default, default)
        {
            VectorMm middle = Direction + 0.5 * Width * DirectionDx + 0.5 * Height * DirectionDy;
            Backward = (-middle).Normalized();
            VectorMm across = OriginDx + DirectionDx;
            Right = (across - VectorMm.Dot(across, Backward) * Backward).Normalized();
            VectorMm upward = OriginDy + DirectionDy;
            upward -= VectorMm.Dot(upward, Backward) * Backward;
            Up = (upward - VectorMm.Dot(upward, Right) * Right).Normalized();
        }

        public int Width { get; }

        public int Height { get; }

        public PointMm Origin { get; }

        public VectorMm OriginDx { get; }

        public VectorMm OriginDy { get; }

        public VectorMm Direction { get; }

        public VectorMm DirectionDx { get; }

        public VectorMm DirectionDy { get; }

        public double NearT { get; }

        public double FarT { get; }

        /// <summary>The viewer's axes, equally long in the world.</summary>
        public VectorMm Right { get; }

        public VectorMm Up { get; }

        public VectorMm Backward { get; }

        /// <summary>The unit vector of a direction that is given by the viewer's axes.</summary>
        public VectorMm TowardsLight(Vector3 direction) => (direction.x * Right + direction.y * Up + direction.z * Backward).Normalized();

        public bool Equals(PictureRayBundle other) => Width == other.Width && Height == other.Height && Origin == other.Origin
            && OriginDx == other.OriginDx && OriginDy == other.OriginDy && Direction == other.Direction
            && DirectionDx == other.DirectionDx && DirectionDy == other.DirectionDy && NearT.Equals(other.NearT) && FarT.Equals(other.FarT)
            && Right == other.Right && Up == other.Up && Backward == other.Backward;

        public override bool Equals(object obj) => obj is PictureRayBundle other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(Width, Height, Origin, Direction, DirectionDx, DirectionDy);

        public static Vector4 ToFloat(VectorMm v) => new Vector4((float)v.X, (float)v.Y, (float)v.Z, 0f);
    }
}
