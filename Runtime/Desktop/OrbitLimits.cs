using System;
using UnityEngine;

namespace AnatomyCarve.Desktop
{
    /// <summary>What poses an orbit has.</summary>
    [Serializable]
    public struct OrbitLimits
    {
        /// <summary>The smallest <see cref="MinDistance"/>: a view that stood in the centre would look nowhere.</summary>
        public const float SmallestDistance = 1e-4f;

        [SerializeField, Min(SmallestDistance), Tooltip("How near the view comes, in world units")]
        float minDistance;

        [SerializeField, Min(SmallestDistance), Tooltip("How far the view goes, in world units")]
        float maxDistance;

        [SerializeField, Range(-90f, 90f), Tooltip("How far it looks up, in degrees; -90 = straight up")]
        float minPitch;

        [SerializeField, Range(-90f, 90f), Tooltip("How far it looks down, in degrees; 90 = straight down")]
        float maxPitch;

        /// <summary>Takes the limits.</summary>
        /// <exception cref="ArgumentException">A limit is not finite or outside its range, or a smallest value lies above its largest.</exception>
        public OrbitLimits(float minDistance, float maxDistance, float minPitch = -89f, float maxPitch = 89f)
        {
            this.minDistance = minDistance;
            this.maxDistance = maxDistance;
            this.minPitch = minPitch;
            this.maxPitch = maxPitch;
            Checked();
        }

        /// <summary>From 5 cm to 10 m, and from below to above.</summary>
        public static OrbitLimits Default => new OrbitLimits(0.05f, 10f);

        /// <summary>How near the view comes, in world units, above 0.</summary>
        public float MinDistance => minDistance;

        /// <summary>How far the view goes, in world units.</summary>
        public float MaxDistance => maxDistance;

        /// <summary>How far it looks up, in degrees, -90 to 90; negative looks up.</summary>
        public float MinPitch => minPitch;

        /// <summary>How far it looks down, in degrees, -90 to 90.</summary>
        public float MaxPitch => maxPitch;

        /// <summary>The same limits made possible: what an Inspector's fields may hold is not.</summary>
        internal OrbitLimits Clamped()
        {
            float near = Mathf.Max(SmallestDistance, minDistance);
            float low = Mathf.Clamp(minPitch, -90f, 90f);
            return new OrbitLimits(near, Mathf.Max(near, maxDistance), low, Mathf.Clamp(maxPitch, low, 90f));
        }

        internal OrbitLimits Checked()
        {
            if (!(minDistance >= SmallestDistance && maxDistance >= minDistance) || float.IsInfinity(maxDistance))
                throw new ArgumentException(FormattableString.Invariant(
                    $"The distances {minDistance} to {maxDistance} are no range of finite numbers from {SmallestDistance} on."));
            if (!(minPitch >= -90f && maxPitch >= minPitch && maxPitch <= 90f))
                throw new ArgumentException(FormattableString.Invariant($"The angles {minPitch} to {maxPitch} are no range within -90 to 90 degrees."));
            return this;
        }
    }
}
