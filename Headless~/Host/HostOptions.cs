using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace AnatomyCarve.Headless
{
    /// <summary>How a host starts.</summary>
    public sealed class HostOptions
    {
        /// <summary>The folder of package.json. Null: the nearest one above the program.</summary>
        public string PackageRoot { get; set; }

        /// <summary>Further folders with assets, such as one below Samples~, which the package itself hides.</summary>
        public IReadOnlyList<string> ExtraRoots { get; set; } = Array.Empty<string>();

        /// <summary>
        /// False for the Editor in edit mode: only scripts marked [ExecuteAlways] or [ExecuteInEditMode] get messages, OnValidate is sent, Destroy is refused.
        /// </summary>
        public bool PlayMode { get; set; } = true;

        /// <summary>The scenes that scripts may load by name or index: paths as <see cref="UnityHost.LoadScene"/> takes them.</summary>
        public IReadOnlyList<string> Scenes { get; set; } = Array.Empty<string>();

        /// <summary>Packages that are installed besides those that package.json declares and those that these need, such as com.unity.ugui.</summary>
        public IReadOnlyList<string> Packages { get; set; } = Array.Empty<string>();

        /// <summary>
        /// Where StreamingAssets are: a folder, or an address as on Android, jar:file:///path/base.apk!/assets, in which the .apk is a zip file. Null:
        /// a folder in the data folder.
        /// </summary>
        public string StreamingAssets { get; set; }

        /// <summary>Whether Vulkan's validation layer watches; its messages are errors in the log. Default: whether ANATOMYCARVE_VALIDATION is 1.</summary>
        public bool Validation { get; set; } = Environment.GetEnvironmentVariable("ANATOMYCARVE_VALIDATION") == "1";

        /// <summary>Formats that the device is to pretend not to know.</summary>
        public IReadOnlyList<GraphicsFormat> DeniedFormats { get; set; } = Array.Empty<GraphicsFormat>();

        /// <summary>The graphics API that the device pretends to be, to scripts and to pragmas of shaders. Vulkan draws for all of them.</summary>
        public GraphicsDeviceType GraphicsDeviceType { get; set; } = GraphicsDeviceType.Vulkan;

        /// <summary>
        /// Through which compilers kernels go; what cameras draw always goes through glslang. Default: FXC if ANATOMYCARVE_KERNEL_COMPILER is fxc.
        /// </summary>
        public KernelCompiler KernelCompiler { get; set; } =
            Environment.GetEnvironmentVariable("ANATOMYCARVE_KERNEL_COMPILER") == "fxc" ? KernelCompiler.Fxc : KernelCompiler.Glslang;

        /// <summary>Whether the device says that it runs compute shaders.</summary>
        public bool ComputeShaders { get; set; } = true;

        /// <summary>Where compiled kernels are kept between runs. Null: the user's cache folder.</summary>
        public string CacheFolder { get; set; }

        /// <summary>The folder of Application.persistentDataPath and the like. Null: one in the temporary folder.</summary>
        public string DataFolder { get; set; }

        /// <summary>The window's size in pixels, which cameras without a target have.</summary>
        public int ScreenWidth { get; set; } = 1280;

        /// <inheritdoc cref="ScreenWidth"/>
        public int ScreenHeight { get; set; } = 720;

        /// <summary>The project's colour space.</summary>
        public ColorSpace ColorSpace { get; set; } = ColorSpace.Linear;

        /// <summary>The project's render pipeline.</summary>
        public HostPipeline RenderPipeline { get; set; } = HostPipeline.BuiltIn;

        /// <summary>Whether URP's cameras make a depth texture without being asked, as its asset's option says.</summary>
        public bool UniversalDepthTexture { get; set; }

        /// <summary>Whether cameras without a target draw into a headset, and how.</summary>
        public HostStereo Stereo { get; set; } = HostStereo.Mono;

        /// <summary>That headset.</summary>
        public HostHeadset Headset { get; set; } = new();

        /// <summary>Receives every message: severity, text, stack trace; on the thread that logs. Null: warnings and worse go to standard error.</summary>
        public Action<LogType, string, string> Log { get; set; }
    }
}
