using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve
{
    /// <summary>
    /// A volume's own 3D textures: intensity R16_UInt and labels R8_UInt (R16_UInt above 255 segments), uploaded once.
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
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        public Texture3D Intensity { get; }

        public Texture3D Labels { get; }

        /// <summary>Whether both still exist; scripts and scene changes can destroy them.</summary>
        public bool Exist => Intensity != null && Labels != null;

        public void AddSizes(List<ResourceSize> sizes)
        {
            long voxels = geometry.VoxelCount;
            sizes.Add(new ResourceSize(Intensity.name, 2 * voxels));
            sizes.Add(new ResourceSize(Labels.name, (Labels.graphicsFormat == GraphicsFormat.R8_UInt ? 1 : 2) * voxels));
        }

        public void Dispose()
        {
            GpuObjects.Destroy(Intensity);
            GpuObjects.Destroy(Labels);
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
    }
}
