using System;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>A rendering that is interrupted while its files are written: exit code 130, one line, no file.</summary>
    sealed class InterruptTests
    {
        static readonly TimeSpan Patience = TimeSpan.FromMinutes(2);

        [TestCase("INT")]
        [TestCase("TERM")]
        [Platform("Linux")]
        public void Render_InterruptedWhileWriting_LeavesNoFile(string signal)
        {
            using var folder = new TestFolder();
            string[] before = [System.IO.Path.GetFileName(Phantom.WriteVolume(folder))];
            // A shell's background job, as these tests may be, hands on that it ignores SIGINT.
            using var render = Start("env", "--default-signal=INT,TERM", "dotnet", Carve.Dll, "render", folder["volume.nrrd"],
                "--quality", "fast", "--size", "4000x4000", "--output", folder["out.png"]);
            var error = render.StandardError.ReadToEndAsync();
            // Whether the folder takes files is tried by one that is gone at once; the picture's stays.
            Assert.That(SpinWait.SpinUntil(() => IsWriting(folder) || render.HasExited, Patience), Is.True);
            Assert.That(render.HasExited, Is.False, "the rendering ended too soon to be interrupted");

            using (var kill = Start("kill", "-" + signal, render.Id.ToString(System.Globalization.CultureInfo.InvariantCulture))) kill.WaitForExit();

            Assert.That(render.WaitForExit(Patience), Is.True);
            Assert.That(error.Result, Is.EqualTo("carve: interrupted; nothing was written\n"));
            Assert.That(render.ExitCode, Is.EqualTo(130));
            Assert.That(folder.FileNames, Is.EqualTo(before));
        }

        static bool IsWriting(TestFolder folder)
        {
            var first = Part(folder);
            if (first == null) return false;
            Thread.Sleep(50);
            return Part(folder) == first;
        }

        static string Part(TestFolder folder) => folder.FileNames.FirstOrDefault(name => name.EndsWith(".part", StringComparison.Ordinal));

        static Process Start(string program, params string[] arguments)
        {
            var start = new ProcessStartInfo(program) { RedirectStandardOutput = true, RedirectStandardError = true };
            foreach (var argument in arguments) start.ArgumentList.Add(argument);
            return Process.Start(start);
        }
    }
}
