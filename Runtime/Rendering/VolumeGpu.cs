using System;
using System.Collections.Generic;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>All that a renderer has on the GPU for one volume: made together, freed together.</summary>
    sealed class VolumeGpu : IDisposable
    {
        readonly CarvePipeline pipeline;
        readonly Raymarcher raymarcher;
        readonly RenderStatistics statistics;

        VolumeGpu(SegmentedVolume volume, AnatomyCarveShaders shaders, RenderStatistics statistics)
        {
            this.statistics = statistics;
            raymarcher = new Raymarcher(shaders, statistics);
            pipeline = new CarvePipeline(volume, shaders, statistics);
            statistics.Source = this;
        }

        public SegmentedVolume Volume => pipeline.Volume;

        public PictureCache Pictures { get; } = new PictureCache();

        /// <summary>Puts a volume on the GPU.</summary>
        /// <param name="problem">Why it cannot be done on this device, as a sentence.</param>
        /// <returns>Null where there is a problem.</returns>
        public static VolumeGpu TryCreate(SegmentedVolume volume, RenderStatistics statistics, out string problem)
        {
            problem = DeviceSupport.Missing(volume.Geometry, volume.Segments.Count);
            if (problem != null)
                return null;
            AnatomyCarveShaders shaders = AnatomyCarveShaders.Load();
            if (shaders == null)
            {
                problem = "Runtime/Resources/AnatomyCarveShaders.asset is missing in this build.";
                return null;
            }
            try
            {
                return new VolumeGpu(volume, shaders, statistics);
            }
            catch (AnatomyCarveException e)
            {
                problem = e.Message;
                return null;
            }
            catch (Exception e) when (e is ArgumentException || e is UnityException || e is OutOfMemoryException)
            {
                problem = $"The device could not take it: {e.Message}";
                return null;
            }
        }

        public void Update(CarvingSnapshot carving, OpacityTransferFunction transferFunction, SegmentTable segments, RenderQuality quality) =>
            pipeline.Update(carving, transferFunction, segments, quality.CutMode, quality.AntiAliasSettings);

        public void Render(in PictureRayBundle rays, RenderQuality quality, LightSettings light, bool countSamples, CarvedPicture picture) =>
            raymarcher.Render(pipeline, rays, quality, light, countSamples, picture);

        public void AddSizes(List<ResourceSize> sizes)
        {
            pipeline.AddSizes(sizes);
            Pictures.AddSizes(sizes);
        }

        public void Dispose()
        {
            pipeline.Dispose();
            raymarcher.Dispose();
            Pictures.Dispose();
            statistics.Source = null;
        }
    }
}
