using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Picking
{
    /// <summary>A ray in continuous voxel indices, by distance in millimetres.</summary>
    readonly struct IndexRay
    {
        readonly BrickGrid bricks;
        readonly VectorMm start;
        readonly VectorMm perMm;

        IndexRay(BrickGrid bricks, VectorMm start, VectorMm perMm)
        {
            this.bricks = bricks;
            this.start = start;
            this.perMm = perMm;
        }

        public static IndexRay Of(CarvedField field, RayMm ray)
        {
            VolumeGeometry geometry = field.Volume.Geometry;
            PointMm origin = geometry.LpsToIjk.TransformPoint(ray.Origin);
            return new IndexRay(field.Bricks, new VectorMm(origin.X, origin.Y, origin.Z), geometry.LpsToIjk.TransformVector(ray.Direction));
        }

        public VectorMm At(double distanceMm) => start + distanceMm * perMm;

        /// <summary>Narrows a range of distances to the part inside the volume's box, [-0.5, size - 0.5]; false where nothing is left.</summary>
        public bool ClipToBox(ref double near, ref double far) =>
            Clip(start.X, perMm.X, -0.5, bricks.SizeI - 0.5, ref near, ref far)
            && Clip(start.Y, perMm.Y, -0.5, bricks.SizeJ - 0.5, ref near, ref far)
            && Clip(start.Z, perMm.Z, -0.5, bricks.SizeK - 0.5, ref near, ref far)
            && far > near;

        /// <summary>
        /// Where a place lies in a brick's cell whose samples are all 0: the distance at which the ray leaves that cell. Negative infinity where it
        /// does not. A cell holds the places whose lower neighbour along each axis is a voxel of the brick.
        /// </summary>
        public double ClearUntil(CarvedField field, VectorMm index)
        {
            int x = Brick(index.X, bricks.SizeI), y = Brick(index.Y, bricks.SizeJ), z = Brick(index.Z, bricks.SizeK);
            if (!field.IsClearFrom(x, y, z))
                return double.NegativeInfinity;
            double near = double.NegativeInfinity, far = double.PositiveInfinity;
            ClipToCell(start.X, perMm.X, x, bricks.BricksX, ref near, ref far);
            ClipToCell(start.Y, perMm.Y, y, bricks.BricksY, ref near, ref far);
            ClipToCell(start.Z, perMm.Z, z, bricks.BricksZ, ref near, ref far);
            return Math.Min(far, double.MaxValue);
        }

        static int Brick(double index, int size)
        {
            double clamped = index > 0 ? Math.Min(index, size - 1) : 0;
            return (int)clamped / BrickGrid.BrickSize;
        }

        static void ClipToCell(double start, double perMm, int brick, int bricksAlong, ref double near, ref double far)
        {
            double low = brick == 0 ? double.NegativeInfinity : brick * BrickGrid.BrickSize;
            double high = brick == bricksAlong - 1 ? double.PositiveInfinity : (brick + 1) * BrickGrid.BrickSize;
            Clip(start, perMm, low, high, ref near, ref far);
        }

        static bool Clip(double start, double perMm, double low, double high, ref double near, ref double far)
        {
            if (perMm == 0)
                return start >= low && start <= high;
            double a = (low - start) / perMm, b = (high - start) / perMm;
            near = Math.Max(near, Math.Min(a, b));
            far = Math.Min(far, Math.Max(a, b));
            return true;
        }
    }
}
