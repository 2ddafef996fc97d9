using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.Layout
{
    /// <summary>
    /// The engine and the package's assemblies against the lists of Unity's real API, where those lie beside the repository (../shared); without them
    /// these tests say so and are skipped.
    /// </summary>
    public class UnityApiTests
    {
        static readonly PackageTree Tree = PackageTree.OfRepository();
        static readonly string Shared = Path.GetFullPath(Path.Combine(Tree.Root, "../shared"));
        static readonly string Cache = Path.Combine(
            Environment.GetEnvironmentVariable("XDG_CACHE_HOME") is { Length: > 0 } folder ? folder
                : Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.UserProfile), ".cache"),
            "anatomycarve");

        [Test]
        public void Engine_Members_AreThoseOfUnity() => Check("shim",
            ["UnityEngine.dll", "UnityEngine.TestRunner.dll", "UnityEditor.dll", "Unity.InputSystem.dll", "UnityEngine.UI.dll"]);

        [Test]
        public void Package_References_AreInUnitysApi() => Check("client",
            ["AnatomyCarve.Core.dll", "AnatomyCarve.dll", "AnatomyCarve.Editor.dll", "AnatomyCarve.Desktop.dll"]);

        [Test]
        public void Package_Sources_CompileAgainstUnity()
        {
            string run = Needed("tools/unity-api-ref/run");
            ProcessResult result = ProcessResult.Of("bash", [run, Tree.Root, "--werror"]);
            Assert.That(result.ExitCode, Is.Zero, result.Output);
        }

        /// <summary>A namespace that the lists leave out: of its members the engine has well-known ones only.</summary>
        const string NotListed = @"UnityEngine\.Networking\.";

        static void Check(string mode, string[] assemblies)
        {
            string tool = Tool();
            IEnumerable<string> paths = assemblies.Select(a => Path.Combine(AppContext.BaseDirectory, a));
            ProcessResult result = ProcessResult.Of("dotnet", [tool, mode, Needed("unity-api"), .. paths, "--ignore", NotListed]);
            Assert.That(result.ExitCode, Is.Zero, result.Output);
        }

        /// <summary>Builds the checker once per version of it; its own folder may be read-only.</summary>
        static string Tool()
        {
            string sources = Needed("tools/unity-api-check");
            string[] files = Directory.GetFiles(sources).Order(StringComparer.Ordinal).ToArray();
            string version = Convert.ToHexStringLower(SHA256.HashData(files.SelectMany(File.ReadAllBytes).ToArray()))[..16];
            string folder = Path.Combine(Cache, "unity-api-check-" + version), tool = Path.Combine(folder, "bin/apicheck.dll");
            if (File.Exists(tool))
                return tool;
            string copy = Directory.CreateDirectory(Path.Combine(folder, "src")).FullName;
            foreach (string file in files)
                File.WriteAllBytes(Path.Combine(copy, Path.GetFileName(file)), File.ReadAllBytes(file));
            ProcessResult build =
                ProcessResult.Of("dotnet",
                    ["build", "-c", "Release", "-v", "q", "-nologo", "-o", Path.Combine(folder, "bin"), Path.Combine(copy, "check.csproj")]);
            Assert.That(build.ExitCode, Is.Zero, build.Output);
            return tool;
        }

        static string Needed(string path)
        {
            string full = Path.Combine(Shared, path);
            if (!Path.Exists(full))
                Assert.Ignore($"skipped: there is no ../shared/{path} beside the repository.");
            return full;
        }
    }
}
