using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using AnatomyCarve.Headless.Cli;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>What a command line printed and returned.</summary>
    sealed record CarveResult(int ExitCode, string Output, string Error)
    {
        public string[] ErrorLines => Error.Split('\n', StringSplitOptions.RemoveEmptyEntries);
    }

    /// <summary>Runs command lines: in this process where no engine is needed, in one of their own where it is.</summary>
    static class Carve
    {
        /// <summary>The command line's program, for dotnet.</summary>
        public static string Dll => typeof(Program).Assembly.Location;

        static readonly TimeSpan Patience = TimeSpan.FromMinutes(5);

        public static CarveResult InProcess(params string[] arguments)
        {
            using StringWriter output = new(), error = new();
            var code = Program.RunAsync(arguments, output, error).GetAwaiter().GetResult();
            return new CarveResult(code, output.ToString(), error.ToString());
        }

        public static CarveResult Process(params string[] arguments) => Process(arguments, environment: []);

        public static CarveResult Process(string[] arguments, params (string Name, string Value)[] environment)
        {
            var start = new ProcessStartInfo("dotnet") { RedirectStandardOutput = true, RedirectStandardError = true, UseShellExecute = false };
            start.ArgumentList.Add(Dll);
            foreach (var (name, value) in environment) start.Environment[name] = value;
            foreach (var argument in arguments) start.ArgumentList.Add(argument);
            using var process = System.Diagnostics.Process.Start(start);
            var output = process.StandardOutput.ReadToEndAsync();
            var error = process.StandardError.ReadToEndAsync();
            if (!process.WaitForExit(Patience))
            {
                process.Kill(entireProcessTree: true);
                Assert.Fail($"carve {string.Join(' ', arguments)} did not end within {Patience}.");
            }

            Task.WaitAll(output, error);
            return new CarveResult(process.ExitCode, output.Result, error.Result);
        }
    }

    /// <summary>A folder for one test's files, deleted with its end.</summary>
    sealed class TestFolder : IDisposable
    {
        public TestFolder() => Path = Directory.CreateTempSubdirectory("carve-test-").FullName;

        public string Path { get; }

        public IEnumerable<string> FileNames => Directory.EnumerateFileSystemEntries(Path).Select(System.IO.Path.GetFileName).Order(StringComparer.Ordinal);

        public string this[string name] => System.IO.Path.Combine(Path, name);

        public string Write(string name, string text)
        {
            File.WriteAllText(this[name], text);
            return this[name];
        }

        public void Dispose() => Directory.Delete(Path, recursive: true);
    }
}
