using System;
using System.IO;
using System.Text.RegularExpressions;
using AnatomyCarve.Headless.Cli.Files;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli
{
    /// <summary>What goes wrong, said in one line, with the exit code that goes with it.</summary>
    static class Failure
    {
        public const int BadInput = 1;
        public const int Usage = 2;
        public const int Interrupted = 130;

        public static (string Message, int Code) Describe(Exception exception) => exception switch
        {
            AggregateException { InnerExceptions.Count: 1 } aggregate => Describe(aggregate.InnerExceptions[0]),
            OperationCanceledException => ("interrupted; nothing was written", Interrupted),
            CommandException command => (OneLine(command.Message), BadInput),
            PictureFileException or AnatomyCarveException => (OneLine(exception.Message), BadInput),
            FileNotFoundException { FileName: { } file } => ($"{file}: there is no such file.", BadInput),
            FileNotFoundException or DirectoryNotFoundException => (OneLine(exception.Message), BadInput),
            IOException or UnauthorizedAccessException => (OneLine(exception.Message), BadInput),
            OutOfMemoryException => ("there is not enough memory for this volume.", BadInput),
            // The engine's own: no driver, a shader that does not compile ...
            _ when exception.GetType().Assembly == typeof(UnityEngine.Object).Assembly => (OneLine(exception.Message), BadInput),
            _ => ($"unexpected {exception.GetType().Name}: {OneLine(exception.Message)}", BadInput),
        };

        /// <summary>The text without line breaks and without the name of a parameter, which says nothing to a user.</summary>
        public static string OneLine(string text) =>
            string.Join(' ', Regex.Replace(text, @" \(Parameter '\w*'\)", "")
                .Split((char[])['\r', '\n'], StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries));
    }

    /// <summary>A command can't do what it was asked for; the message is one line for the user.</summary>
    sealed class CommandException(string message) : Exception(message);
}
