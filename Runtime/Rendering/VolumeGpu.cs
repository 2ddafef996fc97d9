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
        readonly AnatomyCarveShaders shaders;
        readonly CarvePipeline pipeline;
        readonly RenderStatistics statistics;
        Raymarcher raymarcher;

        VolumeGpu(SegmentedVolume volume, AnatomyCarveShaders shaders, TextureLayout layout, RenderStatistics statistics)
        {
            this.shaders = shaders;
            this.statistics = statistics;
            pipeline = new CarvePipeline(volume, shaders, layout, statistics);
            statistics.Source = this;
        }

        public SegmentedVolume Volume => pipeline.Volume;

        /// <summary>Compact or portable.</summary>
        public TextureLayout Layout => pipeline.Layout;

        /// <summary>The voxels of which opacities and normals are stored; null before the first update.</summary>
        public VoxelBox? StoredVoxels => pipeline.StoredVoxels;

        public PictureCache Pictures { get; } = new PictureCache();

        /// <summary>Puts a volume on the GPU.</summary>
        /// <param name="layout">How its textures are to lie; automatic = as the device can write them.</param>
        /// <exception cref="AnatomyCarveException">It cannot be done on this device; the message says why.</exception>
        public static VolumeGpu Create(SegmentedVolume volume, TextureLayout layout, RenderStatistics statistics)
        {
            layout = DeviceSupport.Choose(layout);
            string problem = DeviceSupport.Missing(volume.Geometry, layout);
            if (problem != null)
                throw new AnatomyCarveException(problem);
            return new VolumeGpu(volume, AnatomyCarveShaders.LoadOrThrow(), layout, statistics);
        }

        /// <summary>Recomputes what changed.</summary>
        /// <exception cref="AnatomyCarveException">The device could not make what is needed.</exception>
        public void Update(in VolumeInputs inputs) => pipeline.Update(
            inputs.Carving, inputs.TransferFunction, inputs.Segments, inputs.Quality.CutMode, inputs.Quality.AntiAliasSettings);

        /// <exception cref="AnatomyCarveException">The device cannot make pictures.</exception>
        public void Render(in PictureRayBundle rays, RenderQuality quality, LightSettings light, bool countSamples, CarvedPicture picture)
        {
            raymarcher ??= new Raymarcher(shaders, pipeline.Layout, statistics);
            raymarcher.Render(pipeline, rays, quality, light, countSamples, picture);
        }

        /// <summary>Gives cameras' drawing the volume as it is here.</summary>
        public void Bind(VolumeDrawing drawing, RenderQuality quality, LightSettings light) => drawing.Bind(pipeline, quality, light);

        /// <summary>Lists what the volume takes, without pictures.</summary>
        public void AddVolumeSizes(List<ResourceSize> sizes) => pipeline.AddSizes(sizes);

        public void AddSizes(List<ResourceSize> sizes)
        {
            pipeline.AddSizes(sizes);
            Pictures.AddSizes(sizes);
        }

        public void Dispose()
        {
            pipeline.Dispose();
            raymarcher?.Dispose();
            Pictures.Dispose();
            statistics.Source = null;
        }
    }
}
