using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// Where a preview looks from: on an orbit around the volume's centre. The projection is parallel, so that its scale holds for all that is seen.
    /// </summary>
    sealed class PreviewOrbit
    {
        public const double SmallestZoom = 0.5, LargestZoom = 8;

        const double StartAzimuth = 30, StartElevation = 15, DegreesAcross = 180, ZoomPerStep = 1.05, Margin = 1.04;

        double azimuth = StartAzimuth, elevation = StartElevation, zoom = 1;
        OrbitCamera camera, raysFrom;
        PictureRays rays;
        VolumeGeometry raysOf;
        double raysZoom;

        /// <summary>The view's direction.</summary>
        public OrbitCamera Camera => camera ??= new OrbitCamera(azimuth, elevation);

        /// <summary>1 = all of the volume is seen.</summary>
        public double Zoom => zoom;

        /// <summary>To the right in the picture, LPS, length 1.</summary>
        public VectorMm RightLps => Camera.UpLps.Cross(Camera.TowardsEyeLps);

        /// <summary>Goes back to the first view.</summary>
        public void Reset()
        {
            azimuth = StartAzimuth;
            elevation = StartElevation;
            zoom = 1;
            camera = null;
        }

        /// <summary>Turns the volume as a hand would that drags its front side.</summary>
        /// <param name="delta">The mouse's way in GUI pixels (y downwards).</param>
        /// <param name="size">The preview's smaller side, pixels.</param>
        public void Drag(Vector2 delta, float size)
        {
            double degreesPerPixel = DegreesAcross / Math.Max(1f, size);
            azimuth = (azimuth - delta.x * degreesPerPixel) % 360;
            elevation = Math.Max(-90, Math.Min(90, elevation + delta.y * degreesPerPixel));
            camera = null;
        }

        /// <summary>Looks nearer (negative) or from further away, as a mouse wheel says.</summary>
        public void Scroll(float wheel) => zoom = Math.Max(SmallestZoom, Math.Min(LargestZoom, zoom * Math.Pow(ZoomPerStep, -wheel)));

        /// <summary>The rays of a picture of a volume. The same object until something changes.</summary>
        public PictureRays Rays(VolumeGeometry volume, int width, int height)
        {
            if (rays == null || raysFrom != Camera || raysOf != volume || raysZoom != zoom || rays.Width != width || rays.Height != height)
            {
                Extents(volume, out double right, out double up, out double depth);
                double heightMm = 2 * Margin * Math.Max(up, right * height / width) / zoom;
                PointMm eye = volume.CentreLps + Camera.TowardsEyeLps * (depth * Margin);
                rays = PictureRays.Orthographic(eye, volume.CentreLps, Camera.UpLps, heightMm, width, height);
                raysFrom = Camera;
                raysOf = volume;
                raysZoom = zoom;
            }
            return rays;
        }

        /// <summary>Millimetres of the patient in one pixel of a picture.</summary>
        public static double MmPerPixel(PictureRays rays) => rays.OriginDy.Length;

        /// <summary>How far the volume's corners lie from its centre along the picture's axes.</summary>
        void Extents(VolumeGeometry volume, out double right, out double up, out double depth)
        {
            right = up = depth = 0;
            for (int corner = 0; corner < VolumeGeometry.Corners; corner++)
            {
                VectorMm offset = volume.CornerOffset(corner);
                right = Math.Max(right, Math.Abs(offset.Dot(RightLps)));
                up = Math.Max(up, Math.Abs(offset.Dot(Camera.UpLps)));
                depth = Math.Max(depth, Math.Abs(offset.Dot(Camera.TowardsEyeLps)));
            }
        }
    }
}
