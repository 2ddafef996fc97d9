using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Editor
{
    /// <summary>What the Editor writes about a clip sphere.</summary>
    static class SphereTexts
    {
        /// <summary>"Active", or "Sphere 3" for the third one that was fixed.</summary>
        public static string Title(int index, bool isActive) => isActive ? "Active" : FormattableString.Invariant($"Sphere {index + 1}");

        /// <summary>Such as "47.5 mm".</summary>
        public static string Radius(ClipSphere sphere) => FormattableString.Invariant($"{sphere.RadiusMm:0.##} mm");

        /// <summary>Such as "60 L, 4 P, 20 S": millimetres to the left or right, back or front, head or feet.</summary>
        public static string Centre(ClipSphere sphere)
        {
            PointMm c = sphere.CentreLps;
            return Along(c.X, 'L', 'R') + ", " + Along(c.Y, 'P', 'A') + ", " + Along(c.Z, 'S', 'I');
        }

        /// <summary>Such as "117 of 118".</summary>
        public static string Clipped(ClipSphere sphere) => FormattableString.Invariant($"{sphere.Mask.ClippedCount} of {sphere.Mask.SegmentCount}");

        static string Along(double mm, char positive, char negative) =>
            FormattableString.Invariant($"{Math.Abs(mm):0.#} {(mm >= 0 ? positive : negative)}");
    }
}
