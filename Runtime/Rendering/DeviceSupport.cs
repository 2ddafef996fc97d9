using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace AnatomyCarve
{
    /// <summary>What the graphics device must be able to do, and whether it is.</summary>
    static class DeviceSupport
    {
        /// <summary>Bricks along an axis are packed into 10 bits each.</summary>
        public const int MaxVolumeSize = BrickGrid.MaxBricksPerAxis * BrickGrid.BrickSize;

        /// <summary>Of the largest textures: intensities and normals.</summary>
        const long BytesPerVoxel = 2;

        /// <summary>What a texture needs that kernels write: LoadStore to be written, Render because the constructor of RenderTexture asks for it.</summary>
        const GraphicsFormatUsage Written = GraphicsFormatUsage.LoadStore | GraphicsFormatUsage.Render;

        static readonly (GraphicsFormat format, GraphicsFormatUsage usage, string what)[] Needed =
        {
            (GraphicsFormat.R16_UNorm, GraphicsFormatUsage.Sample, "intensities"),
            (GraphicsFormat.R8_UInt, GraphicsFormatUsage.Sample, "labels"),
            (GraphicsFormat.R8_UNorm, Written | GraphicsFormatUsage.Sample | GraphicsFormatUsage.Linear, "opacity"),
            (GraphicsFormat.R8G8_UNorm, Written | GraphicsFormatUsage.Sample, "normals"),
            (GraphicsFormat.R32_SFloat, Written | GraphicsFormatUsage.Sample, "depth and the transfer function"),
            (GraphicsFormat.R32_UInt, Written, "segments of a picture"),
            (GraphicsFormat.R16G16B16A16_SFloat, Written | GraphicsFormatUsage.Sample | GraphicsFormatUsage.Linear, "colour"),
            (GraphicsFormat.R32G32B32A32_SFloat, GraphicsFormatUsage.Sample, "segment colours"),
        };

        /// <summary>Why a volume cannot be shown on this device, as a sentence; null where it can.</summary>
        public static string Missing(VolumeGeometry geometry, int segments)
        {
            if (SystemInfo.graphicsDeviceType == GraphicsDeviceType.Null)
                return "There is no graphics device (the process runs with -nographics).";
            if (SystemInfo.graphicsDeviceType == GraphicsDeviceType.OpenGLES3)
                return "OpenGL ES is not supported: it can write few texture formats. Use Vulkan.";
            if (!SystemInfo.supportsComputeShaders)
                return $"{SystemInfo.graphicsDeviceType} on {SystemInfo.graphicsDeviceName} has no compute shaders.";
            foreach ((GraphicsFormat format, GraphicsFormatUsage usage, string what) in Needed)
                if (!SystemInfo.IsFormatSupported(format, usage))
                    return $"{SystemInfo.graphicsDeviceType} on {SystemInfo.graphicsDeviceName} does not support {format} for {usage} ({what}).";
            if (segments > VolumeTextures.MaxSegmentsIn8Bits && !SystemInfo.IsFormatSupported(GraphicsFormat.R16_UInt, GraphicsFormatUsage.Sample))
                return $"{SystemInfo.graphicsDeviceType} on {SystemInfo.graphicsDeviceName} does not support R16_UInt, which {segments} segments need.";
            int largest = Mathf.Min(SystemInfo.maxTexture3DSize, MaxVolumeSize);
            if (geometry.SizeI > largest || geometry.SizeJ > largest || geometry.SizeK > largest)
                return $"The volume has {geometry.SizeI} x {geometry.SizeJ} x {geometry.SizeK} voxels; "
                    + $"{SystemInfo.graphicsDeviceName} allows {largest} along an axis.";
            if (BytesPerVoxel * geometry.VoxelCount > int.MaxValue)
                return $"The volume has {geometry.SizeI} x {geometry.SizeJ} x {geometry.SizeK} voxels; "
                    + $"a texture holds {int.MaxValue / BytesPerVoxel} of them at most.";
            return null;
        }
    }
}
