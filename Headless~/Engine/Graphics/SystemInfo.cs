using System;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>What the machine can do. Limits that Unity has by itself are Unity's, even where the driver allows more.</summary>
    public sealed partial class SystemInfo
    {
        const int UnityMaxTexture3DSize = 2048;
        const int UnityMaxTextureSize = 16384;
        const int UnityMaxArraySlices = 2048;
        const int MegaByte = 1 << 20;

        public const string unsupportedIdentifier = "n/a";

        public static string graphicsDeviceName => Device.Name;

        public static GraphicsDeviceType graphicsDeviceType => GpuOptions.DeviceType;

        public static string graphicsDeviceVersion
        {
            get
            {
                var v = Device.Properties.apiVersion;
                return FormattableString.Invariant($"Vulkan {v >> 22}.{(v >> 12) & 0x3FF}.{v & 0xFFF} [driver 0x{Device.Properties.driverVersion:x8}]");
            }
        }

        public static int graphicsDeviceID => (int)Device.Properties.deviceID;

        public static int graphicsDeviceVendorID => (int)Device.Properties.vendorID;

        /// <summary>MiB.</summary>
        public static int graphicsMemorySize => (int)Math.Min(int.MaxValue, Device.LocalMemory / MegaByte);

        public static int graphicsShaderLevel => 50;

        public static bool graphicsMultiThreaded => false;

        public static bool graphicsUVStartsAtTop => true;

        public static bool usesReversedZBuffer => true;

        public static bool supportsComputeShaders => GpuOptions.ComputeShaders && GpuOptions.DeviceType != GraphicsDeviceType.Null;

        public static bool supportsAsyncGPUReadback => true;

        public static bool supportsAsyncCompute => false;

        public static bool supports3DTextures => true;

        public static bool supports3DRenderTextures => true;

        public static bool supports2DArrayTextures => true;

        public static bool supportsSetConstantBuffer => true;

        public static bool supportsIndirectArgumentsBuffer => true;

        public static bool supportsInstancing => true;

        public static bool supports32bitsIndexBuffer => true;

        /// <summary>Whether one draw can go to both eyes by views.</summary>
        public static bool supportsMultiview => Device.Abilities.HasMultiview;

        /// <summary>How many render targets a shader can write at once.</summary>
        public static int supportedRenderTargetCount => (int)Math.Min(8, Device.Properties.limits.maxColorAttachments);

        public static CopyTextureSupport copyTextureSupport =>
            CopyTextureSupport.Basic | CopyTextureSupport.Copy3D | CopyTextureSupport.DifferentTypes | CopyTextureSupport.TextureToRT
                | CopyTextureSupport.RTToTexture;

        public static int maxTexture3DSize => Math.Min(UnityMaxTexture3DSize, (int)Device.Properties.limits.maxImageDimension3D);

        public static int maxTextureSize => Math.Min(UnityMaxTextureSize, (int)Device.Properties.limits.maxImageDimension2D);

        public static int maxTextureArraySlices => Math.Min(UnityMaxArraySlices, (int)Device.Properties.limits.maxImageArrayLayers);

        /// <summary>Bytes.</summary>
        public static long maxGraphicsBufferSize => Math.Min(int.MaxValue, (long)Device.Properties.limits.maxStorageBufferRange);

        /// <summary>Bytes.</summary>
        public static int maxConstantBufferSize => (int)Math.Min(65536, Device.Properties.limits.maxUniformBufferRange);

        /// <summary>Offsets in SetConstantBuffer are multiples of this.</summary>
        public static int constantBufferOffsetAlignment => (int)Device.Properties.limits.minUniformBufferOffsetAlignment;

        public static int maxComputeBufferInputsCompute => (int)Math.Min(64, Device.Properties.limits.maxPerStageDescriptorStorageBuffers);

        public static int maxComputeWorkGroupSize => (int)Math.Min(1024, Device.Properties.limits.maxComputeWorkGroupInvocations);

        public static unsafe int maxComputeWorkGroupSizeX
        {
            get { var l = Device.Properties.limits; return (int)Math.Min(1024, l.maxComputeWorkGroupSize[0]); }
        }

        public static unsafe int maxComputeWorkGroupSizeY
        {
            get { var l = Device.Properties.limits; return (int)Math.Min(1024, l.maxComputeWorkGroupSize[1]); }
        }

        public static unsafe int maxComputeWorkGroupSizeZ
        {
            get { var l = Device.Properties.limits; return (int)Math.Min(64, l.maxComputeWorkGroupSize[2]); }
        }

        public static int computeSubGroupSize => Device.SubgroupSize;

        /// <summary>Direct3D 11's eight, which is what portable kernels keep to.</summary>
        public static int supportedRandomWriteTargetCount => 8;

        static VulkanDevice Device
        {
            get
            {
                MainThread.Check("SystemInfo");
                return Gpu.Context.Device;
            }
        }

        /// <summary>Whether a format can be used in all the ways given. Formats that the host was told to deny are not supported at all.</summary>
        public static bool IsFormatSupported(GraphicsFormat format, GraphicsFormatUsage usage)
        {
            var info = FormatInfo.Of(format);
            // Three channels are no texture format on GPUs that matter.
            if (info == null || info.Channels == 3 || GpuOptions.DeniedFormats.Contains(format))
                return false;
            var limits = Device.Properties.limits;
            var samples = info.IsDepth ? limits.framebufferDepthSampleCounts : limits.framebufferColorSampleCounts;
            return FormatSupport.Covers(Device.FormatFeatures(info.Vulkan), info, usage, samples);
        }

        public static bool SupportsTextureFormat(TextureFormat format) => IsFormatSupported(FormatTables.Of(format, false), GraphicsFormatUsage.Sample);

        public static bool SupportsRenderTextureFormat(RenderTextureFormat format) =>
            IsFormatSupported(format == RenderTextureFormat.Depth ? GraphicsFormat.D32_SFloat : FormatTables.Of(format, false), GraphicsFormatUsage.Render);

        /// <summary>The number of samples per pixel that such a texture really gets: as asked, or the next lower one that the device has.</summary>
        public static int GetRenderTextureSupportedMSAASampleCount(RenderTextureDescriptor desc)
        {
            var limits = Device.Properties.limits;
            var counts = limits.framebufferColorSampleCounts & limits.framebufferDepthSampleCounts;
            var samples = Math.Max(1, desc.msaaSamples);
            while (samples > 1 && (counts & (uint)samples) == 0)
                samples /= 2;
            return samples;
        }

        public static bool SupportsRandomWriteOnRenderTextureFormat(RenderTextureFormat format) =>
            IsFormatSupported(FormatTables.Of(format, false), GraphicsFormatUsage.LoadStore);

        /// <summary>The format of a texture that is asked for by the older enum: linear where the device has no sRGB twin.</summary>
        internal static GraphicsFormat TextureFormatOf(TextureFormat format, bool srgb)
        {
            var found = FormatTables.Of(format, srgb);
            return srgb && !IsFormatSupported(found, GraphicsFormatUsage.Sample) ? FormatTables.Of(format, false) : found;
        }

        /// <summary>The format itself, or one with more channels or bits that can do it, or None.</summary>
        public static GraphicsFormat GetCompatibleFormat(GraphicsFormat format, GraphicsFormatUsage usage)
        {
            for (var f = format; f != GraphicsFormat.None; f = FormatSupport.Wider(f))
                if (IsFormatSupported(f, usage))
                    return f;
            return GraphicsFormat.None;
        }

        /// <summary>The platform's choice: 8 bits for LDR (sRGB in linear projects), half floats for HDR.</summary>
        public static GraphicsFormat GetGraphicsFormat(DefaultFormat format) => format switch
        {
            DefaultFormat.LDR => ColorSpaces.IsLinear ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm,
            DefaultFormat.HDR => GraphicsFormat.R16G16B16A16_SFloat,
            DefaultFormat.DepthStencil => GraphicsFormatUtility.GetDepthStencilFormat(24, 8),
            _ => GraphicsFormat.None,
        };
    }
}
