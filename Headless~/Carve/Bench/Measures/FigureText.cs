using System;
using System.Globalization;
using System.Linq;

namespace AnatomyCarve.Headless.Cli.Bench.Measures
{
    /// <summary>Figures as people read them.</summary>
    static class FigureText
    {
        /// <summary>One line: P2 0.62 % of the volume (goal at most 1.5): holds; ...</summary>
        public static string Line(Figure figure, TimeSpan time)
        {
            var (quantity, outcome) = figure;
            var what = outcome.Values == null
                ? $"not measured: {outcome.Reason}"
                : $"{Values(outcome.Values)} {quantity.Unit} (goal {Goal(quantity)}): {(figure.Holds == true ? "holds" : "MISSED")}; {quantity.What}";
            return string.Create(CultureInfo.InvariantCulture, $"{quantity.Id,-3} {what} [{time.TotalSeconds:0.0} s]");
        }

        public static string Values(double[] values) => string.Join(" / ", values.Select(Number));

        public static string Goal(Quantity quantity) => quantity.AtLeastEach == null
            ? $"{Sense(quantity, 0)} {Values(quantity.Goals)}"
            : string.Join(" / ", quantity.Goals.Select((goal, n) => $"{Sense(quantity, n)} {Number(goal)}"));

        static string Sense(Quantity quantity, int value) => quantity.IsAtLeast(value) ? "at least" : "at most";

        public static string Number(double value) => Math.Abs(value) is >= 1000 and < 1e15
            ? value.ToString("0.##", CultureInfo.InvariantCulture)
            : value.ToString("G4", CultureInfo.InvariantCulture);
    }
}
