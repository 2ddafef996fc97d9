using System;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// P9: how fast the ray sum comes nearer to the integral as steps get shorter: the slope of log error over log samples, by least squares.
    /// </summary>
    sealed class ConvergenceOrder : IMeasure
    {
        static readonly int[] Samples = [16, 32, 64, 128, 256, 512];

        public Quantity Quantity { get; } = new("P9", "order of convergence of the ray sum", "1", [1.95], AtLeast: true);

        public Outcome Run(MeasureContext context)
        {
            var errors = AnalyticRays.Measure(Samples).Select(error => error.Rms).ToArray();
            var settings = AnalyticRays.Settings();
            settings["samples"] = new JsonArray([.. Samples.Select(count => (JsonNode)count)]);
            settings["rmsErrors"] = new JsonArray([.. errors.Select(error => (JsonNode)error)]);
            return new Outcome([-Slope(errors)], AnalyticRays.Scene, settings);
        }

        static double Slope(double[] errors)
        {
            var (x, y) = (Samples.Select(count => Math.Log(count)).ToArray(), errors.Select(error => Math.Log(error)).ToArray());
            var (meanX, meanY) = (x.Average(), y.Average());
            return x.Zip(y, (a, b) => (a - meanX) * (b - meanY)).Sum() / x.Sum(a => (a - meanX) * (a - meanX));
        }
    }
}
