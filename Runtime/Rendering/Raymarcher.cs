using System;
using AnatomyCarve.Volumes;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve
{
    /// <summary>The kernel <c>Raymarch</c>: makes pictures of a volume that a <see cref="CarvePipeline"/> holds.</summary>
    sealed class Raymarcher : IDisposable
    {
        const int GroupSize = 8;
        const double Furthest = 1e30;

        static readonly ProfilerMarker Marker = new ProfilerMarker("AnatomyCarve.Raymarch");

        readonly ComputeKernel kernel;
        readonly RenderStatistics statistics;
        readonly int[] pictureSize = new int[4];
        Texture2D noSceneDepth;

        /// <exception cref="AnatomyCarveException">The kernel could not be made.</exception>
        public Raymarcher(AnatomyCarveShaders shaders, TextureLayout layout, RenderStatistics statistics)
        {
            this.statistics = statistics;
            kernel = new ComputeKernel(shaders.Raymarch, nameof(shaders.Raymarch), layout);
        }

        /// <summary>Writes a picture, unless it already shows just that.</summary>
        /// <exception cref="ArgumentException">The scene's depth does not fit the picture.</exception>
        /// <exception cref="AnatomyCarveException">The device could not make the picture's textures.</exception>
        public void Render(
            CarvePipeline pipeline, in PictureRayBundle rays, RenderQuality quality, LightSettings light, bool countSamples, CarvedPicture picture)
        {
            picture.CheckSceneDepth(rays.Width, rays.Height);
            picture.Resize(rays.Width, rays.Height, countSamples);
            var shown = new PictureInputs(pipeline, rays, quality, light, countSamples, picture.SceneDepth);
            if (picture.Shows(shown))
                return;
            using (Marker.Auto())
            {
                picture.ClearSampleCounts();
                pipeline.BindForRays(kernel);
                SetView(rays, shown.HaveSceneDepth, pipeline.Volume.Geometry.CentreLps);
                kernel.SetVector(ShaderIds.March, quality.March);
                kernel.SetVector(ShaderIds.Skip, quality.Skip);
                light.Bind(kernel);
                kernel.SetVector(ShaderIds.LightDirection, PictureRayBundle.ToFloat(rays.TowardsLight(light.Direction)));
                SetTargets(picture);
                if (countSamples)
                    kernel.Shader.EnableKeyword(ShaderIds.CountSamples);
                else
                    kernel.Shader.DisableKeyword(ShaderIds.CountSamples);
                kernel.Dispatch(Groups(rays.Width), Groups(rays.Height));
                kernel.Shader.DisableKeyword(ShaderIds.CountSamples);
            }
            statistics.raymarch.Add(1, 0, (long)rays.Width * rays.Height);
            picture.SetShown(shown);
        }

        public static int Groups(int pixels) => (pixels + GroupSize - 1) / GroupSize;

        public void Dispose()
        {
            GpuObjects.Destroy(noSceneDepth);
            noSceneDepth = null;
        }

        void SetView(in PictureRayBundle rays, bool sceneDepth, PointMm centre)
        {
            pictureSize[0] = rays.Width;
            pictureSize[1] = rays.Height;
            pictureSize[2] = sceneDepth ? 1 : 0;
            kernel.Shader.SetInts(ShaderIds.PictureSize, pictureSize);
            kernel.SetVector(ShaderIds.RayOrigin, PictureRayBundle.ToFloat(rays.Origin - centre));
            kernel.SetVector(ShaderIds.RayOriginDx, PictureRayBundle.ToFloat(rays.OriginDx));
            kernel.SetVector(ShaderIds.RayOriginDy, PictureRayBundle.ToFloat(rays.OriginDy));
            kernel.SetVector(ShaderIds.RayDirection, PictureRayBundle.ToFloat(rays.Direction));
            kernel.SetVector(ShaderIds.RayDirectionDx, PictureRayBundle.ToFloat(rays.DirectionDx));
            kernel.SetVector(ShaderIds.RayDirectionDy, PictureRayBundle.ToFloat(rays.DirectionDy));
            kernel.SetVector(ShaderIds.RayRange, new Vector4((float)rays.NearT, (float)Math.Min(rays.FarT, Furthest), 0f, 0f));
        }

        void SetTargets(CarvedPicture picture)
        {
            kernel.SetTexture(ShaderIds.SceneDepth, picture.SceneDepth != null ? picture.SceneDepth : NoSceneDepth());
            kernel.SetTexture(ShaderIds.ColorOut, picture.ColorTexture);
            kernel.SetTexture(ShaderIds.DepthOut, picture.DepthTexture);
            kernel.SetTexture(ShaderIds.SegmentOut, picture.SegmentTexture);
            if (picture.SampleCounts != null)
                kernel.SetBuffer(ShaderIds.SampleCounts, picture.SampleCounts);
        }

        /// <summary>Every declared texture must be bound, whether it is read or not.</summary>
        Texture2D NoSceneDepth()
        {
            if (noSceneDepth == null)
            {
                noSceneDepth = new Texture2D(1, 1, GraphicsFormat.R32_SFloat, TextureCreationFlags.None)
                {
                    name = "AnatomyCarve no scene depth",
                    hideFlags = HideFlags.HideAndDontSave,
                };
                noSceneDepth.Apply(false, false);
            }
            return noSceneDepth;
        }
    }
}
