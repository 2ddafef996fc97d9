using System;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Headless.Cli.Bench.Error.Reference
{
    /// <summary>
    /// The picture that the kernels' pictures come near to: the definitions of Documentation~/architecture.md in double precision, from the data before
    /// quantisation, with a step of 1/16 reference length, every sample taken, and rays that end where a hundred-millionth of the light is left.
    /// </summary>
    sealed class ReferenceRenderer
    {
        public const double Step = 1.0 / 16;

        const double NothingLeft = 1e-8;
        const double VisibleAlpha = 0.5, Nearly = 0.9;
        const double OneCode = 1 / 255.0;
        const double EdgeReach = 0.5, Plateau = 2.5; // reference lengths

        readonly ReferenceField field;
        readonly Rgba[] segmentColors;
        readonly LightSettings light;

        public ReferenceRenderer(ReferenceField field, LightSettings light)
        {
            this.field = field;
            this.light = light;
            segmentColors = [.. field.Segments.Select(segment => Linear(segment.Color))];
        }

        public ReferencePicture Render(PictureRays rays, CancellationToken cancellation)
        {
            var picture = new ReferencePicture(
                rays.Width, rays.Height, new Rgba[rays.Width * rays.Height], new double[rays.Width * rays.Height], new ushort[rays.Width * rays.Height]);
            var toLight = ViewAxes.Of(rays).Towards(light.Direction);
            Parallel.For(0, rays.Height, new ParallelOptions { CancellationToken = cancellation }, row =>
            {
                for (var column = 0; column < rays.Width; column++) March(picture, column + rays.Width * row, rays.RayThroughPixel(column, row), toLight);
            });
            return picture;
        }

        void March(ReferencePicture picture, int pixel, RayMm ray, VectorMm toLight)
        {
            var path = new ReferenceRay(field, ray);
            var (near, far) = path.Crossing(0, double.MaxValue);
            var stepMm = Step * field.Geometry.ReferenceLengthMm;
            var nearlyMm = double.NaN;
            double red = 0, green = 0, blue = 0, through = 1, depth = double.PositiveInfinity;
            var seen = PictureData.NoSegment;
            for (long n = 0; near + n * stepMm < far && through > NothingLeft; n++)
            {
                var begin = near + n * stepMm;
                var length = Math.Min(stepMm, far - begin);
                var middle = begin + 0.5 * length;
                var opacity = path.OpacityAt(middle);
                if (opacity <= 0) continue;
                var logPassing = opacity < 1 ? length / field.Geometry.ReferenceLengthMm * Math.Log(1 - opacity) : double.NegativeInfinity;
                var after = through * Math.Exp(logPassing);
                var (diffuse, specular) = Shade(path.NormalAt(middle), -ray.Direction, toLight);
                var color = ColorAt(path, middle);
                var weight = through - after;
                red += weight * (color.R * diffuse.R + specular.R);
                green += weight * (color.G * diffuse.G + specular.G);
                blue += weight * (color.B * diffuse.B + specular.B);
                if (double.IsNaN(nearlyMm) && 1 - after >= Nearly * VisibleAlpha) nearlyMm = begin;
                if (1 - through < VisibleAlpha && 1 - after >= VisibleAlpha)
                {
                    var share = opacity < 1 ? Math.Clamp(Math.Log((1 - VisibleAlpha) / through) / logPassing, 0, 1) : 0;
                    depth = begin + share * length;
                    var there = path.SegmentAt(depth);
                    seen = (ushort)(there >= 0 ? there : path.SegmentAt(middle));
                    depth = EdgeBefore(path, nearlyMm, depth, far);
                }

                through = after;
            }

            picture.Colors[pixel] = new Rgba(red, green, blue, 1 - through);
            picture.DepthsMm[pixel] = depth;
            picture.Segments[pixel] = seen;
        }

        /// <summary>The depth of the edge that makes a point the first visible one.</summary>
        double EdgeBefore(ReferenceRay path, double nearlyMm, double pointMm, double farMm)
        {
            var unit = field.Geometry.ReferenceLengthMm;
            double peak = 0;
            for (var at = nearlyMm; at <= Math.Min(pointMm + Plateau * unit, farMm); at += Step * unit) peak = Math.Max(peak, path.OpacityAt(at));
            var thickness = Math.Log(1 - VisibleAlpha) / Math.Log(Math.Max(1 - peak, OneCode)) * Math.Clamp((1 - peak) / OneCode, 0, 1) * unit;
            double level = 0.5 * peak, later = path.OpacityAt(pointMm);
            if (later < level) return pointMm;
            for (var n = 1; n * Step < EdgeReach; n++)
            {
                var opacity = path.OpacityAt(pointMm - n * Step * unit);
                if (opacity < level) return Math.Min(pointMm, pointMm - (n - (level - opacity) / (later - opacity)) * Step * unit + thickness);
                later = opacity;
            }

            return Math.Min(pointMm, pointMm - EdgeReach * unit + thickness);
        }

        /// <summary>
        /// That of the voxels around, each by its share and its opacity; where all are empty, likewise a reference length further; where these are, that of the
        /// segment around.
        /// </summary>
        Rgba ColorAt(ReferenceRay path, double distanceMm)
        {
            if (Blended(path.ColorsAt(distanceMm)) is { } here) return here;
            if (Blended(path.ColorsAt(distanceMm + field.Geometry.ReferenceLengthMm)) is { } ahead) return ahead;
            return segmentColors[Math.Max(path.SegmentAt(distanceMm), 0)];
        }

        Rgba? Blended(ReadOnlySpan<(int Segment, double Weight)> colors)
        {
            double r = 0, g = 0, b = 0, sum = 0;
            foreach (var (one, weight) in colors)
            {
                var color = segmentColors[one];
                (r, g, b, sum) = (r + weight * color.R, g + weight * color.G, b + weight * color.B, sum + weight);
            }

            return sum > 0 ? new Rgba(r / sum, g / sum, b / sum, 1) : null;
        }

        /// <summary>Blinn-Phong, as Shaders/Shading.hlsl has it: what the surface's own colour is multiplied with, and what is added.</summary>
        (Rgba Factor, Rgba Added) Shade(VectorMm normal, VectorMm toViewer, VectorMm toLight)
        {
            var n = normal.Length > 1e-4 ? normal.Normalized() : toViewer;
            n -= 2 * Math.Min(n.Dot(toViewer), 0) * toViewer;
            var halfway = (toLight + toViewer).Normalized();
            var diffuse = light.Diffuse * Math.Max(n.Dot(toLight), 0);
            var specular = light.Specular * Math.Pow(Math.Clamp(n.Dot(halfway), 1e-4, 1), light.Shininess);
            var (r, g, b) = (SrgbCurve.ToLinear(light.Color.r), SrgbCurve.ToLinear(light.Color.g), SrgbCurve.ToLinear(light.Color.b));
            return (new Rgba(light.Ambient + diffuse * r, light.Ambient + diffuse * g, light.Ambient + diffuse * b, 0),
                new Rgba(specular * r, specular * g, specular * b, 0));
        }

        static Rgba Linear(SegmentColor color) =>
            new(SrgbCurve.ToLinear(color.R / 255.0), SrgbCurve.ToLinear(color.G / 255.0), SrgbCurve.ToLinear(color.B / 255.0), 1);
    }
}
