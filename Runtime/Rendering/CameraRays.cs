using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// The rays of a camera's picture in a volume's patient space. They come from the camera's projection and camera-to-world matrices, so
    /// orthographic, off-centre and per-eye cameras are right, and so is a volume that is rotated or scaled, evenly or not.
    /// An oblique near plane counts at the depth at which the picture's middle meets it.
    /// t counts the depth along the camera's view in world units, from the camera (from its near plane where that lies behind the camera).
    /// </summary>
    public static class CameraRays
    {
        /// <summary>The rays of a camera's picture.</summary>
        /// <param name="camera">The camera.</param>
        /// <param name="volume">The transform of the volume's GameObject.</param>
        /// <param name="geometry">The volume's geometry.</param>
        /// <param name="width">Width in pixels, 1 at least.</param>
        /// <param name="height">Height in pixels, 1 at least.</param>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        /// <exception cref="ArgumentOutOfRangeException">A size is below 1.</exception>
        /// <exception cref="ArgumentException">The volume's scale is 0, or the camera's projection cannot be inverted.</exception>
        public static PictureRays Of(Camera camera, Transform volume, VolumeGeometry geometry, int width, int height)
        {
            if (camera == null)
                throw new ArgumentNullException(nameof(camera));
            if (volume == null)
                throw new ArgumentNullException(nameof(volume));
            return ToPictureRays(Bundle(camera.projectionMatrix, camera.cameraToWorldMatrix, volume.localToWorldMatrix, geometry, width, height));
        }

        internal static PictureRayBundle Bundle(Camera camera, in VolumeInputs inputs, int width, int height) =>
            Bundle(camera.projectionMatrix, camera.cameraToWorldMatrix, inputs.ToWorld, inputs.Volume.Geometry, width, height);

        internal static PictureRayBundle Bundle(
            Matrix4x4 projection, Matrix4x4 cameraToWorld, Matrix4x4 volumeToWorld, VolumeGeometry geometry, int width, int height)
        {
            if (width < 1 || height < 1)
                throw new ArgumentOutOfRangeException(nameof(width), $"{width} x {height}", "A picture has 1 x 1 pixels at least.");
            Affine viewToLps = VolumeSpace.WorldToLps(geometry, volumeToWorld) * VolumeSpace.ToAffine(cameraToWorld);
            ViewRays rays = ViewRays.Of(projection);

            // x, y in pixels -> normalised device coordinates -> view space, where one step along a ray is one unit of depth (z = -1).
            VectorMm originX = viewToLps.TransformVector(rays.OriginPerX * (2.0 / width));
            VectorMm originY = viewToLps.TransformVector(rays.OriginPerY * (2.0 / height));
            VectorMm directionX = viewToLps.TransformVector(rays.DirectionPerX * (2.0 / width));
            VectorMm directionY = viewToLps.TransformVector(rays.DirectionPerY * (2.0 / height));
            PointMm origin = viewToLps.TransformPoint(rays.Origin - rays.OriginPerX - rays.OriginPerY);
            VectorMm direction = viewToLps.TransformVector(rays.Direction - rays.DirectionPerX - rays.DirectionPerY);
            return new PictureRayBundle(
                width, height, origin, originX, originY, direction, directionX, directionY, rays.Near, rays.Far,
                viewToLps.TransformVector(new VectorMm(1, 0, 0)), viewToLps.TransformVector(new VectorMm(0, 1, 0)),
                viewToLps.TransformVector(new VectorMm(0, 0, 1)));
        }

        static PictureRays ToPictureRays(in PictureRayBundle b) => new PictureRays(
            b.Origin, b.OriginDx, b.OriginDy, b.Direction, b.DirectionDx, b.DirectionDy, b.Width, b.Height, b.NearT, b.FarT);

        /// <summary>
        /// A projection's rays in view space (x right, y up, looking along -z): origin and direction for normalised device coordinates 0, 0, and
        /// what they gain for one unit of each.
        /// </summary>
        readonly struct ViewRays
        {
            public readonly PointMm Origin;
            public readonly VectorMm OriginPerX, OriginPerY, Direction, DirectionPerX, DirectionPerY;
            public readonly double Near, Far;

            ViewRays(
                PointMm origin, VectorMm originPerX, VectorMm originPerY, VectorMm direction, VectorMm directionPerX, VectorMm directionPerY,
                double near, double far)
            {
                Origin = origin;
                OriginPerX = originPerX;
                OriginPerY = originPerY;
                Direction = direction;
                DirectionPerX = directionPerX;
                DirectionPerY = directionPerY;
                Near = near;
                Far = far;
            }

            /// <summary>
            /// Solves clip.xy = ndc.xy * clip.w for the view's x and y at a given z. clip.w is a multiple of z in a perspective projection and
            /// constant in an orthographic one.
            /// </summary>
            public static ViewRays Of(Matrix4x4 p)
            {
                double determinant = (double)p.m00 * p.m11 - (double)p.m01 * p.m10;
                if (determinant == 0 || double.IsNaN(determinant))
                    throw new ArgumentException("The camera's projection matrix cannot be inverted.", nameof(p));
                VectorMm Solve(double x, double y, double z) =>
                    new VectorMm((p.m11 * x - p.m01 * y) / determinant, (p.m00 * y - p.m10 * x) / determinant, z);

                bool perspective = p.m32 != 0f;
                double originZ = perspective ? -p.m33 / p.m32 : 0;
                VectorMm origin = Solve(-(p.m02 * originZ + p.m03), -(p.m12 * originZ + p.m13), originZ);
                VectorMm direction = Solve(p.m02, p.m12, -1);
                double scale = perspective ? -p.m32 : p.m33;
                VectorMm perX = Solve(scale, 0, 0), perY = Solve(0, scale, 0);
                VectorMm none = default;
                double near = originZ - DepthAt(p, -1), far = originZ - DepthAt(p, 1);
                if (!(far > near))
                    far = double.PositiveInfinity;
                if (near < 0)
                {
                    origin += near * direction;
                    far -= near;
                    near = 0;
                }
                return new ViewRays(
                    new PointMm(origin.X, origin.Y, origin.Z),
                    perspective ? none : perX, perspective ? none : perY, direction,
                    perspective ? perX : none, perspective ? perY : none, near, far);
            }

            /// <summary>The view's z where the depth in normalised device coordinates is <paramref name="depth"/>.</summary>
            static double DepthAt(Matrix4x4 p, double depth) => (depth * p.m33 - p.m23) / (p.m22 - depth * p.m32);
        }
    }
}
