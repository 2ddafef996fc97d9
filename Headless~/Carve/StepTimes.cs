using System;
using System.Collections.Generic;
using System.Diagnostics;

namespace AnatomyCarve.Headless.Cli
{
    /// <summary>How long the steps of a command took.</summary>
    sealed class StepTimes
    {
        readonly Dictionary<string, double> milliseconds = [];

        public IReadOnlyDictionary<string, double> Milliseconds => milliseconds;

        public T Measure<T>(string step, Func<T> action)
        {
            var clock = Stopwatch.StartNew();
            var result = action();
            milliseconds[step] = clock.Elapsed.TotalMilliseconds;
            return result;
        }

        public object Measure(string step, Action action) => Measure<object>(step, () =>
        {
            action();
            return null;
        });
    }
}
