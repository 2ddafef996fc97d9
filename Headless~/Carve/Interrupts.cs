using System;
using System.Runtime.InteropServices;
using AnatomyCarve.Headless.Cli.Files;

namespace AnatomyCarve.Headless.Cli
{
    /// <summary>
    /// While this lives, SIGINT (Ctrl+C) and SIGTERM end the process at once, whatever it computes: half-written files are deleted and one line
    /// says so. The commands work on the thread that they are called on, where System.CommandLine would not get to see a signal.
    /// </summary>
    sealed class Interrupts : IDisposable
    {
        const string ShowCursor = "\u001b[?25h";

        readonly PosixSignalRegistration[] registrations =
            [PosixSignalRegistration.Create(PosixSignal.SIGINT, OnSignal), PosixSignalRegistration.Create(PosixSignal.SIGTERM, OnSignal)];

        public void Dispose()
        {
            foreach (var registration in registrations) registration.Dispose();
        }

        static void OnSignal(PosixSignalContext context)
        {
            context.Cancel = true;
            OutputSet.Interrupt(() =>
            {
                // The progress bars hide the cursor.
                if (!Console.IsErrorRedirected) Console.Error.WriteLine(ShowCursor);
                var (message, code) = Failure.Describe(new OperationCanceledException());
                Console.Error.WriteLine($"carve: {message}");
                Environment.Exit(code);
            });
        }
    }
}
