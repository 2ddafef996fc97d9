using AnatomyCarve.Picking;

namespace AnatomyCarve.Headless.Cli.Bench.Time
{
    /// <summary>The same rays again and again, but never equal: a picture that is asked for twice is not made twice.</summary>
    sealed class FreshRays(PictureRays rays)
    {
        const double LeastMm = 1e-9;

        int number;

        /// <summary>The rays; they begin some 1e-9 mm in front of the eye.</summary>
        public PictureRays Next() => rays.WithRange(LeastMm * ++number, rays.FarT);
    }
}
