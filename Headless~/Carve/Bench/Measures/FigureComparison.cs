using System;
using System.Collections.Generic;
using System.Linq;

namespace AnatomyCarve.Headless.Cli.Bench.Measures
{
    /// <summary>How a figure stands to an older one.</summary>
    enum FigureTrend
    {
        /// <summary>Equal, or a time within the tolerance.</summary>
        Same,
        Better,
        Worse,

        /// <summary>It was measured then, and now it is not.</summary>
        Lost,

        /// <summary>It was not measured then.</summary>
        New,
    }

    /// <summary>One quantity then and now.</summary>
    sealed record FigureChange(Figure Old, Figure New, FigureTrend Trend)
    {
        public string Id => (New ?? Old).Quantity.Id;
    }

    /// <summary>
    /// Compares figures with older ones. Counts and errors are to be equal, but for six digits; ratios of times may be a fifth apart, as they swing from run to run.
    /// </summary>
    static class FigureComparison
    {
        /// <summary>A ratio of times that is larger by less than this is not worse.</summary>
        public const double TimeTolerance = 0.2;

        /// <summary>Files hold six digits.</summary>
        const double Digits = 1e-5;

        /// <summary>Every quantity that either has, in the order of the newer ones.</summary>
        public static IReadOnlyList<FigureChange> Compare(IReadOnlyList<Figure> old, IReadOnlyList<Figure> now)
        {
            var before = old.ToDictionary(figure => figure.Quantity.Id);
            var changes = now.Select(figure =>
            {
                var found = before.GetValueOrDefault(figure.Quantity.Id);
                return new FigureChange(found, figure, Trend(found, figure));
            }).ToList();
            var ids = now.Select(figure => figure.Quantity.Id).ToHashSet();
            changes.AddRange(old.Where(figure => !ids.Contains(figure.Quantity.Id))
                .Select(figure => new FigureChange(figure, null, figure.Outcome.Values == null ? FigureTrend.Same : FigureTrend.Lost)));
            return changes;
        }

        /// <summary>What got worse or was lost, a line each; then what got better.</summary>
        public static IEnumerable<string> Lines(IEnumerable<FigureChange> changes)
        {
            foreach (var change in changes.Where(change => change.Trend != FigureTrend.Same).OrderBy(change => change.Trend is FigureTrend.Worse or FigureTrend.Lost ? 0 : 1))
            {
                yield return $"{change.Trend.ToString().ToLowerInvariant(),-6} {change.Id,-3} {Value(change.Old)} -> {Value(change.New)} {(change.New ?? change.Old).Quantity.Unit}";
            }
        }

        static FigureTrend Trend(Figure old, Figure now)
        {
            if (old?.Outcome.Values == null) return now.Outcome.Values == null ? FigureTrend.Same : FigureTrend.New;
            if (now.Outcome.Values == null) return FigureTrend.Lost;
            if (old.Outcome.Values.Length != now.Outcome.Values.Length) return FigureTrend.New;
            var tolerance = now.Quantity.IsTime ? TimeTolerance : Digits;
            var trends = old.Outcome.Values.Select((value, n) => Trend(value, now.Outcome.Values[n], tolerance, now.Quantity.IsAtLeast(n))).ToArray();
            return trends.Contains(FigureTrend.Worse) ? FigureTrend.Worse : trends.Contains(FigureTrend.Better) ? FigureTrend.Better : FigureTrend.Same;
        }

        static FigureTrend Trend(double old, double now, double tolerance, bool atLeast)
        {
            if (old.Equals(now)) return FigureTrend.Same;
            if (double.IsNaN(now)) return FigureTrend.Worse;
            var margin = tolerance * Math.Max(Math.Abs(old), 1e-12);
            if (Math.Abs(now - old) <= margin) return FigureTrend.Same;
            return now > old == atLeast ? FigureTrend.Better : FigureTrend.Worse;
        }

        static string Value(Figure figure) => figure?.Outcome.Values == null ? "not measured" : FigureText.Values(figure.Outcome.Values);
    }
}
