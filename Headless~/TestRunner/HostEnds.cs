using System;
using System.Collections.Generic;
using System.IO;

namespace UnityEngine.TestTools
{
    /// <summary>
    /// What was wrong when the hosts of a test run ended: leaks, words of the validation layer. `dotnet test` does not count a OneTimeTearDown that
    /// fails, so nothing is asserted there: faults are noted here, and the run's last OneTimeTearDown ends the process, which does count.
    /// </summary>
    static class HostEnds
    {
        static readonly List<string> s_Faults = new();

        /// <summary>Notes the end of a host.</summary>
        /// <param name="tests">Whose host it was.</param>
        /// <param name="isClean">Whether all was as it should be.</param>
        /// <param name="report">What was left.</param>
        internal static void Note(string tests, bool isClean, object report)
        {
            if (!isClean)
                s_Faults.Add($"The host of {tests} ended with {report}");
        }

        /// <summary>To be called when all tests are done: ends the process with exit code 1 if an end was not clean.</summary>
        internal static void Conclude()
        {
            if (s_Faults.Count == 0)
                return;
            // NUnit keeps Console.Error to itself; the stream beneath reaches the runner.
            using (var error = new StreamWriter(Console.OpenStandardError()))
                foreach (var fault in s_Faults)
                    error.WriteLine(fault);
            Environment.Exit(1);
        }
    }
}
