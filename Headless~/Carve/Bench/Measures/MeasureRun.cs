using System;
using System.Collections.Generic;
using System.Diagnostics;

namespace AnatomyCarve.Headless.Cli.Bench.Measures
{
    /// <summary>Runs measures one after another.</summary>
    static class MeasureRun
    {
        /// <param name="measures">which</param>
        /// <param name="context">what they use</param>
        /// <param name="bars">shows how far it is</param>
        /// <param name="note">told after each: the figure and how long it took</param>
        public static IReadOnlyList<Figure> Run(IReadOnlyList<IMeasure> measures, MeasureContext context, ProgressBars bars, Action<Figure, TimeSpan> note)
        {
            var figures = new List<Figure>();
            foreach (var measure in measures)
            {
                context.Cancellation.ThrowIfCancellationRequested();
                var clock = Stopwatch.StartNew();
                var figure = new Figure(measure.Quantity, bars.Step(measure.Quantity.Id, progress => measure.Run(context with { Progress = progress })));
                context.Stage.ThrowIfFailed();
                Check(figure);
                figures.Add(figure);
                note(figure, clock.Elapsed);
            }

            return figures;
        }

        static void Check(Figure figure)
        {
            var (quantity, outcome) = figure;
            if (outcome.Values == null ? outcome.Reason == null : outcome.Values.Length != quantity.Goals.Length || outcome.Scene == null)
            {
                throw new InvalidOperationException($"{quantity.Id} gave neither a value per goal with its scene, nor a reason");
            }
        }
    }
}
