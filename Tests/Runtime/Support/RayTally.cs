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

        /// <summary>Rays on which the picture shows another segment than the picker finds, none instead of one, or one instead of none, and no hair's breadth decides.</summary>
        public int Wrong { get; private set; }

        /// <summary>The largest difference in depth where both have the same segment.</summary>
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
            if (hit.Segment == (shown == PictureData.NoSegment ? -1 : shown))
                WorstDepthMm = hit.Hit ? Math.Max(WorstDepthMm, Math.Abs(hit.DistanceMm - shownDepthMm)) : WorstDepthMm;
            else if (IsUndecided(ray, hit))
                Undecided++;
            else
                Wrong++;
        }

        bool IsUndecided(RayMm ray, SegmentHit hit) =>
            SegmentPicker.Pick(field, ray, early).Hit != SegmentPicker.Pick(field, ray, late).Hit || (hit.Hit && IsTie(ray, hit));

        /// <summary>Whether a ray beside it, a hair's breadth away, meets another segment.</summary>
        bool IsTie(RayMm ray, SegmentHit hit)
        {
            for (int n = 0; n < 8; n++)
            {
                var hair = new VectorMm((n & 1) == 0 ? -HairVoxels : HairVoxels, (n & 2) == 0 ? -HairVoxels : HairVoxels, (n & 4) == 0 ? -HairVoxels : HairVoxels);
                var beside = new RayMm(ray.Origin + field.Volume.Geometry.IjkToLps.TransformVector(hair), ray.Direction);
                if (SegmentPicker.Pick(field, beside, settings).Segment != hit.Segment)
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
