using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;

namespace UnityEngine.Shaders
{
    /// <summary>What to compile.</summary>
    sealed class HlslJob
    {
        /// <summary>What messages call it: "'Name', kernel K".</summary>
        internal string Subject;

        /// <summary>The file that messages without one of their own are about.</summary>
        internal string Path;

        /// <summary>All the source, includes in place.</summary>
        internal string Text;

        /// <summary>comp, vert or frag.</summary>
        internal string Stage;

        internal string Entry;

        /// <summary>"NAME=VALUE".</summary>
        internal IReadOnlyList<string> Defines;

        /// <summary>One kernel of a source.</summary>
        /// <param name="api">The define of the graphics API that the code is for.</param>
        internal static HlslJob OfKernel(ComputeSource source, string kernel, string api, IEnumerable<string> defines) => new()
        {
            Subject = $"'{System.IO.Path.GetFileNameWithoutExtension(source.Path)}', kernel {kernel}",
            Path = source.Path,
            Text = source.Text,
            Stage = "comp",
            Entry = kernel,
            Defines = new[] { api + "=1", "SHADER_STAGE_COMPUTE=1", "SHADER_TARGET=50", "UNITY_VERSION=600000" }.Concat(defines).ToList(),
        };
    }

    /// <summary>HLSL to SPIR-V by glslang, with a cache on disk that is keyed by everything that goes in.</summary>
    static class HlslCompiler
    {
        const string Executable = "glslangValidator";

        // Changes when the command line or the rewriting of the result changes.
        const string Generation = "1";

        // Unity's language for drawing: semantics say what belongs together, sampler2D is known, and SV_Position.w is w.
        static readonly string[] s_DrawOptions = { "--auto-map-locations", "-fhlsl_functionality1", "--hlsl-dx9-compatible", "--hlsl-dx-position-w" };

        static string s_Version;

        /// <summary>How many kernels were compiled, not found in the cache.</summary>
        internal static int CompileCount { get; private set; }

        /// <summary>How many kernels came from the cache on disk.</summary>
        internal static int CacheHitCount { get; private set; }

        /// <summary>Compiles one entry point.</summary>
        /// <exception cref="ShaderCompileException">An error in the source; or no compiler.</exception>
        internal static byte[] Compile(HlslJob job)
        {
            s_Version ??= Start(new List<string> { "--version" }).Log;
            var key = CompiledFiles.Key(job.Entry, Generation, s_Version, string.Join("\n", job.Defines), job.Text);
            if (CompiledFiles.TryRead(key, ".spv", out var spirv))
            {
                CacheHitCount++;
                return spirv;
            }
            spirv = Run(job);
            CompileCount++;
            CompiledFiles.Write(key, ".spv", spirv);
            return spirv;
        }

        static byte[] Run(HlslJob job)
        {
            using var folder = new CompilerFolder();
            var input = folder.Write("kernel.hlsl", job.Text);
            var output = folder.PathOf("kernel.spv");
            var arguments = new List<string>
            {
                "-D", "-V", "-S", job.Stage, "-e", job.Entry, "--source-entrypoint", job.Entry, "--target-env", "vulkan1.1",
                "--hlsl-offsets", "--auto-map-bindings", "-o", output,
            };
            if (job.Stage != "comp")
                arguments.AddRange(s_DrawOptions);
            arguments.AddRange(job.Defines.Select(d => "-D" + d));
            arguments.Add(input);
            var (code, log) = Start(arguments);
            var problems = Problems(log, input);
            if (code != 0 || problems.Count > 0 || !File.Exists(output))
                throw new ShaderCompileException(Describe(job, problems, log));
            return File.ReadAllBytes(output);
        }

        // A missing entry point is only a warning to glslang, and its result is useless: every warning counts as an error.
        static List<string> Problems(string log, string input) => log.Split('\n')
            .Select(l => l.Trim())
            .Where(l => l.StartsWith("ERROR:", StringComparison.Ordinal) || l.StartsWith("WARNING:", StringComparison.Ordinal)
                || l.StartsWith("Linking ", StringComparison.Ordinal) && l.Contains("Missing entry point", StringComparison.Ordinal))
            .Where(l => !l.Contains("compilation errors", StringComparison.Ordinal))
            .Select(l => l.Replace(input + ":", ""))
            .ToList();

        static string Describe(HlslJob job, List<string> problems, string log)
        {
            var text = new StringBuilder("Shader error in ").Append(job.Subject).Append(':');
            if (problems.Count == 0)
                return text.Append('\n').Append(log.Trim()).ToString();
            foreach (var problem in problems)
            {
                // glslang writes "ERROR: file:line: text"; Unity "text at kernel K at file(line)".
                var match = Regex.Match(problem, @"^(?:ERROR|WARNING): (?<file>.+?):(?<line>\d+): (?<text>.*)$");
                text.Append('\n');
                if (match.Success)
                    text.Append(match.Groups["file"].Value).Append('(').Append(match.Groups["line"].Value).Append("): ").Append(match.Groups["text"].Value);
                else
                    text.Append(job.Path).Append(": ").Append(problem);
            }
            return text.ToString();
        }

        static (int Code, string Log) Start(List<string> arguments) =>
            CompilerProcess.Run(Executable, arguments, $"{Executable} was not found. Debian: apt install glslang-tools.");
    }
}
