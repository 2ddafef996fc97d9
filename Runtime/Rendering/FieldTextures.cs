using System;
using System.Collections.Generic;
using AnatomyCarve.Carving;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace AnatomyCarve
{
    /// <summary>
    /// What the kernels write of a volume: 3D textures of opacity, anti-aliased opacity and normals, in one of the layouts of <c>Shaders/VolumeFields.hlsl</c>, of a box
    /// of voxels beyond which there is nothing.
    /// </summary>
    sealed class FieldTextures : IDisposable
    {
        public FieldTextures(VoxelBox box, TextureLayout layout)
        {
            Box = box;
            try
            {
                Opacity = Create("opacity", VolumeTextureForm.Opacity(layout));
                OpacityAA = Create("anti-aliased opacity", VolumeTextureForm.Opacity(layout));
                Normals = Create("normals", VolumeTextureForm.Normals(layout));
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>The voxels that are stored.</summary>
        public VoxelBox Box { get; }

        public RenderTexture Opacity { get; }

        public RenderTexture OpacityAA { get; }

        public RenderTexture Normals { get; }

        /// <summary>Whether all textures still exist; scripts and scene changes can destroy them.</summary>
        public bool Exist => Opacity != null && OpacityAA != null && Normals != null;

        /// <summary>Makes the contents of those that the device has lost; true where something has to be computed anew.</summary>
        public bool Restore() => Restore(Opacity) | Restore(OpacityAA) | Restore(Normals);

        public void AddSizes(List<ResourceSize> sizes)
        {
            sizes.Add(SizeOf(Opacity));
            sizes.Add(SizeOf(OpacityAA));
            sizes.Add(SizeOf(Normals));
        }

        public void Dispose()
        {
            GpuObjects.Destroy(Opacity);
            GpuObjects.Destroy(OpacityAA);
            GpuObjects.Destroy(Normals);
        }

        /// <summary>Lets go of the memory now, where destroyed textures keep it until the frame ends. Nothing may draw with them any more.</summary>
        public void DisposeAtOnce()
        {
            foreach (RenderTexture texture in new[] { Opacity, OpacityAA, Normals })
                if (texture != null)
                    texture.Release();
            Dispose();
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

        RenderTexture Create(string name, VolumeTextureForm form)
        {
            var descriptor = new RenderTextureDescriptor(Box.MaxI - Box.MinI + 1, Box.MaxJ - Box.MinJ + 1, form.Format, 0)
            {
                dimension = TextureDimension.Tex3D,
                volumeDepth = form.Depth(Box.MaxK - Box.MinK + 1),
                enableRandomWrite = true,
                msaaSamples = 1,
            };
            return GpuObjects.CreateWritable(descriptor, "AnatomyCarve " + name, form.VoxelsPerTexel == 1 ? FilterMode.Bilinear : FilterMode.Point);
        }
    }
}
