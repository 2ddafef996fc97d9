using System;
using System.Text.Json.Nodes;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// Compares what a picture shows with what the pointer finds, ray by ray. A ray is undecided, and not counted, where a hair's breadth would change
    /// what the pointer finds: an edge of a segment within it, or an alpha that reaches the threshold or not within it.
    /// </summary>
    sealed class PointerTally(CarvedField field, RaySettings settings, double hairVoxels, double hairAlpha)
    {
        readonly RaySettings early = WithAlpha(settings, -hairAlpha), late = WithAlpha(settings, hairAlpha);
        double sumOfSquaresMm;
        double largestMm;
        int same;

        public int Rays { get; private set; }

        public int Hits { get; private set; }

        public int Undecided { get; private set; }

        /// <summary>Decided rays on which the picture shows another segment than the pointer finds, none instead of one, or one instead of none.</summary>
        public int Disagreements { get; private set; }

        public void Compare(PictureData picture, PictureRays rays)
        {
            for (var pixel = 0; pixel < rays.Width * rays.Height; pixel++)
            {
                Compare(rays.RayThroughPixel(pixel % rays.Width, pixel / rays.Width), picture.Segments[pixel], picture.DepthMm[pixel]);
            }
        }

        public JsonObject ToJson() => new()
        {
            ["rays"] = Rays,
            ["hits"] = Hits,
            ["undecided"] = Undecided,
            ["disagreements"] = Disagreements,
            ["depthRmsMm"] = same > 0 ? Math.Sqrt(sumOfSquaresMm / same) : 0,
            ["depthLargestMm"] = largestMm,
        };

        void Compare(RayMm ray, ushort shown, float shownDepthMm)
        {
            Rays++;
            var hit = SegmentPicker.Pick(field, ray, settings);
            if (hit.Hit) Hits++;
            var expected = hit.Hit ? hit.Segment : PictureData.NoSegment;
            if (shown == expected)
            {
                if (hit.Hit) NoteDepth(Math.Abs(hit.DistanceMm - shownDepthMm));
            }
            else if (IsUndecided(ray, hit)) Undecided++;
            else Disagreements++;
        }

        void NoteDepth(double differenceMm)
        {
            same++;
            sumOfSquaresMm += differenceMm * differenceMm;
            largestMm = Math.Max(largestMm, differenceMm);
        }

        bool IsUndecided(RayMm ray, SegmentHit hit)
        {
            var (before, after) = (SegmentPicker.Pick(field, ray, early), SegmentPicker.Pick(field, ray, late));
            return before.Hit != after.Hit || (hit.Hit && IsAtEdge(ray, hit));
        }

        /// <summary>Whether a ray beside it, a hair's breadth away, meets another segment.</summary>
        bool IsAtEdge(RayMm ray, SegmentHit hit)
        {
            for (var n = 0; n < 8; n++)
            {
                var hair = new VectorMm((n & 1) == 0 ? -hairVoxels : hairVoxels, (n & 2) == 0 ? -hairVoxels : hairVoxels, (n & 4) == 0 ? -hairVoxels : hairVoxels);
                var beside = new RayMm(ray.Origin + field.Volume.Geometry.IjkToLps.TransformVector(hair), ray.Direction);
                if (SegmentPicker.Pick(field, beside, settings).Segment != hit.Segment) return true;
            }

            return false;
        }

        static RaySettings WithAlpha(RaySettings settings, double hair) => new()
        {
            StepReference = settings.StepReference,
            OpaqueAlpha = settings.OpaqueAlpha,
            FirstVisibleAlpha = settings.FirstVisibleAlpha + hair,
        };
    }
}
