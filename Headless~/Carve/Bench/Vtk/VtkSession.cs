using System;
using System.ComponentModel;
using System.Diagnostics;
using System.IO;
using System.Text.Json.Nodes;

namespace AnatomyCarve.Headless.Cli.Bench.Vtk
{
    /// <summary>VTK in a process of its own (raycast.py), which makes a picture each time that it is asked to.</summary>
    sealed class VtkSession : IDisposable
    {
        /// <summary>What Debian calls what this needs.</summary>
        public const string Packages = "python3-vtk9 python3-numpy xvfb";

        readonly Process process;

        VtkSession(Process process) => this.process = process;

        /// <summary>VTK's version.</summary>
        public string Version { get; private set; }

        /// <summary>Starts it, in a display of its own.</summary>
        /// <param name="settingsPath">see raycast.py</param>
        /// <returns>The session, or null and why there is none.</returns>
        public static (VtkSession Session, string Problem) Start(string settingsPath)
        {
            var start = new ProcessStartInfo("xvfb-run") { RedirectStandardInput = true, RedirectStandardOutput = true, RedirectStandardError = true };
            foreach (var argument in new[] { "-a", "-s", "-screen 0 1024x1024x24", Python(), BenchFiles.Find("Vtk", "raycast.py"), settingsPath })
            {
                start.ArgumentList.Add(argument);
            }

            Process process;
            try
            {
                process = Process.Start(start);
            }
            catch (Win32Exception)
            {
                return (null, $"xvfb-run is not installed; Debian's packages are {Packages}.");
            }

            var session = new VtkSession(process);
            process.ErrorDataReceived += (_, _) => { };
            process.BeginErrorReadLine();
            var first = process.StandardOutput.ReadLine();
            if (first == null)
            {
                session.Dispose();
                return (null, $"VTK does not start here; Debian's packages are {Packages}.");
            }

            session.Version = (string)JsonNode.Parse(first)["vtk"];
            return (session, null);
        }

        /// <summary>Asks for something and waits for the answer.</summary>
        /// <exception cref="IOException">VTK has ended.</exception>
        public JsonNode Ask(string question)
        {
            process.StandardInput.WriteLine(question);
            process.StandardInput.Flush();
            return JsonNode.Parse(process.StandardOutput.ReadLine() ?? throw new IOException($"VTK ended when it was asked for \"{question}\"."));
        }

        public void Dispose()
        {
            if (!process.HasExited)
            {
                process.StandardInput.Close();
                if (!process.WaitForExit(10_000)) process.Kill(entireProcessTree: true);
            }

            process.Dispose();
        }

        // Debian's packages belong to Debian's Python, which need not be the first one on the path.
        static string Python() => File.Exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3";
    }
}
