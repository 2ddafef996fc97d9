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
    /// <summary>HLSL to SPIR-V by glslang, with a cache on disk that is keyed by everything that goes in.</summary>
    static class HlslCompiler
    {
        const string Executable = "glslangValidator";

        // Changes when the command line or the rewriting of the result changes.
        const string Generation = "1";

        static readonly string[] s_UnityDefines = { "SHADER_API_VULKAN=1", "SHADER_STAGE_COMPUTE=1", "SHADER_TARGET=50", "UNITY_VERSION=600000" };

        static string s_Version;

        /// <summary>How many kernels were compiled, not found in the cache.</summary>
        internal static int CompileCount { get; private set; }

        /// <summary>How many kernels came from the cache on disk.</summary>
        internal static int CacheHitCount { get; private set; }

        /// <summary>Compiles one kernel of a source.</summary>
        /// <exception cref="ShaderCompileException">An error in the source; or no compiler.</exception>
        internal static byte[] Compile(ComputeSource source, string kernel, IReadOnlyList<string> defines)
        {
            var all = s_UnityDefines.Concat(defines).ToList();
            var cached = Path.Combine(GpuOptions.EffectiveCacheFolder, "kernels", Key(source, kernel, all) + ".spv");
            if (TryRead(cached, out var spirv))
            {
                CacheHitCount++;
                return spirv;
            }
            spirv = Run(source, kernel, all);
            CompileCount++;
            AtomicFile.TryWrite(cached, spirv);
            return spirv;
        }

        static byte[] Run(ComputeSource source, string kernel, List<string> defines)
        {
            var folder = Path.Combine(Path.GetTempPath(), "anatomycarve-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(folder);
            try
            {
                var input = Path.Combine(folder, "kernel.hlsl");
                var output = Path.Combine(folder, "kernel.spv");
                File.WriteAllText(input, source.Text, new UTF8Encoding(false));
                var arguments = new List<string>
                {
                    "-D", "-V", "-S", "comp", "-e", kernel, "--source-entrypoint", kernel, "--target-env", "vulkan1.1",
                    "--hlsl-offsets", "--auto-map-bindings", "-o", output,
                };
                arguments.AddRange(defines.Select(d => "-D" + d));
                arguments.Add(input);
                var (code, log) = Start(arguments);
                var problems = Problems(log, input);
                if (code != 0 || problems.Count > 0 || !File.Exists(output))
                    throw new ShaderCompileException(Describe(source, kernel, problems, log));
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

        static string Describe(ComputeSource source, string kernel, List<string> problems, string log)
        {
            var text = new StringBuilder().Append("Shader error in '").Append(Path.GetFileNameWithoutExtension(source.Path)).Append("', kernel ")
                .Append(kernel).Append(':');
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
                    text.Append(source.Path).Append(": ").Append(problem);
            }
            return text.ToString();
        }

        static string Key(ComputeSource source, string kernel, List<string> defines)
        {
            s_Version ??= Start(new List<string> { "--version" }).Log;
            var text = string.Join("\n", Generation, s_Version, kernel, string.Join("\n", defines), source.Text);
            using var sha = SHA256.Create();
            var hash = sha.ComputeHash(Encoding.UTF8.GetBytes(text));
            return kernel + "-" + BitConverter.ToString(hash, 0, 16).Replace("-", "").ToLowerInvariant();
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
