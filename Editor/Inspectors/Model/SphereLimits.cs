using System;
using AnatomyCarve.Carving;

namespace AnatomyCarve.Editor
{
    /// <summary>Makes numbers that somebody typed into ones that a clip sphere can have; NaN counts as 0.</summary>
    static class SphereLimits
    {
        public static double Coordinate(double mm) => double.IsNaN(mm) ? 0 : Math.Max(-ClipSphere.LargestMm, Math.Min(mm, ClipSphere.LargestMm));

        public static double Radius(double mm) => Math.Max(0, Coordinate(mm));
    }
}
