using System;
using System.Collections.Generic;
using System.ComponentModel;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text;
using System.Text.RegularExpressions;
using UnityEngine.Vulkan;

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
    }

    /// <summary>HLSL to SPIR-V by glslang, with a cache on disk that is keyed by everything that goes in.</summary>
    static class HlslCompiler
    {
        const string Executable = "glslangValidator";

        // Changes when the command line or the rewriting of the result changes.
        const string Generation = "1";

        static readonly string[] s_ComputeDefines = { "SHADER_API_VULKAN=1", "SHADER_STAGE_COMPUTE=1", "SHADER_TARGET=50", "UNITY_VERSION=600000" };

        // Unity's language for drawing: semantics say what belongs together, sampler2D is known, and SV_Position.w is w.
        static readonly string[] s_DrawOptions = { "--auto-map-locations", "-fhlsl_functionality1", "--hlsl-dx9-compatible", "--hlsl-dx-position-w" };

        static string s_Version;

        /// <summary>How many kernels were compiled, not found in the cache.</summary>
        internal static int CompileCount { get; private set; }

        /// <summary>How many kernels came from the cache on disk.</summary>
        internal static int CacheHitCount { get; private set; }

        /// <summary>Compiles one kernel of a source.</summary>
        /// <exception cref="ShaderCompileException">An error in the source; or no compiler.</exception>
        internal static byte[] Compile(ComputeSource source, string kernel, IReadOnlyList<string> defines) => Compile(new HlslJob
        {
            Subject = $"'{Path.GetFileNameWithoutExtension(source.Path)}', kernel {kernel}",
            Path = source.Path,
            Text = source.Text,
            Stage = "comp",
            Entry = kernel,
            Defines = s_ComputeDefines.Concat(defines).ToList(),
        });

        /// <summary>Compiles one entry point.</summary>
        /// <exception cref="ShaderCompileException">An error in the source; or no compiler.</exception>
        internal static byte[] Compile(HlslJob job)
        {
            var cached = Path.Combine(GpuOptions.EffectiveCacheFolder, "kernels", Key(job) + ".spv");
            if (TryRead(cached, out var spirv))
            {
                CacheHitCount++;
                return spirv;
            }
            spirv = Run(job);
            CompileCount++;
            AtomicFile.TryWrite(cached, spirv);
            return spirv;
        }

        static byte[] Run(HlslJob job)
        {
            var folder = Path.Combine(Path.GetTempPath(), "anatomycarve-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(folder);
            try
            {
                var input = Path.Combine(folder, "kernel.hlsl");
                var output = Path.Combine(folder, "kernel.spv");
                File.WriteAllText(input, job.Text, new UTF8Encoding(false));
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
            finally
            {
                Directory.Delete(folder, recursive: true);
            }
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

        static string Key(HlslJob job)
        {
            s_Version ??= Start(new List<string> { "--version" }).Log;
            var text = string.Join("\n", Generation, s_Version, job.Entry, string.Join("\n", job.Defines), job.Text);
            using var sha = SHA256.Create();
            var hash = sha.ComputeHash(Encoding.UTF8.GetBytes(text));
            return job.Entry + "-" + BitConverter.ToString(hash, 0, 16).Replace("-", "").ToLowerInvariant();
        }

        static (int Code, string Log) Start(List<string> arguments)
        {
            var info = new ProcessStartInfo(Executable) { RedirectStandardOutput = true, RedirectStandardError = true, UseShellExecute = false };
            foreach (var argument in arguments)
                info.ArgumentList.Add(argument);
            try
            {
                using var process = Process.Start(info);
                var errors = process.StandardError.ReadToEndAsync();
                var log = process.StandardOutput.ReadToEnd();
                process.WaitForExit();
                return (process.ExitCode, log + errors.Result);
            }
            catch (Win32Exception e)
            {
                throw new ShaderCompileException($"{Executable} was not found. Debian: apt install glslang-tools.", e);
            }
        }

        static bool TryRead(string path, out byte[] content)
        {
            content = null;
            try
            {
                if (!File.Exists(path))
                    return false;
                content = File.ReadAllBytes(path);
                return content.Length > 20;
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                return false;
            }
        }
    }
}
