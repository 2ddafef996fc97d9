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

        /// <summary>The most voxels that a volume may have: textures end at 2 GiB, and the largest (intensities, normals) take two bytes per voxel.</summary>
        public const long MaxVoxels = int.MaxValue / 2;

        /// <summary>What a texture needs that kernels write: LoadStore to be written, Render because the constructor of RenderTexture asks for it.</summary>
        const GraphicsFormatUsage Written = GraphicsFormatUsage.LoadStore | GraphicsFormatUsage.Render;

        static readonly (GraphicsFormat format, GraphicsFormatUsage usage, string what)[] OfEveryVolume =
        {
            (GraphicsFormat.R16_UInt, GraphicsFormatUsage.Sample, "intensities"),
            (GraphicsFormat.R32_SFloat, GraphicsFormatUsage.Sample, "the transfer function"),
            (GraphicsFormat.R32G32B32A32_SFloat, GraphicsFormatUsage.Sample, "segment colours"),
        };

        static readonly (GraphicsFormat format, GraphicsFormatUsage usage, string what)[] OfCompactVolumes =
        {
            (GraphicsFormat.R8_UNorm, Written | GraphicsFormatUsage.Sample | GraphicsFormatUsage.Linear, "opacity"),
            (GraphicsFormat.R8G8_UNorm, Written | GraphicsFormatUsage.Sample, "normals"),
        };

        static readonly (GraphicsFormat format, GraphicsFormatUsage usage, string what)[] OfPortableVolumes =
        {
            (GraphicsFormat.R32_UInt, Written | GraphicsFormatUsage.Sample, "opacity and normals"),
        };

        static readonly (GraphicsFormat format, GraphicsFormatUsage usage, string what)[] OfPictures =
        {
            (GraphicsFormat.R16G16B16A16_SFloat, Written | GraphicsFormatUsage.Sample | GraphicsFormatUsage.Linear, "a picture's colour"),
            (GraphicsFormat.R32_SFloat, Written | GraphicsFormatUsage.Sample, "a picture's depth"),
            (GraphicsFormat.R32_UInt, Written, "a picture's segments"),
        };

        /// <summary>The most voxels along an axis.</summary>
        public static int LargestSide => Mathf.Min(SystemInfo.maxTexture3DSize, MaxVolumeSize);

        /// <summary>Why a volume cannot be on this device, as a sentence; null where it can.</summary>
        public static string Missing(VolumeGeometry geometry, TextureLayout layout)
        {
            string device = MissingAtAll() ?? MissingFormat(OfEveryVolume)
                ?? MissingFormat(layout == TextureLayout.Portable ? OfPortableVolumes : OfCompactVolumes);
            if (device != null)
                return device;
            int largest = LargestSide;
            if (geometry.SizeI > largest || geometry.SizeJ > largest || geometry.SizeK > largest)
                return $"The volume has {geometry.SizeI} x {geometry.SizeJ} x {geometry.SizeK} voxels; "
                    + $"{SystemInfo.graphicsDeviceName} allows {largest} along an axis.";
            if (geometry.VoxelCount > MaxVoxels)
                return $"The volume has {geometry.SizeI} x {geometry.SizeJ} x {geometry.SizeK} voxels; "
                    + $"a texture holds {MaxVoxels} of them at most.";
            return null;
        }

        /// <summary>Why no picture can be rendered into textures on this device, as a sentence; null where it can.</summary>
        public static string MissingForPictures() => MissingFormat(OfPictures);

        /// <summary>The layout that was asked for, or the one that the device can write.</summary>
        public static TextureLayout Choose(TextureLayout wanted)
        {
            if (wanted != TextureLayout.Automatic)
                return wanted;
            return MissingFormat(OfCompactVolumes) == null ? TextureLayout.Compact : TextureLayout.Portable;
        }

        /// <summary>Whether labels take 8 bits; 16-bit labels serve any number of segments.</summary>
        public static bool LabelsIn8Bits(int segments) =>
            segments <= VolumeTextures.MaxSegmentsIn8Bits && SystemInfo.IsFormatSupported(GraphicsFormat.R8_UInt, GraphicsFormatUsage.Sample);

        /// <summary>Why no volume can be on this device, as a sentence; null where volumes can.</summary>
        public static string MissingAtAll()
        {
            if (Application.platform == RuntimePlatform.WebGLPlayer)
                return "Web players are not supported: they have no threads to read volumes on. Use a desktop or Android player.";
            if (SystemInfo.graphicsDeviceType == GraphicsDeviceType.Null)
                return "There is no graphics device (the process runs with -nographics).";
            if (SystemInfo.graphicsDeviceType == GraphicsDeviceType.OpenGLES3)
                return "OpenGL ES is not supported: it can write few texture formats. Use Vulkan (Project Settings > Player > Graphics APIs).";
            if (SystemInfo.graphicsDeviceType == GraphicsDeviceType.OpenGLCore)
                return "OpenGL is not supported: the shaders are not made for it. Use Vulkan, Direct3D or Metal (Project Settings > Player > Graphics APIs).";
            if (!SystemInfo.supportsComputeShaders)
                return $"{SystemInfo.graphicsDeviceType} on {SystemInfo.graphicsDeviceName} has no compute shaders.";
            return null;
        }

        static string MissingFormat((GraphicsFormat format, GraphicsFormatUsage usage, string what)[] needed)
        {
            foreach ((GraphicsFormat format, GraphicsFormatUsage usage, string what) in needed)
                if (!SystemInfo.IsFormatSupported(format, usage))
                    return $"{SystemInfo.graphicsDeviceType} on {SystemInfo.graphicsDeviceName} does not support {format} for {usage} ({what}).";
            return null;
        }
    }
}
