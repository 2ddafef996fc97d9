using System;
using System.Reflection;

namespace AnatomyCarve.Headless.Cli.Bench.Work
{
    /// <summary>
    /// What not every state of the package has yet: a switch and counters of the skip structure, counts of sphere tests. Asked for by name, so that the benchmark
    /// also measures a package without them, and says what it could not measure.
    /// </summary>
    static class NewCounters
    {
        static readonly PropertyInfo Skip = typeof(RenderQuality).GetProperty("SkipEmptySpace");
        static readonly PropertyInfo Tests = typeof(RenderStatistics).GetProperty("SpheresInBricks");
        static readonly PropertyInfo BrickTests = typeof(RenderStatistics).GetProperty("SphereBrickTests");
        static readonly PropertyInfo Cleared = typeof(RenderStatistics).GetProperty("ClearBricks");
        static readonly PropertyInfo Cells = typeof(RenderStatistics).GetProperty("SkipCells");
        static readonly MethodInfo Lookups = typeof(CarvedPicture).GetMethod("ReadLookupCount", []);

        public const string NoSkipping = "This state of the package does not skip empty space.";
        public const string NoSphereTests = "This state of the package does not count sphere tests.";

        public static bool CanSkip => Skip != null;

        /// <summary>Switches skipping; where there is none it is off anyway.</summary>
        public static void SetSkipping(RenderQuality quality, bool on) => Skip?.SetValue(quality, on);

        /// <summary>Spheres that bricks were given, one by one; null = not counted.</summary>
        public static long? SpheresInBricks(RenderStatistics statistics) => Count(Tests, statistics);

        /// <summary>Tests of spheres against bricks on the CPU; null = not counted.</summary>
        public static long? SphereBrickTests(RenderStatistics statistics) => Count(BrickTests, statistics);

        /// <summary>The bricks that were emptied, as nothing in them is visible; null = there is no such stage.</summary>
        public static StageStatistics? ClearBricks(RenderStatistics statistics) => (StageStatistics?)Cleared?.GetValue(statistics);

        /// <summary>The work that keeps the skip structure in step; null = there is none.</summary>
        public static StageStatistics? SkipCells(RenderStatistics statistics) => (StageStatistics?)Cells?.GetValue(statistics);

        /// <summary>Look-ups in the skip structure; null = there is none.</summary>
        public static long? ReadLookupCount(CarvedPicture picture) => Lookups?.Invoke(picture, null) is { } value ? Convert.ToInt64(value) : null;

        static long? Count(PropertyInfo property, RenderStatistics statistics) => property?.GetValue(statistics) is { } value ? Convert.ToInt64(value) : null;
    }
}
