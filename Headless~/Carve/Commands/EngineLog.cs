using UnityEngine;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>What the engine and the package log while a command runs: warnings are passed on, and errors fail it.</summary>
    /// <param name="warnings">where warnings go</param>
    sealed class EngineLog(Warnings warnings)
    {
        volatile string firstError;

        /// <summary>Takes a message in; called on any thread.</summary>
        public void Note(LogType type, string message, string stackTrace)
        {
            if (type == LogType.Warning) warnings.Add(message);
            if (type is LogType.Error or LogType.Exception or LogType.Assert) firstError ??= message;
        }

        /// <summary>Fails if anything was logged as an error: a picture made in spite of it is not to be trusted.</summary>
        /// <exception cref="CommandException">Something was.</exception>
        public void ThrowIfFailed()
        {
            if (firstError != null) throw new CommandException(firstError);
        }
    }
}
