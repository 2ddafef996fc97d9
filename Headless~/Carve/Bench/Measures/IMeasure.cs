using System;
using System.Text.Json.Nodes;
using System.Threading;
using AnatomyCarve.Headless.Cli.Bench.Scenes;

namespace AnatomyCarve.Headless.Cli.Bench.Measures
{
    /// <summary>One line of the benchmark: a quantity and the way to measure it.</summary>
    interface IMeasure
    {
        Quantity Quantity { get; }

        /// <summary>Measures. Counts and errors are the same in every run; times are ratios of two that were taken by turns in this one.</summary>
        Outcome Run(MeasureContext context);
    }

    /// <summary>What is measured, and what is aimed at.</summary>
    /// <param name="Id">its id: P1, P2, ...</param>
    /// <param name="What">in words</param>
    /// <param name="Unit">unit of all its values: "%", "voxels", "degrees", "new/old", ...</param>
    /// <param name="Goals">the goal of each value, in the values' order</param>
    /// <param name="AtLeast">whether values are to be the goal at least; otherwise at most</param>
    sealed record Quantity(string Id, string What, string Unit, double[] Goals, bool AtLeast = false)
    {
        /// <summary>Whether it is a time, which differs from run to run; otherwise it is a count or an error.</summary>
        public bool IsTime => Unit == TimeUnit;

        /// <summary>The unit of ratios of times.</summary>
        public const string TimeUnit = "new/old";

        /// <summary>Which of the values are to be their goals at least, where they differ in that; null = all as AtLeast says.</summary>
        public bool[] AtLeastEach { get; init; }

        /// <summary>Whether a value is to be its goal at least; otherwise at most.</summary>
        public bool IsAtLeast(int value) => AtLeastEach?[value] ?? AtLeast;

        /// <summary>Whether all values reach their goals.</summary>
        public bool Holds(double[] values)
        {
            for (var value = 0; value < Goals.Length; value++)
            {
                // Written so that NaN does not hold.
                if (!(IsAtLeast(value) ? values[value] >= Goals[value] : values[value] <= Goals[value])) return false;
            }

            return true;
        }
    }

    /// <summary>What was found.</summary>
    /// <param name="Values">one number per goal; null = it was not measured</param>
    /// <param name="Scene">the scene's name in the scene file; several are separated by "; "</param>
    /// <param name="Settings">whatever else decides the values</param>
    /// <param name="Reason">why it was not measured; null = it was</param>
    sealed record Outcome(double[] Values, string Scene, JsonObject Settings, string Reason = null)
    {
        /// <summary>Separates the names of several scenes.</summary>
        public const string Separator = "; ";

        public static Outcome NotMeasured(string reason) => new(null, null, null, reason);
    }

    /// <summary>What a measure may use. There is one engine per process; measures run one after another.</summary>
    sealed record MeasureContext(BenchStage Stage, IProgress<float> Progress, CancellationToken Cancellation)
    {
        /// <summary>The scenes.</summary>
        public BenchScenes Scenes { get; init; }

        /// <summary>How often each way of a comparison of times is run; medians count.</summary>
        public int Runs { get; init; } = 5;

    }
}
