using System;
using System.CommandLine;
using System.IO;
using System.Linq;
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
        static async Task<int> Main(string[] arguments)
        {
            using var interrupts = new Interrupts();
            return await RunAsync(arguments, Console.Out, Console.Error);
        }

        /// <summary>Runs one command line, as the process would, and returns its exit code.</summary>
        internal static async Task<int> RunAsync(string[] arguments, TextWriter output, TextWriter error, CancellationToken cancellation = default)
        {
            var root = new RootCommand(
                "Renders segmented CT and MRI volumes carved by clip spheres, headless, with the very code of the Unity package AnatomyCarve.")
            {
                RenderCommand.Create(),
                SceneCommand.Create(),
                InfoCommand.Create(),
                CompareCommand.Create(),
                ExpectCommand.Create(),
                BenchCommand.Create(),
            };

            var parsed = root.Parse(arguments);
            if (parsed.Errors.Count > 0)
            {
                error.WriteLine($"carve: {Failure.OneLine(Problem(parsed))} (see carve --help)");
                return Failure.Usage;
            }

            try
            {
                var configuration = new InvocationConfiguration
                {
                    EnableDefaultExceptionHandler = false,
                    ProcessTerminationTimeout = null,
                    Output = output,
                    Error = error,
                };
                return await parsed.InvokeAsync(configuration, cancellation);
            }
            catch (Exception exception)
            {
                var (message, code) = Failure.Describe(exception);
                error.WriteLine($"carve: {message}");
                return code;
            }
        }

        // What was not understood says more than what is missing because of it.
        static string Problem(ParseResult parsed) =>
            parsed.Errors.Select(problem => problem.Message).FirstOrDefault(message => parsed.UnmatchedTokens.Any(message.Contains))
            ?? parsed.Errors[0].Message;
    }
}
