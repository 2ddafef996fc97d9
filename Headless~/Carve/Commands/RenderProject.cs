using System;
using UnityEngine;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>The Unity project that is pretended, as far as pictures depend on it.</summary>
    sealed record RenderProject
    {
        public HostPipeline Pipeline { get; init; }

        public ColorSpace ColorSpace { get; init; } = ColorSpace.Linear;

        public TextureLayout Layout { get; init; }

        public HostStereo Stereo { get; init; }

        public KernelCompiler KernelCompiler { get; init; }

        /// <summary>An eye's picture, or the camera's.</summary>
        public PictureSize Size { get; init; } = new(1, 1);

        public HostOptions HostOptions(Action<LogType, string, string> log) => new()
        {
            Log = log,
            RenderPipeline = Pipeline,
            ColorSpace = ColorSpace,
            Stereo = Stereo,
            KernelCompiler = KernelCompiler,
            Headset = { EyeWidth = Size.Width, EyeHeight = Size.Height },
        };
    }
}
