using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error.Reference
{
    /// <summary>
    /// Normals as Documentation~/architecture.md defines them, in double precision; the twin of Shaders/SobelNormals.compute, not stored in bytes.
    /// </summary>
    static class NormalReference
    {
        const int Reach = 3;

        /// <summary>Smaller gradients are rounding.</summary>
        const double NoGradient = 1e-12;

        /// <summary>The cosine of the angle between gradient and sphere within which a cut has the sphere's normal.</summary>
        const double Agreement = 0.9;

        static readonly double[] Smoothing = [63, 52, 29, 11], Derivative = [0, 29, 40, 32];

        static readonly double Sum = 2 * (Derivative[1] + 2 * Derivative[2] + 3 * Derivative[3]) * Math.Pow(Smoothing[0] + 2 * (Smoothing[1] + Smoothing[2] + Smoothing[3]), 2);

        /// <summary>A unit vector out of matter, LPS; (0, 0, 0) where the field is flat. Outside the volume opacity counts as 0.</summary>
        public static VectorMm At(ReferenceField field, int i, int j, int k)
        {
            double gx = 0, gy = 0, gz = 0;
            for (var dk = -Reach; dk <= Reach; dk++)
            {
                for (var dj = -Reach; dj <= Reach; dj++)
                {
                    for (var di = -Reach; di <= Reach; di++)
                    {
                        if (!field.Holds(i + di, j + dj, k + dk)) continue;
                        var opacity = field.AntiAliasedOf(i + di, j + dj, k + dk) / Sum;
                        gx += D(di) * S(dj) * S(dk) * opacity;
                        gy += S(di) * D(dj) * S(dk) * opacity;
                        gz += S(di) * S(dj) * D(dk) * opacity;
                    }
                }
            }

            if (gx * gx + gy * gy + gz * gz <= NoGradient * NoGradient) return default;
            var toIndex = field.Geometry.LpsToIjk; // its transpose takes gradients from index space to mm
            var normal = -new VectorMm(
                toIndex[0, 0] * gx + toIndex[1, 0] * gy + toIndex[2, 0] * gz,
                toIndex[0, 1] * gx + toIndex[1, 1] * gy + toIndex[2, 1] * gz,
                toIndex[0, 2] * gx + toIndex[1, 2] * gy + toIndex[2, 2] * gz).Normalized();
            return field.CutNormal(i, j, k) is { } cut && cut.Dot(normal) >= Agreement ? cut : normal;
        }

        static double D(int x) => Math.Sign(x) * Derivative[Math.Abs(x)];

        static double S(int x) => Smoothing[Math.Abs(x)];
    }
}
