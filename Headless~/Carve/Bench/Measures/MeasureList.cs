using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace AnatomyCarve.Headless.Cli.Bench.Measures
{
    /// <summary>All measures of this program, wherever they stand: every class that is one and can be made from nothing.</summary>
    static class MeasureList
    {
        /// <summary>In the order of their numbers.</summary>
        public static IReadOnlyList<IMeasure> All { get; } = typeof(MeasureList).Assembly.GetTypes()
            .Where(type => typeof(IMeasure).IsAssignableFrom(type) && type is { IsAbstract: false } && type.GetConstructor([]) != null)
            .Select(type => (IMeasure)Activator.CreateInstance(type))
            .Concat(LaterMeasure.All)
            .OrderBy(measure => Number(measure.Quantity.Id))
            .ToArray();

        /// <summary>Some of them.</summary>
        /// <exception cref="CommandException">An id is not known.</exception>
        public static IReadOnlyList<IMeasure> Only(IReadOnlyCollection<string> ids)
        {
            var unknown = ids.FirstOrDefault(id => All.All(measure => measure.Quantity.Id != id));
            if (unknown != null) throw new CommandException($"there is no measure \"{unknown}\"; the measures are {string.Join(", ", All.Select(measure => measure.Quantity.Id))}.");
            return All.Where(measure => ids.Contains(measure.Quantity.Id)).ToArray();
        }

        static int Number(string id) => int.Parse(id[1..], CultureInfo.InvariantCulture);
    }

    /// <summary>A quantity that nothing can be said about yet.</summary>
    sealed class LaterMeasure : IMeasure
    {
        readonly string reason;

        LaterMeasure(Quantity quantity, string reason) => (Quantity, this.reason) = (quantity, reason);

        public static IReadOnlyList<IMeasure> All { get; } =
        [
            new LaterMeasure(
                new Quantity("P24", "voxels whose ambient occlusion is recomputed for an edit of 5 mm", "%", [10]), "There is no ambient occlusion yet."),
            new LaterMeasure(
                new Quantity("P26", "peak memory while loading, in sizes of the voxels", "sizes", [1.5]), "Loading in streams comes with later work."),
            new LaterMeasure(
                new Quantity("P32", "readers against ITK and nibabel on the same files", Quantity.TimeUnit, [1]), "The comparison of readers comes with later work."),
        ];

        public Quantity Quantity { get; }

        public Outcome Run(MeasureContext context) => Outcome.NotMeasured(reason);
    }
}
