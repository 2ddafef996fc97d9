using System;
using System.CommandLine;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Headless.Cli.Commands;

namespace AnatomyCarve.Headless.Cli
{
    /// <summary>
    /// The command line. Whatever it renders, reads or measures, the package does; here are arguments, files and messages.
    /// Exit codes: 0 done, 1 the input or the machine is at fault, 2 the arguments are, 130 interrupted.
    /// </summary>
    static class Program
    {
        static Task<int> Main(string[] arguments) => RunAsync(arguments, Console.Out, Console.Error);

        /// <summary>Runs one command line, as the process would, and returns its exit code.</summary>
        internal static async Task<int> RunAsync(string[] arguments, TextWriter output, TextWriter error, CancellationToken cancellation = default)
        {
            var root = new RootCommand(
                "Renders segmented CT and MRI volumes carved by clip spheres, headless, with the very code of the Unity package AnatomyCarve.")
            {
                RenderCommand.Create(),
                InfoCommand.Create(),
                CompareCommand.Create(),
                ExpectCommand.Create(),
            };

            var parsed = root.Parse(arguments);
            if (parsed.Errors.Count > 0)
            {
                error.WriteLine($"carve: {Failure.OneLine(parsed.Errors[0].Message)} (see carve --help)");
                return Failure.Usage;
            }

            try
            {
                var configuration = new InvocationConfiguration { EnableDefaultExceptionHandler = false, Output = output, Error = error };
                return await parsed.InvokeAsync(configuration, cancellation);
            }
            catch (Exception exception)
            {
                var (message, code) = Failure.Describe(exception);
                error.WriteLine($"carve: {message}");
                return code;
            }
        }
    }
}
