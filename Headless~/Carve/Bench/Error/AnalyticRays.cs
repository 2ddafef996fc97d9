using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Phantoms;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// Rays whose colour is known: through the one cell of a volume of 2 x 2 x 2 voxels, in which the interpolated field has no kink. Opacity a rises and
    /// falls from corner to corner, so does the normal. Extinction is -ln(1 - a), and a ray's colour the integral of extinction x shading x
    /// transmittance. It is taken of the very field that the kernel interpolates, normals as decoded from their two bytes, by the midpoint rule at 8,192
    /// and 16,384 samples in double precision, extrapolated: right to 1e-11.
    /// </summary>
    static class AnalyticRays
    {
        public const string Scene = "one cell, opacities 0.02 to 0.995";

        const int Size = 8;
        const double NearMm = 0.55, FarMm = 1.45; // from the eye's plane, which lies 0.5 mm before the cell
        const int ReferenceSamples = 8192;

        static readonly float[] Opacities = [0.02f, 0.1f, 0.3f, 0.05f, 0.995f, 0.97f, 0.9f, 0.99f];
        static readonly VectorMm ViewDirection = new VectorMm(0.2, -0.1, 1).Normalized();
        static readonly VectorMm ToLight = new VectorMm(0.35, 0.3, -1).Normalized();

        /// <summary>How far the kernel's pictures are from the integral.</summary>
        /// <param name="Rms">over alpha and colour of all rays</param>
        /// <param name="Largest">likewise</param>
        public readonly record struct SumError(double Rms, double Largest);

        /// <summary>The kernel's errors at several numbers of samples per ray.</summary>
        public static SumError[] Measure(IReadOnlyList<int> samples)
        {
            var field = MakeField();
            var rays = Rays();
            var exact = Enumerable.Range(0, Size * Size).Select(pixel => Exact(field, rays, pixel)).ToArray();
            return samples.Select(count => Compare(field.March(rays, StepOf(rays, count), ToLight).Colors, exact)).ToArray();
        }

        /// <summary>The same for a sum that takes each step's opacity from its beginning, to see what the rays ask for: of first order.</summary>
        public static SumError FirstOrder(int samples)
        {
            var field = MakeField();
            var rays = Rays();
            var pixels = Enumerable.Range(0, Size * Size).ToArray();
            return Compare(
                pixels.Select(pixel => ToFloat(Sum(field, rays, pixel, samples, place: 0))).ToArray(),
                pixels.Select(pixel => Exact(field, rays, pixel)).ToArray());
        }

        public static JsonObject Settings() => new()
        {
            ["voxels"] = "2x2x2, 1 mm",
            ["opacities"] = new JsonArray([.. Opacities.Select(opacity => (JsonNode)Math.Round((double)opacity, 6))]),
            ["rays"] = Size * Size,
            ["rayLengthMm"] = FarMm - NearMm,
        };

        static RayField MakeField()
        {
            var field = new RayField(Grids.Centred(2, 2, 2));
            Opacities.CopyTo(field.Opacities, 0);
            Grids.ForEach(field.Geometry, (i, j, k, voxel) =>
            {
                var normal = new VectorMm(0.5 * i - 0.2, 0.4 * j - 0.1 + 0.2 * k, -1 + 0.3 * k).Normalized();
                (field.NormalCodes[2 * voxel], field.NormalCodes[2 * voxel + 1]) = Octahedral.Encode(normal);
            });
            return field;
        }

        static PictureRays Rays()
        {
            var middle = new PointMm(0, 0, 0);
            return PictureRays.Orthographic(middle - ViewDirection, middle, new VectorMm(0, 1, 0), 0.2, Size, Size).WithRange(NearMm, FarMm);
        }

        static double StepOf(PictureRays rays, int samples) => (rays.FarT - rays.NearT) / samples;

        static double[] Exact(RayField field, PictureRays rays, int pixel)
        {
            var (coarse, fine) = (Sum(field, rays, pixel, ReferenceSamples, 0.5), Sum(field, rays, pixel, 2 * ReferenceSamples, 0.5));
            return [.. coarse.Zip(fine, (a, b) => b + (b - a) / 3)];
        }

        /// <summary>Grey and alpha of a ray.</summary>
        /// <param name="place">where in a step its sample lies, 0 to 1</param>
        static double[] Sum(RayField field, PictureRays rays, int pixel, int samples, double place)
        {
            var ray = rays.RayThroughPixel(pixel % Size, pixel / Size);
            var step = StepOf(rays, samples);
            double depth = 0, grey = 0;
            for (var n = 0; n < samples; n++)
            {
                var at = ray.At(rays.NearT + (n + place) * step);
                var (opacity, normal) = Interpolate(field, at.X + 0.5, at.Y + 0.5, at.Z + 0.5);
                var thickness = -Math.Log(1 - opacity) * step;
                grey += (Math.Exp(-depth) - Math.Exp(-depth - thickness)) * Shade(normal, -ray.Direction);
                depth += thickness;
            }

            return [grey, 1 - Math.Exp(-depth)];
        }

        static (double Opacity, VectorMm Normal) Interpolate(RayField field, double x, double y, double z)
        {
            double opacity = 0;
            VectorMm normal = default;
            for (var n = 0; n < 8; n++)
            {
                var weight = ((n & 1) == 0 ? 1 - x : x) * ((n & 2) == 0 ? 1 - y : y) * ((n & 4) == 0 ? 1 - z : z);
                opacity += weight * field.Opacities[n];
                normal += weight * Octahedral.Decode(field.NormalCodes[2 * n], field.NormalCodes[2 * n + 1]);
            }

            return (opacity, normal.Normalized());
        }

        static double Shade(VectorMm normal, VectorMm toViewer)
        {
            var facing = normal - 2 * Math.Min(normal.Dot(toViewer), 0) * toViewer;
            var halfway = (ToLight + toViewer).Normalized();
            return RayField.Ambient + RayField.Diffuse * Math.Max(facing.Dot(ToLight), 0)
                + RayField.Specular * Math.Pow(Math.Max(facing.Dot(halfway), 0), RayField.Shininess);
        }

        static SumError Compare(Vector4[] found, double[][] exact)
        {
            var errors = found.Zip(exact, (color, expected) => new[] { color.x - expected[0], color.w - expected[1] }).SelectMany(pair => pair).ToArray();
            return new SumError(Math.Sqrt(errors.Average(error => error * error)), errors.Max(Math.Abs));
        }

        static Vector4 ToFloat(double[] greyAndAlpha) => new((float)greyAndAlpha[0], (float)greyAndAlpha[0], (float)greyAndAlpha[0], (float)greyAndAlpha[1]);
    }
}
