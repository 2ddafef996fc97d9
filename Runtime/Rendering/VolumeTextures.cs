using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace AnatomyCarve
{
    /// <summary>
    /// A volume's 3D textures: intensity R16_UInt and labels R8_UInt (R16_UInt above 255 segments), uploaded once; opacity, anti-aliased opacity and
    /// normals, written by the kernels, in one of the layouts of <c>Shaders/VolumeFields.hlsl</c>.
    /// </summary>
    sealed class VolumeTextures : IDisposable
    {
        /// <summary>Up to this many segments have their labels in 8 bits.</summary>
        public const int MaxSegmentsIn8Bits = 255;

        readonly VolumeGeometry geometry;

        public VolumeTextures(SegmentedVolume volume, TextureLayout layout)
        {
            geometry = volume.Geometry;
            try
            {
                Intensity = Create("intensity", VolumeTextureForm.Intensity);
                Intensity.SetPixelData(volume.Intensity.Codes, 0);
                Intensity.Apply(false, true);
                bool small = DeviceSupport.LabelsIn8Bits(volume.Segments.Count);
                Labels = Create("labels", VolumeTextureForm.Labels(small));
                if (small)
                    LabelBytes.Narrow(volume.Labels.Indices, Labels.GetPixelData<byte>(0).AsSpan());
                else
                    Labels.SetPixelData(volume.Labels.Indices, 0);
                Labels.Apply(false, true);
                Opacity = CreateWritable("opacity", VolumeTextureForm.Opacity(layout));
                OpacityAA = CreateWritable("anti-aliased opacity", VolumeTextureForm.Opacity(layout));
                Normals = CreateWritable("normals", VolumeTextureForm.Normals(layout));
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
            sizes.Add(SizeOf(Opacity));
            sizes.Add(SizeOf(OpacityAA));
            sizes.Add(SizeOf(Normals));
        }

        public void Dispose()
        {
            GpuObjects.Destroy(Intensity);
            GpuObjects.Destroy(Labels);
            GpuObjects.Destroy(Opacity);
            GpuObjects.Destroy(OpacityAA);
            GpuObjects.Destroy(Normals);
        }

        static ResourceSize SizeOf(RenderTexture texture)
        {
            int bytes = texture.graphicsFormat == GraphicsFormat.R8_UNorm ? 1 : texture.graphicsFormat == GraphicsFormat.R8G8_UNorm ? 2 : 4;
            return new ResourceSize(texture.name, (long)bytes * texture.width * texture.height * texture.volumeDepth);
        }

        static bool Restore(RenderTexture texture)
        {
            if (texture.IsCreated())
                return false;
            GpuObjects.CreateOrThrow(texture);
            return true;
        }

        Texture3D Create(string name, VolumeTextureForm form)
        {
            GraphicsFormat format = form.Format;
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

        RenderTexture CreateWritable(string name, VolumeTextureForm form)
        {
            var descriptor = new RenderTextureDescriptor(geometry.SizeI, geometry.SizeJ, form.Format, 0)
            {
                dimension = TextureDimension.Tex3D,
                volumeDepth = form.Depth(geometry.SizeK),
                enableRandomWrite = true,
                msaaSamples = 1,
            };
            return GpuObjects.CreateWritable(descriptor, "AnatomyCarve " + name, form.VoxelsPerTexel == 1 ? FilterMode.Bilinear : FilterMode.Point);
        }
    }
}
