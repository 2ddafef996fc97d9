using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;

namespace UnityEngine.Shaders.Direct3D
{
    /// <summary>
    /// The second way from a kernel to the device, the one that Unity's kernels begin on every platform: Microsoft's FXC makes Direct3D bytecode, which
    /// vkd3d-compiler says in SPIR-V, operation by operation. Names, strides and the packing of constants are the bytecode's own.
    /// </summary>
    static class FxcRoute
    {
        /// <summary>What vkd3d calls every entry point.</summary>
        const string Entry = "main";

        // Changes when a command line or the rewriting of a result changes.
        const string Generation = "1";

        // FXC does not know Unity's pragmas, and says so of each.
        const string UnknownPragma = "warning X3568:";

        // vkd3d reads the kind of a resource where it is declared, and wonders that accesses repeat it.
        static readonly Regex s_Harmless = new(@"^fixme:shader_sm4_read_instruction_modifier: Unhandled (resource|data) type 0x", RegexOptions.Compiled);

        static readonly Regex s_Message = new(@"^(?<file>.+?)\((?<line>\d+)(,\d+(-\d+)?)?\): (?<text>.*)$", RegexOptions.Compiled);

        /// <summary>How many kernels were compiled, not found in the cache.</summary>
        internal static int CompileCount { get; private set; }

        /// <summary>How many kernels came from the cache on disk.</summary>
        internal static int CacheHitCount { get; private set; }

        /// <summary>Compiles one kernel of a source.</summary>
        /// <exception cref="ShaderCompileException">An error or a warning in the source; or the compilers are not set up.</exception>
        /// <exception cref="NotSupportedException">The kernel uses what this host does not have.</exception>
        internal static KernelCode Compile(ComputeSource source, string kernel, IReadOnlyList<string> defines)
        {
            var job = HlslJob.OfKernel(source, kernel, "SHADER_API_D3D11", defines);
            var (bytecode, spirv) = Cached(job);
            var module = ExactArithmetic.Of(SpirvModule.Parse(spirv));
            return new KernelCode(module, Entry, RegisterNames.Resolve(SpirvReflection.Reflect(module), DxbcResources.Read(bytecode)));
        }

        static (byte[] Bytecode, byte[] Spirv) Cached(HlslJob job)
        {
            var key = CompiledFiles.Key(job.Entry, Generation, FxcTools.Version, string.Join("\n", job.Defines), job.Text);
            if (CompiledFiles.TryRead(key, ".dxbc", out var bytecode) && CompiledFiles.TryRead(key, ".spv", out var spirv))
            {
                CacheHitCount++;
                return (bytecode, spirv);
            }
            using var folder = new CompilerFolder();
            bytecode = Fxc(job, folder);
            spirv = Vkd3d(job, folder);
            CompileCount++;
            CompiledFiles.Write(key, ".dxbc", bytecode);
            CompiledFiles.Write(key, ".spv", spirv);
            return (bytecode, spirv);
        }

        static byte[] Fxc(HlslJob job, CompilerFolder folder)
        {
            folder.Write("kernel.hlsl", job.Text);
            var arguments = new List<string> { "kernel.hlsl", "-E", job.Entry, "-T", "cs_5_0", "-Fo", "kernel.dxbc" };
            foreach (var define in job.Defines)
                arguments.AddRange(new[] { "-D", define.Contains('=') ? define : define + "=1" });
            var (code, log) = FxcTools.RunFxc(arguments, folder.Path);
            // A warning counts as an error, as everywhere in this host.
            var problems = Lines(log).Where(l => !l.Contains(UnknownPragma, StringComparison.Ordinal)).ToList();
            if (code != 0 || problems.Count > 0 || !File.Exists(folder.PathOf("kernel.dxbc")))
                throw Error(job, problems.Count > 0 ? problems.Select(p => Describe(job, p)) : new[] { $"{job.Path}: FXC ended with exit code {code}: {log}" });
            return File.ReadAllBytes(folder.PathOf("kernel.dxbc"));
        }

        static byte[] Vkd3d(HlslJob job, CompilerFolder folder)
        {
            var output = folder.PathOf("kernel.spv");
            var (code, log) = FxcTools.RunVkd3d(new[] { "-x", "dxbc-tpf", "-b", "spirv-binary", "--buffer-uav=storage-buffer", "-o", output,
                folder.PathOf("kernel.dxbc") });
            // It leaves out what it does not know and goes on: whatever it says may mean wrong code.
            var problems = Lines(log).Where(l => !s_Harmless.IsMatch(l)).ToList();
            if (code != 0 || problems.Count > 0 || !File.Exists(output))
                throw Error(job, problems.DefaultIfEmpty($"exit code {code}").Select(p => $"{job.Path}: {FxcTools.Vkd3dCompiler}: {p}"));
            return File.ReadAllBytes(output);
        }

        static IEnumerable<string> Lines(string log) => log.Split('\n').Select(l => l.Trim()).Where(l => l.Length > 0).Distinct();

        static ShaderCompileException Error(HlslJob job, IEnumerable<string> problems) =>
            new($"Shader error in {job.Subject}:\n" + string.Join("\n", problems));

        // FXC writes "Z:\folder\file(line,columns): error X1234: text".
        static string Describe(HlslJob job, string problem)
        {
            var match = s_Message.Match(problem);
            return match.Success ? $"{FxcTools.LocalPath(match.Groups["file"].Value)}({match.Groups["line"].Value}): {match.Groups["text"].Value}"
                : $"{job.Path}: {problem}";
        }
    }
}
