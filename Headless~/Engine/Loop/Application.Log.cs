namespace UnityEngine
{
    public partial class Application
    {
        /// <summary>A message of the log, with its stack trace.</summary>
        public delegate void LogCallback(string condition, string stackTrace, LogType type);

        /// <summary>Raised on the main thread, for messages that were logged there.</summary>
        public static event LogCallback logMessageReceived;

        /// <summary>Raised for every message, on the thread that logs.</summary>
        public static event LogCallback logMessageReceivedThreaded;

        internal static void RaiseLog(string message, string stackTrace, LogType type)
        {
            logMessageReceivedThreaded?.Invoke(message, stackTrace, type);
            if (MainThread.IsCurrent)
                logMessageReceived?.Invoke(message, stackTrace, type);
        }

        internal static void ForgetLogSubscribers()
        {
            logMessageReceived = null;
            logMessageReceivedThreaded = null;
        }
    }
}
