using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>What a picture shows of surfaces.</summary>
    /// <param name="Normals">unit vectors, LPS; (0, 0, 0) where nothing is lit</param>
    /// <param name="DepthsMm">along the ray from its origin; infinite where nothing is seen</param>
    /// <param name="Segments">first visible segments</param>
    sealed record SeenSurface(VectorMm[] Normals, float[] DepthsMm, ushort[] Segments)
    {
        public bool Shows(int pixel) => float.IsFinite(DepthsMm[pixel]);
    }

    /// <summary>
    /// The normals that a picture is shaded with, read off its shades: a white surface under diffuse light from one direction alone is as bright as the
    /// normal's component that way. Light from both ends of an axis, one after the other, gives the component with its sign. What several
    /// samples of a ray contribute is blended as colours are. For parallel rays, to which visible surfaces turn one side.
    /// A normal belongs to the place that is seen, which may lie before or behind the true surface: that error is the depth's.
    /// </summary>
    static class SeenNormals
    {
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
                return new SeenSurface(normals, picture.DepthMm, picture.Segments);
            }
            finally
            {
                renderer.Light = light;
            }
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
