using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Headless
{
    /// <summary>How a host starts.</summary>
    public sealed class HostOptions
    {
        /// <summary>The folder of package.json. Null: the nearest one above the program.</summary>
        public string PackageRoot { get; set; }

        /// <summary>Further folders with assets, such as one below Samples~, which the package itself hides.</summary>
        public IReadOnlyList<string> ExtraRoots { get; set; } = Array.Empty<string>();

        /// <summary>Whether Vulkan's validation layer watches; its messages are errors in the log. Default: whether ANATOMYCARVE_VALIDATION is 1.</summary>
        public bool Validation { get; set; } = Environment.GetEnvironmentVariable("ANATOMYCARVE_VALIDATION") == "1";

        /// <summary>Formats that the device is to pretend not to know.</summary>
        public IReadOnlyList<GraphicsFormat> DeniedFormats { get; set; } = Array.Empty<GraphicsFormat>();

        /// <summary>Where compiled kernels are kept between runs. Null: the user's cache folder.</summary>
        public string CacheFolder { get; set; }

        /// <summary>The folder of Application.persistentDataPath and the like. Null: one in the temporary folder.</summary>
        public string DataFolder { get; set; }

        /// <summary>The window's size in pixels, which cameras without a target have.</summary>
        public int ScreenWidth { get; set; } = 1280;

        /// <inheritdoc cref="ScreenWidth"/>
        public int ScreenHeight { get; set; } = 720;

        /// <summary>Receives every message: severity, text, stack trace; on the thread that logs. Null: warnings and worse go to standard error.</summary>
        public Action<LogType, string, string> Log { get; set; }
    }
}
