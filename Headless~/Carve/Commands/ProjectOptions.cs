using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Linq;
using UnityEngine;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>Options of the Unity project that is pretended.</summary>
    sealed class ProjectOptions
    {
        static readonly Dictionary<string, HostPipeline> Pipelines = new()
        {
            ["built-in"] = HostPipeline.BuiltIn, ["universal"] = HostPipeline.Universal,
        };

        static readonly Dictionary<string, ColorSpace> ColorSpaces = new() { ["linear"] = ColorSpace.Linear, ["gamma"] = ColorSpace.Gamma };

        static readonly Dictionary<string, TextureLayout> Layouts = new()
        {
            ["automatic"] = TextureLayout.Automatic, ["compact"] = TextureLayout.Compact, ["portable"] = TextureLayout.Portable,
        };

        static readonly Dictionary<string, HostStereo> Eyes = new()
        {
            ["mono"] = HostStereo.Mono, ["multi-pass"] = HostStereo.MultiPass, ["instanced"] = HostStereo.SinglePassInstanced, ["multiview"] = HostStereo.Multiview,
        };

        static readonly Dictionary<string, KernelCompiler> Compilers = new()
        {
            ["glslang"] = KernelCompiler.Glslang, ["fxc"] = KernelCompiler.Fxc,
        };

        readonly Option<string> pipeline = Choice("--pipeline", Pipelines.Keys, "The render pipeline of what a camera draws.");

        readonly Option<string> colorSpace = Choice("--color-space", ColorSpaces.Keys, "The project's colour space; in gamma, Unity blends what is encoded.");

        public Option<string> Layout { get; } = Choice("--layout", Layouts.Keys,
            "How the volume lies in textures: compact, portable, or what the device can write; the picture is the same.");

        readonly Option<string> stereo = Choice("--stereo", Eyes.Keys,
            FormattableString.Invariant($"Draw for a headset: both eyes side by side, each of --size, {1000 * DrawnView.EyeDistance:0} mm apart, with parallel views."));

        readonly Option<string> compiler = Choice("--compiler", Compilers.Keys,
            "How kernels are compiled: by glslang, or by Microsoft's FXC as in Unity, whose bytecode vkd3d takes to the device; Headless~/carve sets both up.");

        public void AddTo(Command command)
        {
            foreach (var option in new[] { pipeline, colorSpace, stereo, compiler }) command.Options.Add(option);
        }

        public RenderProject Read(ParseResult parsed, PictureSize size) => new()
        {
            Pipeline = Pipelines[parsed.GetValue(pipeline)!],
            ColorSpace = ColorSpaces[parsed.GetValue(colorSpace)!],
            Layout = Layouts[parsed.GetValue(Layout) ?? "automatic"],
            Stereo = Eyes[parsed.GetValue(stereo)!],
            KernelCompiler = Compilers[parsed.GetValue(compiler)!],
            Size = size,
        };

        static Option<string> Choice(string name, IEnumerable<string> choices, string description)
        {
            var option = new Option<string>(name) { Description = description, DefaultValueFactory = _ => choices.First() };
            option.AcceptOnlyFromAmong(choices.ToArray());
            return option;
        }
    }
}
