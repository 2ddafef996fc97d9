using System;
using System.Diagnostics;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;

namespace AnatomyCarve.Headless.Cli.Bench.Time
{
    /// <summary>One way to do something.</summary>
    /// <param name="Name">its name in reports</param>
    /// <param name="Prepare">what comes before each run and does not count; it is told the run's number</param>
    /// <param name="Run">what counts, with the GPU's work</param>
    /// <param name="WarmUps">first runs that do not count: kernels are compiled at their first dispatch</param>
    sealed record TimedWay(string Name, Action<int> Prepare, Action Run, int WarmUps = 1);

    /// <summary>The milliseconds of the runs of one way.</summary>
    sealed record Timing(string Name, double[] Milliseconds)
    {
        public double Median
        {
            get
            {
                var sorted = Milliseconds.Order().ToArray();
                return (sorted[(sorted.Length - 1) / 2] + sorted[sorted.Length / 2]) / 2;
            }
        }

        public JsonObject ToJson() => new()
        {
            ["medianMs"] = Math.Round(Median, 3), ["leastMs"] = Math.Round(Milliseconds.Min(), 3), ["mostMs"] = Math.Round(Milliseconds.Max(), 3), ["runs"] = Milliseconds.Length,
        };
    }

    /// <summary>
    /// Runs several ways by turns (A, B, A, B, ...), so that what else the machine does meets all of them. A run ends when the GPU is done. Medians count; the
    /// spread is shown.
    /// </summary>
    static class Turns
    {
        public static Timing[] Measure(MeasureContext context, params TimedWay[] ways) => Measure(context, context.Runs, ways);

        public static Timing[] Measure(MeasureContext context, int runs, params TimedWay[] ways)
        {
            var times = ways.Select(_ => new double[runs]).ToArray();
            var warmUps = ways.Max(way => way.WarmUps);
            for (var run = -warmUps; run < runs; run++)
            {
                for (var way = 0; way < ways.Length; way++)
                {
                    context.Cancellation.ThrowIfCancellationRequested();
                    if (run < -ways[way].WarmUps) continue;
                    var milliseconds = Milliseconds(context.Stage, ways[way], run + warmUps);
                    if (run >= 0) times[way][run] = milliseconds;
                }

                context.Progress.Report((run + 1f + warmUps) / (runs + warmUps));
            }

            context.Stage.ThrowIfFailed();
            return ways.Select((way, number) => new Timing(way.Name, times[number])).ToArray();
        }

        /// <summary>The timings in a measure's settings.</summary>
        public static JsonObject ToJson(params Timing[] timings)
        {
            var json = new JsonObject();
            foreach (var timing in timings) json[timing.Name] = timing.ToJson();
            return json;
        }

        static double Milliseconds(BenchStage stage, TimedWay way, int number)
        {
            stage.Host.Step();
            way.Prepare?.Invoke(number);
            stage.Host.FinishGpu();
            var clock = Stopwatch.StartNew();
            way.Run();
            stage.Host.FinishGpu();
            return clock.Elapsed.TotalMilliseconds;
        }
    }
}
