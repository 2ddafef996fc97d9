using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>Which axes of an NRRD array are those of the grid, and which one holds the values of a voxel.</summary>
    sealed class NrrdAxes
    {
        /// <summary>The largest number of axes that the format allows.</summary>
        const int LargestDimension = 16;

        /// <summary>Kinds of axes that lie in space; any other known kind numbers the values of a voxel.</summary>
        static readonly HashSet<string> SpatialKinds = new HashSet<string> { "domain", "space", "none", "???" };

        NrrdAxes(long[] sizes, int[] spatial, ReadContext context)
        {
            Sizes = sizes;
            Spatial = spatial;
            int[] others = Enumerable.Range(0, sizes.Length).Except(spatial).ToArray();
            bool first = others.All(axis => axis < spatial[0]);
            if (!first && !others.All(axis => axis > spatial[spatial.Length - 1]))
                throw context.Refusal("space directions", $"those of axes {string.Join(", ", spatial)} of {sizes.Length}", "the three spatial axes next to each other");
            Order = first ? ComponentOrder.Fastest : ComponentOrder.Slowest;
            Components = Product(others.Select(axis => sizes[axis]), sizes, context);
            Count = Product(sizes, sizes, context);
        }

        /// <summary>The sizes of all axes, the fastest first.</summary>
        internal long[] Sizes { get; }

        /// <summary>The two or three axes of the grid.</summary>
        internal int[] Spatial { get; }

        /// <summary>Values per voxel.</summary>
        internal long Components { get; }

        /// <summary>Where the values of a voxel lie.</summary>
        internal ComponentOrder Order { get; }

        /// <summary>The number of values in the file.</summary>
        internal long Count { get; }

        /// <summary>The size of a spatial axis, n = 0 to 2; 1 for the third axis of a flat image.</summary>
        internal int SizeOf(int n) => n < Spatial.Length ? (int)Sizes[Spatial[n]] : 1;

        /// <summary>Finds the axes.</summary>
        /// <param name="directions">One per axis, null for an axis that isn't spatial; null when the header gives none.</param>
        internal static NrrdAxes Of(NrrdHeader header, IReadOnlyList<VectorMm?> directions, ReadContext context)
        {
            long[] sizes = ReadSizes(header, context);
            int[] spatial;
            if (directions == null)
                spatial = SpatialByKind(header, sizes.Length, context);
            else if (directions.Count == sizes.Length)
                spatial = Enumerable.Range(0, sizes.Length).Where(axis => directions[axis].HasValue).ToArray();
            else
                throw context.Refusal("space directions", $"a list of {directions.Count}", FormattableString.Invariant($"one vector (or none) for each of {sizes.Length} axes"));
            if (spatial.Length < 2 || spatial.Length > 3)
                throw context.Refusal("dimension", $"{spatial.Length} spatial axes", "three (or two, for one slice)");
            return new NrrdAxes(sizes, spatial, context);
        }

        static long[] ReadSizes(NrrdHeader header, ReadContext context)
        {
            string dimensionText = header.Require("dimension");
            if (!NrrdText.TryWhole(dimensionText, out long dimension) || dimension < 1 || dimension > LargestDimension)
                throw context.Refusal("dimension", $"\"{NrrdHeader.Excerpt(dimensionText)}\"", FormattableString.Invariant($"1 to {LargestDimension}"));
            string[] words = NrrdText.Words(header.Require("sizes"));
            if (words.Length != dimension)
                throw context.Refusal("sizes", $"a list of {words.Length}", FormattableString.Invariant($"{dimension} sizes, as dimension says"));
            var sizes = new long[words.Length];
            for (int axis = 0; axis < sizes.Length; axis++)
                if (!NrrdText.TryWhole(words[axis], out sizes[axis]) || sizes[axis] < 1)
                    throw context.Refusal("sizes", $"\"{NrrdHeader.Excerpt(words[axis])}\" for axis {axis}", "a whole number of at least 1");
            return sizes;
        }

        /// <summary>Without directions: by the axes' kinds, then by spacings (NaN for axes that aren't spatial), then the first three.</summary>
        static int[] SpatialByKind(NrrdHeader header, int dimension, ReadContext context)
        {
            string[] kinds = NrrdText.Words((header.Find("kinds") ?? string.Empty).ToLowerInvariant());
            string[] spacings = NrrdText.Words(header.Find("spacings") ?? string.Empty);
            bool knowsKinds = kinds.Length == dimension;
            bool knowsSpacings = spacings.Length == dimension;
            int[] spatial = Enumerable.Range(0, dimension)
                .Where(axis => !knowsKinds || SpatialKinds.Contains(kinds[axis]))
                .Where(axis => !knowsSpacings || !(NrrdText.TryNumber(spacings[axis], out double spacing) && double.IsNaN(spacing)))
                .ToArray();
            if (spatial.Length <= 3 || (knowsKinds && kinds.All(kind => kind == "domain" || kind == "space")))
                return spatial;
            context.Warn($"The header doesn't say which of its {dimension} axes are spatial; the first three are taken.");
            return new[] { 0, 1, 2 };
        }

        static long Product(IEnumerable<long> factors, long[] sizes, ReadContext context)
        {
            long product = 1;
            foreach (long factor in factors)
            {
                if (factor > VoxelBlocks.LargestCount / product)
                    throw context.Refusal("sizes", $"{string.Join(" x ", sizes)}", FormattableString.Invariant($"at most {VoxelBlocks.LargestCount} values"));
                product *= factor;
            }

            return product;
        }
    }
}
