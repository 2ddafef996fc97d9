using AnatomyCarve.Headless.Cli.Bench.Measures;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>P10: the largest error of alpha or colour at 64 samples on rays whose integral is known.</summary>
    sealed class RayError : IMeasure
    {
        const int Samples = 64;

        public Quantity Quantity { get; } = new("P10", "error at 64 samples on an analytic ray", "of 1", [6e-5]);

        public Outcome Run(MeasureContext context)
        {
            var error = AnalyticRays.Measure([Samples])[0];
            var settings = AnalyticRays.Settings();
            settings["samples"] = Samples;
            settings["rmsError"] = error.Rms;
            settings["largestOfFirstOrderSum"] = AnalyticRays.FirstOrder(Samples).Largest;
            return new Outcome([error.Largest], AnalyticRays.Scene, settings);
        }
    }
}
