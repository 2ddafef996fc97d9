using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error.Reference
{
    /// <summary>
    /// Normals as Documentation~/architecture.md defines them, in double precision; the twin of Shaders/SobelNormals.compute, not stored in bytes.
    /// </summary>
    static class NormalReference
    {
        /// <summary>Smaller gradients are rounding.</summary>
        const double NoGradient = 1e-12;

        /// <summary>A unit vector out of matter, LPS; (0, 0, 0) where the field is flat. Outside the volume opacity counts as 0.</summary>
        public static VectorMm At(ReferenceField field, int i, int j, int k)
        {
            Span<double> o = stackalloc double[27];
            for (var n = 0; n < 27; n++)
            {
                int vi = i + n % 3 - 1, vj = j + n / 3 % 3 - 1, vk = k + n / 9 - 1;
                o[n] = field.Holds(vi, vj, vk) ? field.AntiAliasedOf(vi, vj, vk) : 0;
            }

            var (gx, gy, gz) = Sobel.Gradient(o);
            if (gx * gx + gy * gy + gz * gz < NoGradient * NoGradient) return default;
            var toIndex = field.Geometry.LpsToIjk; // its transpose takes gradients from index space to mm
            return -new VectorMm(
                toIndex[0, 0] * gx + toIndex[1, 0] * gy + toIndex[2, 0] * gz,
                toIndex[0, 1] * gx + toIndex[1, 1] * gy + toIndex[2, 1] * gz,
                toIndex[0, 2] * gx + toIndex[1, 2] * gy + toIndex[2, 2] * gz).Normalized();
        }
    }
}
