using System.Threading;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Picking
{
    /// <summary>What the rays of a parallel projection meet first: a segment and a distance per pixel, the bottom row first.</summary>
    sealed class SurfaceMap
    {
        readonly float[] distancesMm;
        readonly int[] segments;

        SurfaceMap(PictureRays rays)
        {
            Rays = rays;
            distancesMm = new float[rays.Width * rays.Height];
            segments = new int[distancesMm.Length];
        }

        /// <summary>The rays it was made with.</summary>
        internal PictureRays Rays { get; }

        internal int Width => Rays.Width;

        internal int Height => Rays.Height;

        /// <summary>Pixels that show something.</summary>
        internal int Hits { get; private set; }

        /// <summary>Walks along every ray.</summary>
        internal static SurfaceMap Of(CarvedField field, PictureRays rays, RaySettings settings, CancellationToken cancellation)
        {
            var map = new SurfaceMap(rays);
            for (int row = 0; row < rays.Height; row++)
            {
                cancellation.ThrowIfCancellationRequested();
                for (int column = 0; column < rays.Width; column++)
                {
                    SegmentHit hit = SegmentPicker.Pick(field, rays.RayThroughPixel(column, row), settings);
                    int pixel = column + (rays.Width * row);
                    map.segments[pixel] = hit.Segment;
                    map.distancesMm[pixel] = (float)hit.DistanceMm;
                    map.Hits += hit.Hit ? 1 : 0;
                }
            }

            return map;
        }

        /// <summary>The segment that a pixel shows; -1 for none, and outside of the picture.</summary>
        internal int SegmentAt(int column, int row) => Contains(column, row) ? segments[column + (Width * row)] : -1;

        /// <summary>How far away a pixel's surface is, millimetres; infinite for none, and outside of the picture.</summary>
        internal float DistanceMmAt(int column, int row) => Contains(column, row) ? distancesMm[column + (Width * row)] : float.PositiveInfinity;

        bool Contains(int column, int row) => (uint)column < (uint)Width && (uint)row < (uint)Height;
    }
}
