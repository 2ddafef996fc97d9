using System;
using System.Collections.Generic;
using System.ComponentModel;
using System.Diagnostics;
using System.IO;
using System.Text;

namespace UnityEngine.Shaders
{
    /// <summary>Runs a compiler that is a program of its own.</summary>
    static class CompilerProcess
    {
        /// <param name="missing">What to say if there is no such program.</param>
        /// <param name="folder">Where it runs; without one, where this process does.</param>
        /// <returns>The exit code, and what it wrote to both outputs.</returns>
        /// <exception cref="ShaderCompileException">There is no such program.</exception>
        internal static (int Code, string Log) Run(string executable, IEnumerable<string> arguments, string missing, string folder = "")
        {
            var info = new ProcessStartInfo(executable)
            {
                RedirectStandardOutput = true,
                RedirectStandardError = true,
                UseShellExecute = false,
                WorkingDirectory = folder,
            };
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
                throw new ShaderCompileException(missing, e);
            }
        }
    }

    /// <summary>A folder for the files of one compilation.</summary>
    sealed class CompilerFolder : IDisposable
    {
        internal CompilerFolder() => Directory.CreateDirectory(Path);

        internal string Path { get; } = System.IO.Path.Combine(System.IO.Path.GetTempPath(), "anatomycarve-" + Guid.NewGuid().ToString("N"));

        internal string PathOf(string name) => System.IO.Path.Combine(Path, name);

        /// <summary>Writes a source and says where it is.</summary>
        internal string Write(string name, string text)
        {
            File.WriteAllText(PathOf(name), text, new UTF8Encoding(false));
            return PathOf(name);
        }

        public void Dispose() => Directory.Delete(Path, recursive: true);
    }
}
