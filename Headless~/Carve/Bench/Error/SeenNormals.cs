using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>What a picture shows of surfaces.</summary>
    /// <param name="Normals">unit vectors, LPS; (0, 0, 0) where nothing is lit</param>
    /// <param name="DepthsMm">along the ray from its origin; infinite where nothing is seen</param>
    /// <param name="LitMm">likewise, where half of a pixel's light comes from before, half from behind: in the ramp that voxels make of an edge, behind the edge itself</param>
    /// <param name="Segments">first visible segments</param>
    sealed record SeenSurface(VectorMm[] Normals, float[] DepthsMm, double[] LitMm, ushort[] Segments)
    {
        public bool Shows(int pixel) => float.IsFinite(DepthsMm[pixel]);
    }

    /// <summary>
    /// The normals that a picture is shaded with, read off its shades: a white surface under diffuse light from one direction alone is as bright as the
    /// normal's component that way. Light from both ends of an axis, one after the other, gives the component with its sign. What several
    /// samples of a ray contribute is blended as colours are. For parallel rays, to which visible surfaces turn one side.
    /// A normal belongs to the place that the light comes from, which may lie before or behind the true surface; what that is apart is the depth's error.
    /// </summary>
    static class SeenNormals
    {
        const double Around = 4, LitStep = 1.0 / 16; // reference lengths
        public static SeenSurface Look(CarvedVolumeRenderer renderer, PictureRays rays)
        {
            var light = renderer.Light;
            try
            {
                var axes = ViewAxes.Of(rays);
                var seen = new VectorMm[rays.Width * rays.Height];
                AddComponent(renderer, rays, Vector3.right, axes.Right, seen);
                AddComponent(renderer, rays, Vector3.up, axes.Up, seen);
                var picture = AddComponent(renderer, rays, Vector3.forward, axes.Backward, seen);
                var normals = Array.ConvertAll(seen, normal => normal.LengthSquared > 0 ? normal.Normalized() : default);
                var field = renderer.Field;
                var lit = new double[seen.Length];
                for (var pixel = 0; pixel < lit.Length; pixel++)
                {
                    lit[pixel] = LitPlace(field, rays.RayThroughPixel(pixel % rays.Width, pixel / rays.Width), picture.DepthMm[pixel]);
                }

                return new SeenSurface(normals, picture.DepthMm, lit, picture.Segments);
            }
            finally
            {
                renderer.Light = light;
            }
        }

        /// <summary>Where half of the light is stopped, of opaque matter around a depth.</summary>
        static double LitPlace(CarvedField field, RayMm ray, float depthMm)
        {
            if (!float.IsFinite(depthMm)) return double.PositiveInfinity;
            var geometry = field.Volume.Geometry;
            double passing = 0; // the log of the light
            for (var n = -Around; n < Around; n += LitStep)
            {
                var middleMm = depthMm + (n + 0.5 * LitStep) * geometry.ReferenceLengthMm;
                var index = geometry.LpsToIjk.TransformPoint(ray.At(middleMm));
                var opacity = field.SampleAntiAliased(index.X, index.Y, index.Z);
                var here = opacity < 1 ? LitStep * Math.Log(1 - opacity) : double.NegativeInfinity;
                if (passing + here <= -Math.Log(2))
                {
                    return depthMm + (n + LitStep * Math.Clamp((-Math.Log(2) - passing) / here, 0, 1)) * geometry.ReferenceLengthMm;
                }

                passing += here;
            }

            return depthMm;
        }

        static PictureData AddComponent(CarvedVolumeRenderer renderer, PictureRays rays, Vector3 light, VectorMm axis, VectorMm[] normals)
        {
            var (from, against) = (Lit(renderer, rays, light), Lit(renderer, rays, -light));
            for (var pixel = 0; pixel < normals.Length; pixel++) normals[pixel] += (from.Color[pixel].r - against.Color[pixel].r) * axis;
            return from;
        }

        static PictureData Lit(CarvedVolumeRenderer renderer, PictureRays rays, Vector3 direction)
        {
            renderer.Light = new LightSettings { Direction = direction, Color = Color.white, Ambient = 0, Diffuse = 1, Specular = 0 };
            return renderer.Render(rays).Read();
        }
    }
}
