using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>Angles between normals as they are and as they ought to be, in degrees.</summary>
    sealed class AngleErrors
    {
        readonly List<double> angles = [];

        public int Count => angles.Count;

        public double Mean => angles.Count > 0 ? angles.Average() : double.NaN;

        public double Max => angles.Count > 0 ? angles.Max() : double.NaN;

        /// <summary>The angle that 99 of 100 do not pass.</summary>
        public double Percentile99 => angles.Count > 0 ? angles.Order().ElementAt((int)Math.Ceiling(0.99 * angles.Count) - 1) : double.NaN;

        /// <summary>Notes a normal; one that is missing (0, 0, 0) counts as 90 degrees.</summary>
        public void Add(VectorMm normal, VectorMm expected) => angles.Add(Degrees(normal, expected));

        public void Add(AngleErrors others) => angles.AddRange(others.angles);

        public JsonObject ToJson() => new() { ["normals"] = Count, ["mean"] = Mean, ["percentile99"] = Percentile99, ["max"] = Max };

        /// <summary>Exact for small angles too, for which a cosine is not.</summary>
        static double Degrees(VectorMm a, VectorMm b) =>
            a.LengthSquared > 0 ? Math.Atan2(a.Cross(b).Length, a.Dot(b)) * (180 / Math.PI) : 90;
    }
}
