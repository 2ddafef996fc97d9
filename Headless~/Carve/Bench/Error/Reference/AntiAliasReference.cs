using System;
using AnatomyCarve.Carving;

namespace AnatomyCarve.Headless.Cli.Bench.Error.Reference
{
    /// <summary>
    /// Anti-aliasing as Documentation~/architecture.md defines it, in double precision; the twin of Shaders/AntiAlias.compute at its default settings.
    /// </summary>
    static class AntiAliasReference
    {
        const double FlatLimit = 0.33;
        const double Tie = 0.99999;
        const double Thin = 0.46, ThinRange = 0.13;

        public static double At(ReferenceField field, int i, int j, int k)
        {
            Span<double> o = stackalloc double[27];
            Neighbourhood(field, i, j, k, o);
            var centre = o[13];
            double low = centre, high = centre;
            foreach (var opacity in o) (low, high) = (Math.Min(low, opacity), Math.Max(high, opacity));
            var settings = AntiAliasSettings.Default;
            if (high == low || high - low < Tie * Math.Max(settings.ThresholdAbsolute, settings.ThresholdRelative * high)) return centre;
            var (gx, gy, gz) = Sobel.Gradient(o);
            var size = Math.Sqrt(gx * gx + gy * gy + gz * gz);
            if (size < settings.GradientMinimum) return centre;
            var change = Blend(o, gx / size, gy / size, gz / size) - centre;
            double mean = 0;
            foreach (var opacity in o) mean += opacity / 27;
            var filled = (mean - low) / (high - low);
            var kept = Math.Clamp(((change < 0 ? filled : 1 - filled) - Thin) / ThinRange, 0, 1);
            return Math.Clamp(centre + kept * change, low, high);
        }

        static void Neighbourhood(ReferenceField field, int i, int j, int k, Span<double> o)
        {
            for (var n = 0; n < 27; n++) o[n] = field.OpacityOf(i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1);
        }

        static double Blend(ReadOnlySpan<double> o, double nx, double ny, double nz)
        {
            double sum = o[13], weights = 1;
            for (var n = 0; n < 27; n++)
            {
                if (n == 13) continue;
                int x = n % 3 - 1, y = n / 3 % 3 - 1, z = n / 9 - 1;
                var along = nx * x + ny * y + nz * z;
                double lengthSquared = x * x + y * y + z * z;
                var closeness = Math.Max(0, 1 - along * along / (lengthSquared * FlatLimit));
                var weight = closeness * closeness * Math.Sqrt(lengthSquared);
                sum += weight * o[n];
                weights += weight;
            }

            return sum / weights;
        }
    }
}
