using System;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// The CPU twin of the kernel <c>AntiAlias</c>: FXAA (T. Lottes, "FXAA", NVIDIA 2009) carried to three dimensions. Where the 27 opacities around a
    /// voxel differ enough and have a gradient, the voxel is blended with those neighbours that lie along the surface; elsewhere, and in structures and gaps
    /// a few voxels thin, it stays as it is. In float, as the kernel; results agree within one 8-bit code.
    /// </summary>
    public static class AntiAlias
    {
        /// <summary>Opacities in a neighbourhood of 3 x 3 x 3 voxels.</summary>
        public const int Neighbourhood = 27;

        /// <summary>The voxel itself in a neighbourhood.</summary>
        public const int Centre = 13;

        /// <summary>
        /// Neighbours count as lying along the surface while the squared cosine of their angle to its normal is below this: within 35 degrees of the
        /// surface (the kernel's FLAT_LIMIT).
        /// </summary>
        public const float FlatLimit = 0.33f;

        /// <summary>
        /// A contrast that equals its threshold, but for rounding, is above it: 8-bit opacities meet thresholds exactly (the kernel's TIE).
        /// </summary>
        public const float Tie = 0.99999f;

        /// <summary>
        /// Of a neighbourhood less filled than this (its mean between its lowest and highest opacity) no opacity is lowered: it is a structure a few voxels
        /// thin. Beside gaps so thin none is raised (the kernel's THIN).
        /// </summary>
        public const float Thin = 0.46f;

        /// <summary>From <see cref="Thin"/> on, over so much more, the blend sets in (the kernel's THIN_RANGE).</summary>
        public const float ThinRange = 0.13f;

        /// <summary>The sum of the Sobel operator's weights on both sides, by which its gradient is divided.</summary>
        public const float SobelWeightSum = 32f;

        /// <summary>
        /// Gradients below this are none, but for rounding: half of the smallest that 8-bit opacities can have (the kernel's NO_GRADIENT).
        /// </summary>
        public const float NoGradient = (float)(0.5 / (255 * 32));

        /// <summary>The anti-aliased opacity of a voxel.</summary>
        /// <param name="o">
        /// The 27 opacities around it, 0 to 1, i fastest: o[(di + 1) + 3 * (dj + 1) + 9 * (dk + 1)]. Beyond the volume's border the nearest voxel counts.
        /// </param>
        /// <param name="settings">Thresholds and strength.</param>
        /// <returns>An opacity between the smallest and the largest of the 27.</returns>
        /// <exception cref="ArgumentException">There are not 27 opacities.</exception>
        /// <exception cref="ArgumentNullException"><paramref name="settings"/> is null.</exception>
        public static float Filter(ReadOnlySpan<float> o, AntiAliasSettings settings)
        {
            if (o.Length != Neighbourhood)
                throw new ArgumentException(FormattableString.Invariant($"A neighbourhood has 27 opacities, not {o.Length}."), nameof(o));
            if (settings == null)
                throw new ArgumentNullException(nameof(settings));
            float centre = o[Centre];
            float low = centre;
            float high = centre;
            float sum = 0;
            foreach (float opacity in o)
            {
                low = Math.Min(low, opacity);
                high = Math.Max(high, opacity);
                sum += opacity;
            }
            if (settings.Strength == 0 || high == low || high - low < Tie * Math.Max(settings.ThresholdAbsolute, settings.ThresholdRelative * high))
                return centre;
            Gradient(o, out float gx, out float gy, out float gz);
            float size = (float)Math.Sqrt(gx * gx + gy * gy + gz * gz);
            if (size < Math.Max(settings.GradientMinimum, NoGradient))
                return centre;
            float change = BlendAlongSurface(o, gx / size, gy / size, gz / size) - centre;
            float filled = (sum / Neighbourhood - low) / (high - low);
            float kept = Math.Max(0, Math.Min(1, ((change < 0 ? filled : 1 - filled) - Thin) / ThinRange));
            float result = centre + settings.Strength * kept * change;
            return Math.Max(low, Math.Min(high, result));
        }

        /// <summary>
        /// The Sobel gradient of a neighbourhood in opacity per voxel: weights 1 2 1 across, -1 0 1 along, divided by 32. Differences come first, so
        /// equal values on both sides give exactly 0.
        /// </summary>
        /// <param name="o">27 opacities as for <see cref="Filter"/>.</param>
        /// <param name="gx">Gradient along i; <paramref name="gy"/> along j, <paramref name="gz"/> along k.</param>
        /// <param name="gy">Gradient along j.</param>
        /// <param name="gz">Gradient along k.</param>
        public static void Gradient(ReadOnlySpan<float> o, out float gx, out float gy, out float gz)
        {
            gx = GradientAlong(o, 1, 3, 9);
            gy = GradientAlong(o, 3, 9, 1);
            gz = GradientAlong(o, 9, 1, 3);
        }

        static float GradientAlong(ReadOnlySpan<float> o, int along, int u, int v)
        {
            float sum = 0;
            for (int n = 0; n < 9; n++)
            {
                int a = n % 3, b = n / 3;
                float weight = (a == 1 ? 2 : 1) * (b == 1 ? 2 : 1);
                int low = a * u + b * v;
                sum = (float)(sum + weight * (float)(o[low + 2 * along] - o[low]));
            }
            return sum / SobelWeightSum;
        }

        static float BlendAlongSurface(ReadOnlySpan<float> o, float nx, float ny, float nz)
        {
            float sum = o[Centre];
            float weights = 1;
            for (int index = 0; index < Neighbourhood; index++)
            {
                if (index == Centre)
                    continue;
                int di = index % 3 - 1;
                int dj = index / 3 % 3 - 1;
                int dk = index / 9 - 1;
                float across = nx * di + ny * dj + nz * dk;
                float lengthSquared = di * di + dj * dj + dk * dk;
                float closeness = Math.Max(0, 1 - across * across / (lengthSquared * FlatLimit));
                float weight = closeness * closeness * (float)Math.Sqrt(lengthSquared);
                sum += weight * o[index];
                weights += weight;
            }
            return sum / weights;
        }
    }
}
