using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// Opacity by intensity: points, linear between them, constant outside. Two points of one value make a step; at the value
    /// itself the first of them counts. Opacity is that of a path of one reference length. Immutable.
    /// </summary>
    public sealed class OpacityTransferFunction
    {
        /// <summary>The number of entries of <see cref="Lookup"/>.</summary>
        public const int LookupSize = 4096;

        /// <summary>The range of a lookup that is nothing but a step, as a share of the step's value; kernels compute places in it with floats.</summary>
        const double SmallestRange = 1e-4;

        /// <summary>Stands for a step's value that is 0.</summary>
        const double SmallestValue = 10;

        readonly TransferPoint[] points;

        /// <summary>Makes a function from its points, in any order; points of one value keep their order.</summary>
        /// <exception cref="ArgumentException">No point.</exception>
        public OpacityTransferFunction(IEnumerable<TransferPoint> points)
        {
            this.points = (points ?? throw new ArgumentNullException(nameof(points))).OrderBy(point => point.Value).ToArray();
            if (this.points.Length == 0)
                throw new ArgumentException("A transfer function has at least one point.", nameof(points));
            Points = Array.AsReadOnly(this.points);
        }

        /// <summary>The points, ascending by value.</summary>
        public IReadOnlyList<TransferPoint> Points { get; }

        /// <summary>The value of the lookup's first entry: the first point's.</summary>
        public double LookupMin => points[0].Value;

        /// <summary>
        /// The value of the lookup's last entry: the last point's; equal to <see cref="LookupMin"/> for a constant. Where the function ends with a step
        /// it is a little larger, as what lies behind a step needs an entry of its own.
        /// </summary>
        public double LookupMax
        {
            get
            {
                if (!EndsWithStep)
                    return Last.Value;
                double range = Last.Value - LookupMin;
                return range > 0
                    ? Last.Value + range / (LookupSize - 2) // the last entry but one is the step's
                    : LookupMin + SmallestRange * (LookupMin != 0 ? Math.Abs(LookupMin) : SmallestValue);
            }
        }

        /// <summary>The function that is the same everywhere.</summary>
        /// <param name="opacity">0 to 1.</param>
        /// <exception cref="ArgumentException">The opacity is outside 0..1.</exception>
        public static OpacityTransferFunction Constant(double opacity) => new OpacityTransferFunction(new[] { new TransferPoint(0, opacity) });

        /// <summary>A function that shows the body and not the air around it; see <see cref="AutomaticTransferFunction"/>.</summary>
        public static OpacityTransferFunction Automatic(IntensityVolume volume) => AutomaticTransferFunction.For(volume);

        /// <summary>Reads "value:opacity,value:opacity,...", numbers in the invariant culture.</summary>
        /// <exception cref="AnatomyCarveException">The text is no such list; the message says which part.</exception>
        public static OpacityTransferFunction Parse(string text)
        {
            if (string.IsNullOrWhiteSpace(text))
                throw new AnatomyCarveException("A transfer function is written value:opacity,value:opacity,...; the text is empty.");
            var points = new List<TransferPoint>();
            foreach (string part in text.Split(','))
            {
                string[] numbers = part.Split(':');
                if (numbers.Length != 2 || !TryNumber(numbers[0], out double value) || !TryNumber(numbers[1], out double opacity))
                    throw new AnatomyCarveException($"\"{part}\" in \"{text}\" is no point of a transfer function; expected value:opacity, such as 150:0.2.");
                try
                {
                    points.Add(new TransferPoint(value, opacity));
                }
                catch (ArgumentException problem)
                {
                    throw new AnatomyCarveException($"\"{part}\" in \"{text}\" is no point of a transfer function: {problem.Message}", problem);
                }
            }

            return new OpacityTransferFunction(points);
        }

        /// <summary>The opacity of an intensity, 0 to 1; NaN has that of the lowest value.</summary>
        public double OpacityAt(double value)
        {
            int upper = 0;
            while (upper < points.Length && points[upper].Value < value)
                upper++;
            if (upper == 0)
                return points[0].Opacity;
            TransferPoint below = points[upper - 1];
            if (upper == points.Length)
                return below.Opacity;
            TransferPoint above = points[upper];
            if (above.Value == value)
                return above.Opacity;
            double share = (value - below.Value) / (above.Value - below.Value);
            return below.Opacity + (above.Opacity - below.Opacity) * share;
        }

        /// <summary>The function as a table for the GPU: entry e holds the opacity at LookupMin + (LookupMax - LookupMin) * e / (LookupSize - 1).</summary>
        /// <returns>A new array of <see cref="LookupSize"/> opacities.</returns>
        public float[] Lookup()
        {
            var table = new float[LookupSize];
            for (int entry = 0; entry < LookupSize - 1; entry++)
                table[entry] = (float)OpacityAt(LookupMin + (LookupMax - LookupMin) * entry / (LookupSize - 1));
            table[LookupSize - 1] = (float)Last.Opacity; // also that of all larger values
            return table;
        }

        /// <summary>The points as <see cref="Parse"/> reads them.</summary>
        public override string ToString() => string.Join(",", points);

        TransferPoint Last => points[points.Length - 1];

        bool EndsWithStep => points.Length > 1 && points[points.Length - 2].Value == Last.Value && OpacityAt(Last.Value) != Last.Opacity;

        static bool TryNumber(string text, out double number) =>
            double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out number);
    }
}
