using System;

namespace AnatomyCarve.Picking
{
    /// <summary>How a ray is marched and when something on it counts as visible: the same numbers for picture, pointer and reports.</summary>
    public sealed class RaySettings
    {
        /// <summary>
        /// Parts into which a step is cut where the first visible point is looked for: the depth of an edge is then found to a hundredth of a step.
        /// </summary>
        public const int PartsOfStep = 4;

        /// <summary>
        /// Where rays end unless told otherwise: what could still come is half a code of 8 bits at most, or one where it is twice as bright as white.
        /// </summary>
        public const double DefaultOpaqueAlpha = 1 - 1 / 512.0;

        double stepReference = 0.5;
        double firstVisibleAlpha = 0.5;
        double opaqueAlpha = DefaultOpaqueAlpha;

        /// <summary>The step in reference lengths (the smallest voxel spacing): above 0, finite. 0.5 unless set.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The step lies outside its range.</exception>
        public double StepReference
        {
            get => stepReference;
            set
            {
                if (!(value > 0) || double.IsInfinity(value))
                    throw new ArgumentOutOfRangeException(nameof(value), value, "The step is above 0 reference lengths and finite.");
                stepReference = value;
            }
        }

        /// <summary>The accumulated alpha at which the first visible segment is found: above 0, below 1. 0.5 unless set.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The alpha lies outside its range.</exception>
        public double FirstVisibleAlpha
        {
            get => firstVisibleAlpha;
            set
            {
                if (!(value > 0 && value < 1))
                    throw new ArgumentOutOfRangeException(nameof(value), value, "The alpha is above 0 and below 1.");
                firstVisibleAlpha = value;
            }
        }

        /// <summary>The accumulated alpha at which a ray ends: above 0, at most 1. <see cref="DefaultOpaqueAlpha"/> unless set.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The alpha lies outside its range.</exception>
        public double OpaqueAlpha
        {
            get => opaqueAlpha;
            set
            {
                if (!(value > 0 && value <= 1))
                    throw new ArgumentOutOfRangeException(nameof(value), value, "The alpha is above 0 and at most 1.");
                opaqueAlpha = value;
            }
        }
    }
}
