using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>Places the grid of an NRRD file in the patient, LPS millimetres.</summary>
    static class NrrdGeometry
    {
        /// <summary>The factors that turn x, y and z of an anatomical space into LPS.</summary>
        static readonly Dictionary<string, VectorMm> Spaces = new Dictionary<string, VectorMm>(StringComparer.OrdinalIgnoreCase)
        {
            { "left-posterior-superior", new VectorMm(1, 1, 1) }, { "LPS", new VectorMm(1, 1, 1) },
            { "right-anterior-superior", new VectorMm(-1, -1, 1) }, { "RAS", new VectorMm(-1, -1, 1) },
            { "left-anterior-superior", new VectorMm(1, -1, 1) }, { "LAS", new VectorMm(1, -1, 1) },
        };

        static readonly Dictionary<string, double> UnitsInMm = new Dictionary<string, double>
        {
            { "mm", 1 }, { "millimeter", 1 }, { "millimeters", 1 }, { "cm", 10 }, { "m", 1000 }, { "um", 0.001 }, { "\u00B5m", 0.001 }, { "micron", 0.001 }, { "microns", 0.001 },
        };

        /// <summary>The header's space directions, in the file's own space; null when there are none.</summary>
        internal static List<VectorMm?> Directions(NrrdHeader header, ReadContext context)
        {
            string text = header.Find("space directions");
            return text == null ? null : NrrdText.Vectors("space directions", text, context);
        }

        /// <summary>The grid's place.</summary>
        internal static VolumeGeometry Of(NrrdHeader header, NrrdAxes axes, IReadOnlyList<VectorMm?> directions, ReadContext context)
        {
            VectorMm signs = Signs(header, context) * UnitMm(header, context);
            var columns = new List<VectorMm>();
            foreach (int axis in axes.Spatial)
                columns.Add(Turned(directions?[axis] ?? AlongAxis(columns.Count, Spacing(header, axis, axes.Sizes.Length, context)), signs));
            if (columns.Count == 2)
                columns.Add(VectorMm.Cross(columns[0], columns[1]).Normalized());
            if (directions == null)
                context.Warn($"The header has no space directions: the axes are taken as they lie in the space, and without a space as left, posterior, superior.");
            Affine ijkToLps = Affine.FromColumns(columns[0], columns[1], columns[2], new PointMm(0, 0, 0) + Turned(Origin(header, context), signs));
            return context.MakeGeometry(axes.SizeOf(0), axes.SizeOf(1), axes.SizeOf(2), ijkToLps, "space directions");
        }

        /// <summary>Scales each coordinate; adding 0 turns -0 into 0.</summary>
        static VectorMm Turned(VectorMm vector, VectorMm signs) =>
            new VectorMm((vector.X * signs.X) + 0, (vector.Y * signs.Y) + 0, (vector.Z * signs.Z) + 0);

        static VectorMm AlongAxis(int n, double spacing) => new VectorMm(n == 0 ? spacing : 0, n == 1 ? spacing : 0, n == 2 ? spacing : 0);

        static VectorMm Signs(NrrdHeader header, ReadContext context)
        {
            string space = header.Find("space");
            string dimension = header.Find("space dimension");
            if (space != null && Spaces.TryGetValue(space, out VectorMm signs))
                return signs;
            bool hasTime = space != null && (space.EndsWith("time", StringComparison.OrdinalIgnoreCase) || (space.Length == 4 && space.EndsWith("T", StringComparison.OrdinalIgnoreCase)));
            if (hasTime || (dimension != null && dimension != "3"))
                throw context.Refusal(hasTime ? "space" : "space dimension", $"\"{NrrdHeader.Excerpt(hasTime ? space : dimension)}\"", "a space of three dimensions");
            if (space != null || dimension != null)
                context.Warn($"The space \"{NrrdHeader.Excerpt(space ?? "of " + dimension + " dimensions")}\" is not an anatomical one; it is taken as left-posterior-superior. Left and right may be exchanged.");
            return new VectorMm(1, 1, 1);
        }

        static double UnitMm(NrrdHeader header, ReadContext context)
        {
            string text = header.Find("space units");
            string[] units = text == null ? Array.Empty<string>() : NrrdText.Quoted(text).Where(unit => unit.Trim().Length > 0).Distinct().ToArray();
            if (units.Length == 0)
                return 1;
            if (units.Length == 1 && UnitsInMm.TryGetValue(units[0].Trim(), out double mm))
                return mm;
            context.Warn($"The space units {NrrdHeader.Excerpt(text)} are not known; millimetres are taken.");
            return 1;
        }

        static double Spacing(NrrdHeader header, int axis, int dimension, ReadContext context)
        {
            string text = header.Find("spacings");
            if (text == null)
                return 1;
            string[] words = NrrdText.Words(text);
            if (words.Length != dimension || !NrrdText.TryNumber(words[axis], out double spacing) || !double.IsFinite(spacing) || spacing == 0)
                throw context.Refusal("spacings", $"\"{NrrdHeader.Excerpt(text)}\"", FormattableString.Invariant($"{dimension} numbers, a finite one that is not 0 for each spatial axis"));
            return Math.Abs(spacing);
        }

        static VectorMm Origin(NrrdHeader header, ReadContext context)
        {
            string text = header.Find("space origin");
            if (text == null)
                return new VectorMm(0, 0, 0);
            List<VectorMm?> vectors = NrrdText.Vectors("space origin", text, context);
            if (vectors.Count != 1 || !vectors[0].HasValue || !vectors[0].Value.IsFinite)
                throw context.Refusal("space origin", $"\"{NrrdHeader.Excerpt(text)}\"", "one vector of three finite numbers");
            return vectors[0].Value;
        }
    }
}
