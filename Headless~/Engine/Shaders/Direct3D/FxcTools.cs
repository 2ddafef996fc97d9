using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Security.Cryptography;

namespace UnityEngine.Shaders.Direct3D
{
    /// <summary>FXC under Wine and vkd3d-compiler, as Headless~/d3d.sh sets them up.</summary>
    static class FxcTools
    {
        internal const string Vkd3dCompiler = "vkd3d-compiler";

        const string Driver = "d3dcompile";
        const string Library = "d3dcompiler_47.dll";

        static string s_Version;

        static string Folder => Path.Combine(GpuOptions.UserCacheFolder, "d3d");

        /// <summary>Which compilers these are.</summary>
        /// <exception cref="ShaderCompileException">They are not set up.</exception>
        internal static string Version => s_Version ??= Hash(Path.Combine(Folder, Library)) + RunVkd3d(new[] { "--version" }).Log;

        /// <summary>Runs FXC in a folder, with the options of D3d/d3dcompile.c.</summary>
        internal static (int Code, string Log) RunFxc(IEnumerable<string> arguments, string folder)
        {
            var driver = Path.Combine(Folder, Driver);
            return CompilerProcess.Run(driver, arguments.Prepend("fxc"), Missing(driver), folder);
        }

        internal static (int Code, string Log) RunVkd3d(IEnumerable<string> arguments) =>
            CompilerProcess.Run(Vkd3dCompiler, arguments, Missing(Vkd3dCompiler));

        /// <summary>A path as Wine writes it, as it is here.</summary>
        internal static string LocalPath(string path) =>
            path.StartsWith("Z:", StringComparison.OrdinalIgnoreCase) ? path.Substring(2).Replace('\\', '/') : path;

        static string Hash(string path)
        {
            try
            {
                using var sha = SHA256.Create();
                using var file = File.OpenRead(path);
                return BitConverter.ToString(sha.ComputeHash(file));
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                throw new ShaderCompileException(Missing(path), e);
            }
        }

        static string Missing(string what) => $"{what} was not found, which kernels need that go by FXC. Headless~/check-d3d sets it up.";
    }
}
