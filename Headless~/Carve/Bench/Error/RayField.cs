using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>What the kernel Raymarch wrote, in 32-bit floats; row 0 is the bottom row.</summary>
    sealed record MarchedRays(Vector4[] Colors, float[] DepthsMm);

    /// <summary>A field of opacities in R32, white, with normals: what the ray sum is measured on, without the eight bits that the package stores.</summary>
    sealed class RayField
    {
        public const float Ambient = 0.25f, Diffuse = 0.75f, Specular = 0.2f, Shininess = 24f;

        public RayField(VolumeGeometry geometry)
        {
            Geometry = geometry;
            Opacities = new float[geometry.VoxelCount];
            NormalCodes = new byte[2 * geometry.VoxelCount];
        }

        /// <summary>Its centre is the origin of LPS.</summary>
        public VolumeGeometry Geometry { get; }

        /// <summary>Per reference length, i fastest.</summary>
        public float[] Opacities { get; }

        /// <summary>Octahedral, two per voxel; 0, 0 = none.</summary>
        public byte[] NormalCodes { get; }

        /// <summary>Marches rays through the field.</summary>
        /// <param name="rays">in LPS mm</param>
        /// <param name="step">in reference lengths</param>
        /// <param name="toLight">unit vector, LPS</param>
        /// <param name="opaqueAlpha">where rays end</param>
        /// <param name="visibleAlpha">where a segment counts as seen</param>
        public MarchedRays March(PictureRays rays, double step, VectorMm toLight, double opaqueAlpha = 1, double visibleAlpha = 0.5)
        {
            using var kernel = LoneKernel.Raymarch(Geometry);
            kernel.Set("_CarveCounts", 0, 0, 1);
            kernel.SetInts("_PictureSize", rays.Width, rays.Height, 0, 0);
            kernel.Set("_RayOrigin", rays.Origin - Geometry.CentreLps);
            kernel.Set("_RayOriginDx", rays.OriginDx);
            kernel.Set("_RayOriginDy", rays.OriginDy);
            kernel.Set("_RayDirection", rays.Direction);
            kernel.Set("_RayDirectionDx", rays.DirectionDx);
            kernel.Set("_RayDirectionDy", rays.DirectionDy);
            kernel.Set("_RayRange", (float)rays.NearT, (float)Math.Min(rays.FarT, 1e30));
            kernel.Set("_March", (float)step, (float)opaqueAlpha, (float)visibleAlpha, 1);
            kernel.Set("_LightDirection", toLight);
            kernel.Set("_LightColor", 1, 1, 1);
            kernel.Set("_Shading", Ambient, Diffuse, Specular, Shininess);
            kernel.SetVolume("_Labels", GraphicsFormat.R8_UInt, new byte[Geometry.VoxelCount]);
            kernel.SetVolume("_Opacity", GraphicsFormat.R32_SFloat, Opacities);
            kernel.SetVolume("_OpacityAA", GraphicsFormat.R32_SFloat, Opacities);
            kernel.SetVolume("_Normals", GraphicsFormat.R8G8_UNorm, NormalCodes);
            kernel.SetPicture("_SegmentColors", GraphicsFormat.R32G32B32A32_SFloat, 1, 1, new[] { Vector4.one });
            kernel.SetPicture("_SceneDepth", GraphicsFormat.R32_SFloat, 1, 1, new float[1]);
            var colors = kernel.PictureTarget("_ColorOut", GraphicsFormat.R32G32B32A32_SFloat, rays.Width, rays.Height);
            var depths = kernel.PictureTarget("_DepthOut", GraphicsFormat.R32_SFloat, rays.Width, rays.Height);
            kernel.PictureTarget("_SegmentOut", GraphicsFormat.R32_UInt, rays.Width, rays.Height);
            kernel.RunOverPicture(rays.Width, rays.Height);
            return new MarchedRays(Texels.Read<Vector4>(colors), Texels.Read<float>(depths));
        }
    }
}
