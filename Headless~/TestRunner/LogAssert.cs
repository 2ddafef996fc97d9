using System.Text.RegularExpressions;

namespace UnityEngine.TestTools
{
    /// <summary>What a test expects to be logged. Unexpected errors, asserts and exceptions fail it.</summary>
    public static class LogAssert
    {
        /// <summary>Lets the current test log errors without failing.</summary>
        public static bool ignoreFailingMessages
        {
            get => LogScope.Current.IgnoresFailures;
            set => LogScope.Current.IgnoresFailures = value;
        }

        /// <summary>Expects a message; it must be equal as a whole ("TypeName: message" for exceptions) and come in the order of the calls.</summary>
        public static void Expect(LogType type, string message) => LogScope.Current.Expect(new ExpectedLog(type, message));

        public static void Expect(LogType type, Regex message) => LogScope.Current.Expect(new ExpectedLog(type, message));

        /// <summary>Expects a message of any severity.</summary>
        public static void Expect(string message) => LogScope.Current.Expect(new ExpectedLog(null, message));

        public static void Expect(Regex message) => LogScope.Current.Expect(new ExpectedLog(null, message));

        /// <summary>Fails if anything was logged so far that was not expected, info and warnings included.</summary>
        public static void NoUnexpectedReceived() => LogScope.Current.FailOnAnyUnexpected();
    }
}
