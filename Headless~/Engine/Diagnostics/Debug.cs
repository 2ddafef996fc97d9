using System;
using System.Diagnostics;
using System.Globalization;

namespace UnityEngine
{
    /// <summary>Messages to the log, from any thread.</summary>
    public class Debug
    {
        public static bool isDebugBuild => true;

        public static void Log(object message) => Emit(LogType.Log, message);

        public static void Log(object message, Object context) => Emit(LogType.Log, message);

        public static void LogWarning(object message) => Emit(LogType.Warning, message);

        public static void LogWarning(object message, Object context) => Emit(LogType.Warning, message);

        public static void LogError(object message) => Emit(LogType.Error, message);

        public static void LogError(object message, Object context) => Emit(LogType.Error, message);

        [Conditional("UNITY_ASSERTIONS")]
        public static void LogAssertion(object message) => Emit(LogType.Assert, message);

        [Conditional("UNITY_ASSERTIONS")]
        public static void LogAssertion(object message, Object context) => Emit(LogType.Assert, message);

        public static void LogFormat(string format, params object[] args) => Emit(LogType.Log, Text(format, args));

        public static void LogFormat(Object context, string format, params object[] args) => Emit(LogType.Log, Text(format, args));

        public static void LogFormat(LogType logType, LogOption logOptions, Object context, string format, params object[] args) =>
            LogRouter.Emit(logType, Text(format, args), logOptions == LogOption.NoStacktrace ? "" : Trace());

        public static void LogWarningFormat(string format, params object[] args) => Emit(LogType.Warning, Text(format, args));

        public static void LogWarningFormat(Object context, string format, params object[] args) => Emit(LogType.Warning, Text(format, args));

        public static void LogErrorFormat(string format, params object[] args) => Emit(LogType.Error, Text(format, args));

        public static void LogErrorFormat(Object context, string format, params object[] args) => Emit(LogType.Error, Text(format, args));

        public static void LogException(Exception exception) => LogException(exception, null);

        public static void LogException(Exception exception, Object context) =>
            LogRouter.EmitException(exception ?? new ArgumentNullException(nameof(exception)));

        [Conditional("UNITY_ASSERTIONS")]
        public static void Assert(bool condition)
        {
            if (!condition)
                Emit(LogType.Assert, "Assertion failed");
        }

        [Conditional("UNITY_ASSERTIONS")]
        public static void Assert(bool condition, Object context) => Assert(condition);

        [Conditional("UNITY_ASSERTIONS")]
        public static void Assert(bool condition, object message)
        {
            if (!condition)
                Emit(LogType.Assert, message);
        }

        [Conditional("UNITY_ASSERTIONS")]
        public static void Assert(bool condition, string message)
        {
            if (!condition)
                Emit(LogType.Assert, message);
        }

        [Conditional("UNITY_ASSERTIONS")]
        public static void Assert(bool condition, object message, Object context)
        {
            if (!condition)
                Emit(LogType.Assert, message);
        }

        [Conditional("UNITY_ASSERTIONS")]
        public static void Assert(bool condition, string message, Object context)
        {
            if (!condition)
                Emit(LogType.Assert, message);
        }

        [Conditional("UNITY_ASSERTIONS")]
        public static void AssertFormat(bool condition, string format, params object[] args)
        {
            if (!condition)
                Emit(LogType.Assert, Text(format, args));
        }

        static void Emit(LogType type, object message) => LogRouter.Emit(type, Text(message), Trace());

        static string Text(object message) => message switch
        {
            null => "Null",
            IFormattable f => f.ToString(null, CultureInfo.InvariantCulture),
            _ => message.ToString(),
        };

        static string Text(string format, object[] args) => string.Format(CultureInfo.InvariantCulture, format, args);

        static string Trace() => new StackTrace(3, true).ToString();
    }
}
