using System;

namespace UnityEngine
{
    /// <summary>The way of every message: to the host's log, then to the subscribers.</summary>
    static class LogRouter
    {
        /// <summary>Where the host writes messages; called on the thread that logs.</summary>
        internal static Action<LogType, string, string> Sink { get; set; }

        internal static void Emit(LogType type, string message, string stackTrace)
        {
            Sink?.Invoke(type, message, stackTrace);
            Application.RaiseLog(message, stackTrace, type);
        }

        /// <summary>Logs an exception as Unity does: "TypeName: message".</summary>
        internal static void EmitException(Exception exception)
        {
            var message = exception.GetType().Name + (string.IsNullOrEmpty(exception.Message) ? "" : ": " + exception.Message);
            var trace = exception.StackTrace ?? "";
            for (var inner = exception.InnerException; inner != null; inner = inner.InnerException)
                trace = $"{inner.GetType().Name}: {inner.Message}\n{inner.StackTrace}\nRethrow as {trace}";
            Emit(LogType.Exception, message, trace);
        }

        /// <summary>Runs a callback of the user's; what it throws is logged, not passed on.</summary>
        /// <returns>False if it threw.</returns>
        internal static bool Guard(Action callback)
        {
            try
            {
                callback();
                return true;
            }
            catch (Exception e)
            {
                EmitException(e);
                return false;
            }
        }
    }
}
