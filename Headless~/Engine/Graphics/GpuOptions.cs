using System;
using System.Collections.Generic;
using System.IO;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>What the host decides about the GPU before its first use. Set by the host, read when the device is made.</summary>
    static class GpuOptions
    {
        /// <summary>The environment variable that picks a device: a number, or a part of its name.</summary>
        internal const string DeviceVariable = "ANATOMYCARVE_GPU";

        /// <summary>Whether the Khronos validation layer watches every call; its messages become errors in the log.</summary>
        internal static bool Validation { get; set; }

        /// <summary>Whether to warn of what Unity lets pass silently: unknown property names, ints set to floats and the like.</summary>
        internal static bool Strict { get; set; } = true;

        /// <summary>Whether new GPU memory is filled with a pattern that is no number, because Unity promises nothing about it.</summary>
        internal static bool FillNewMemory { get; set; } = true;

        /// <summary>Formats that this device is to pretend not to know at all.</summary>
        internal static ISet<GraphicsFormat> DeniedFormats { get; } = new HashSet<GraphicsFormat>();

        /// <summary>The graphics API that the device is to pretend to be, to scripts and to pragmas of shaders; Vulkan draws for all of them.</summary>
        internal static GraphicsDeviceType DeviceType { get; set; } = GraphicsDeviceType.Vulkan;

        /// <summary>Whether it is to pretend to run compute shaders.</summary>
        internal static bool ComputeShaders { get; set; } = true;

        /// <summary>Through which compilers kernels go. What cameras draw goes through glslang.</summary>
        internal static KernelRoute KernelRoute { get; set; }

        /// <summary>The folder that "Packages/com.anatomycarve.vr/" means in an #include. Null: such includes fail.</summary>
        internal static string PackageRoot { get; set; }

        /// <summary>Where compiled kernels are kept; null for the user's cache folder.</summary>
        internal static string CacheFolder { get; set; }

        /// <summary>The cache folder with the default filled in.</summary>
        internal static string EffectiveCacheFolder => string.IsNullOrEmpty(CacheFolder) ? UserCacheFolder : CacheFolder;

        /// <summary>The user's cache folder, where the commands of Headless~ keep what they install for themselves.</summary>
        internal static string UserCacheFolder
        {
            get
            {
                var cache = Environment.GetEnvironmentVariable("XDG_CACHE_HOME");
                if (string.IsNullOrEmpty(cache))
                {
                    var home = Environment.GetEnvironmentVariable("HOME");
                    cache = string.IsNullOrEmpty(home) ? Path.GetTempPath() : Path.Combine(home, ".cache");
                }
                return Path.Combine(cache, "anatomycarve");
            }
        }
    }
}
