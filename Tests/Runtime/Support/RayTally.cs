using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Tests
{
    /// <summary>
    /// Compares what a picture shows with what the picker finds, ray by ray. The picture computes in float: a ray is undecided where a hair's breadth
    /// decides what the picker finds, which is a thousandth of a voxel at the place, or a ten-thousandth of alpha.
    /// </summary>
    sealed class RayTally
    {
        const double HairVoxels = 1e-3;
        const double HairAlpha = 1e-4;

        readonly CarvedField field;
        readonly RaySettings settings, early, late;

        public RayTally(CarvedField field, RaySettings settings)
        {
            this.field = field;
            this.settings = settings;
            early = WithAlpha(-HairAlpha);
            late = WithAlpha(HairAlpha);
        }

        public int Rays { get; private set; }

        public int Hits { get; private set; }

        public int Undecided { get; private set; }

        /// <summary>Decided rays on which the picture shows another segment than the picker finds, none instead of one, or one instead of none.</summary>
        public int Wrong { get; private set; }

        /// <summary>The largest difference in depth, on decided rays.</summary>
        public double WorstDepthMm { get; private set; }

        public void Compare(PictureData picture, PictureRays rays, Func<RayMm, SegmentHit> pick = null)
        {
            for (int y = 0; y < rays.Height; y++)
                for (int x = 0; x < rays.Width; x++)
                {
                    RayMm ray = rays.RayThroughPixel(x, y);
                    int pixel = x + y * rays.Width;
                    Compare(ray, pick == null ? SegmentPicker.Pick(field, ray, settings) : pick(ray), picture.Segments[pixel], picture.DepthMm[pixel]);
                }
        }

        public override string ToString() => FormattableString.Invariant(
            $"{Hits} hits on {Rays} rays, {Undecided} undecided, {Wrong} wrong, depth within {WorstDepthMm:g2} mm");

        void Compare(RayMm ray, SegmentHit hit, int shown, float shownDepthMm)
        {
            Rays++;
            Hits += hit.Hit ? 1 : 0;
            bool isUndecided = SegmentPicker.Pick(field, ray, early).Hit != SegmentPicker.Pick(field, ray, late).Hit || (hit.Hit && IsTie(hit));
            if (isUndecided)
                Undecided++;
            else if (hit.Segment != (shown == PictureData.NoSegment ? -1 : shown))
                Wrong++;
            else if (hit.Hit)
                WorstDepthMm = Math.Max(WorstDepthMm, Math.Abs(hit.DistanceMm - shownDepthMm));
        }

        bool IsTie(SegmentHit hit)
        {
            PointMm index = field.Volume.Geometry.LpsToIjk.TransformPoint(hit.PositionLps);
            for (int n = 0; n < 8; n++)
            {
                double x = index.X + ((n & 1) == 0 ? -HairVoxels : HairVoxels);
                double y = index.Y + ((n & 2) == 0 ? -HairVoxels : HairVoxels);
                double z = index.Z + ((n & 4) == 0 ? -HairVoxels : HairVoxels);
                if (field.SegmentAt(x, y, z) != hit.Segment)
                    return true;
            }
            return false;
        }

        RaySettings WithAlpha(double hair) => new RaySettings
        {
            StepReference = settings.StepReference,
            OpaqueAlpha = settings.OpaqueAlpha,
            FirstVisibleAlpha = settings.FirstVisibleAlpha + hair,
        };
    }
}
