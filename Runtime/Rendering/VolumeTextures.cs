using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace AnatomyCarve
{
    /// <summary>
    /// A volume's 3D textures (layout "compact"): intensity R16_UNorm and labels R8_UInt (R16_UInt above 255 segments), uploaded once;
    /// opacity R8_UNorm, anti-aliased opacity R8_UNorm and normals R8G8_UNorm, written by the kernels.
    /// </summary>
    sealed class VolumeTextures : IDisposable
    {
        /// <summary>Up to this many segments have their labels in 8 bits.</summary>
        public const int MaxSegmentsIn8Bits = 255;

        readonly VolumeGeometry geometry;

        public VolumeTextures(SegmentedVolume volume)
        {
            geometry = volume.Geometry;
            try
            {
                Intensity = Create("intensity", GraphicsFormat.R16_UNorm);
                Intensity.SetPixelData(volume.Intensity.Codes, 0);
                Intensity.Apply(false, true);
                bool small = volume.Segments.Count <= MaxSegmentsIn8Bits;
                Labels = Create("labels", small ? GraphicsFormat.R8_UInt : GraphicsFormat.R16_UInt);
                if (small)
                    LabelBytes.Narrow(volume.Labels.Indices, Labels.GetPixelData<byte>(0).AsSpan());
                else
                    Labels.SetPixelData(volume.Labels.Indices, 0);
                Labels.Apply(false, true);
                Opacity = CreateWritable("opacity", GraphicsFormat.R8_UNorm);
                OpacityAA = CreateWritable("anti-aliased opacity", GraphicsFormat.R8_UNorm);
                Normals = CreateWritable("normals", GraphicsFormat.R8G8_UNorm);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        public Texture3D Intensity { get; }

        public Texture3D Labels { get; }

        public RenderTexture Opacity { get; }

        public RenderTexture OpacityAA { get; }

        public RenderTexture Normals { get; }

        /// <summary>Whether all textures still exist; scripts and scene changes can destroy them.</summary>
        public bool Exist => Intensity != null && Labels != null && Opacity != null && OpacityAA != null && Normals != null;

        /// <summary>Makes the contents of those that the device has lost; true where something has to be computed anew.</summary>
        public bool Restore() => Restore(Opacity) | Restore(OpacityAA) | Restore(Normals);

        public void AddSizes(List<ResourceSize> sizes)
        {
            long voxels = geometry.VoxelCount;
            sizes.Add(new ResourceSize(Intensity.name, 2 * voxels));
            sizes.Add(new ResourceSize(Labels.name, (Labels.graphicsFormat == GraphicsFormat.R8_UInt ? 1 : 2) * voxels));
            sizes.Add(new ResourceSize(Opacity.name, voxels));
            sizes.Add(new ResourceSize(OpacityAA.name, voxels));
            sizes.Add(new ResourceSize(Normals.name, 2 * voxels));
        }

        public void Dispose()
        {
            GpuObjects.Destroy(Intensity);
            GpuObjects.Destroy(Labels);
            GpuObjects.Destroy(Opacity);
            GpuObjects.Destroy(OpacityAA);
            GpuObjects.Destroy(Normals);
        }

        static bool Restore(RenderTexture texture)
        {
            if (texture.IsCreated())
                return false;
            GpuObjects.CreateOrThrow(texture);
            return true;
        }

        Texture3D Create(string name, GraphicsFormat format)
        {
            const TextureCreationFlags flags = TextureCreationFlags.DontInitializePixels | TextureCreationFlags.DontUploadUponCreate;
            var texture = new Texture3D(geometry.SizeI, geometry.SizeJ, geometry.SizeK, format, flags);
            if (texture == null)
                throw new AnatomyCarveException(
                    $"The device could not make the volume's {name} texture ({geometry.SizeI} x {geometry.SizeJ} x {geometry.SizeK}, {format}).");
            texture.name = "AnatomyCarve " + name;
            texture.filterMode = FilterMode.Point;
            texture.wrapMode = TextureWrapMode.Clamp;
            texture.hideFlags = HideFlags.HideAndDontSave;
            return texture;
        }

        RenderTexture CreateWritable(string name, GraphicsFormat format)
        {
            var descriptor = new RenderTextureDescriptor(geometry.SizeI, geometry.SizeJ, format, 0)
            {
                dimension = TextureDimension.Tex3D,
                volumeDepth = geometry.SizeK,
                enableRandomWrite = true,
                msaaSamples = 1,
            };
            return GpuObjects.CreateWritable(descriptor, "AnatomyCarve " + name, FilterMode.Bilinear);
        }
    }
}
