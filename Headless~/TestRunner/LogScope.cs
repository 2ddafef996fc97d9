using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using NUnit.Framework.Interfaces;

namespace UnityEngine.TestTools
{
    /// <summary>The logs of one test and what it expects of them.</summary>
    sealed class LogScope : IDisposable
    {
        readonly object m_Lock = new();
        readonly List<ReceivedLog> m_Received = new();
        readonly List<ExpectedLog> m_Expected = new();

        internal LogScope()
        {
            Application.logMessageReceivedThreaded += OnLog;
            s_Current = this;
        }

        static LogScope s_Current;

        /// <exception cref="InvalidOperationException">No test runs.</exception>
        internal static LogScope Current =>
            s_Current ?? throw new InvalidOperationException("No log scope is available: LogAssert works in tests that run on the host only");

        internal bool IgnoresFailures { get; set; }

        internal void Expect(ExpectedLog log) => m_Expected.Add(log);

        /// <summary>Drops what was received and expected so far.</summary>
        internal void Forget()
        {
            lock (m_Lock)
            {
                m_Received.Clear();
                m_Expected.Clear();
            }
        }

        public void Dispose()
        {
            Application.logMessageReceivedThreaded -= OnLog;
            s_Current = null;
        }

        /// <summary>Fails on errors that nothing expects; at the end also on expectations that were not met.</summary>
        internal void Evaluate(bool isEnd)
        {
            lock (m_Lock)
            {
                Match();
                var failing = m_Received.Where(l => !l.IsExpected && (l.Type is LogType.Error or LogType.Assert or LogType.Exception)).ToList();
                // Each failure is reported once.
                failing.ForEach(l => l.IsExpected = true);
                if (failing.Count > 0 && !IgnoresFailures)
                    throw new LogFailureException($"Unhandled log message: '{failing[0]}'. Use "
                        + $"UnityEngine.TestTools.LogAssert.Expect\n{failing[0].StackTrace}");
                if (!isEnd || m_Expected.Count == 0)
                    return;
                var missing = m_Expected[0];
                m_Expected.Clear();
                throw new LogFailureException($"Expected log did not appear: {missing}");
            }
        }

        internal void FailOnAnyUnexpected()
        {
            lock (m_Lock)
            {
                Match();
                if (m_Received.Find(l => !l.IsExpected) is { } log)
                    throw new LogFailureException($"Unhandled log message: '{log}'. Use UnityEngine.TestTools.LogAssert.Expect");
            }
        }

        void Match()
        {
            foreach (var log in m_Received.Where(l => !l.IsExpected))
            {
                var index = m_Expected.FindIndex(e => e.Matches(log));
                if (index > 0)
                    throw new LogFailureException($"Expected {m_Expected[0]} but received {log} first: out of order");
                if (index < 0)
                    continue;
                log.IsExpected = true;
                m_Expected.RemoveAt(0);
            }
        }

        void OnLog(string condition, string stackTrace, LogType type)
        {
            lock (m_Lock)
                m_Received.Add(new ReceivedLog { Message = condition, StackTrace = stackTrace, Type = type });
        }
    }

    sealed class ReceivedLog
    {
        internal string Message;
        internal string StackTrace;
        internal LogType Type;
        internal bool IsExpected;

        public override string ToString() => $"[{Type}] {Message}";
    }

    sealed class ExpectedLog
    {
        readonly LogType? m_Type;
        readonly string m_Text;
        readonly Regex m_Pattern;

        internal ExpectedLog(LogType? type, string text)
        {
            m_Type = type;
            m_Text = text;
        }

        internal ExpectedLog(LogType? type, Regex pattern)
        {
            m_Type = type;
            m_Pattern = pattern;
        }

        internal bool Matches(ReceivedLog log) => (m_Type == null || m_Type == log.Type) && (m_Pattern?.IsMatch(log.Message) ?? log.Message == m_Text);

        public override string ToString() => $"[{m_Type?.ToString() ?? "any"}] {(m_Pattern != null ? "Regex: " + m_Pattern : m_Text)}";
    }

    /// <summary>A failure of the test, not an error in it.</summary>
    sealed class LogFailureException : ResultStateException
    {
        internal LogFailureException(string message) : base(message)
        {
        }

        public override ResultState ResultState => ResultState.Failure;
    }
}
