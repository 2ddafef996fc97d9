using UnityEngine;

namespace AnatomyCarve.Desktop
{
    /// <summary>Where a view looks from: a centre, two angles and a distance.</summary>
    public readonly struct OrbitPose
    {
        /// <summary>Takes the values as they are.</summary>
        /// <param name="centre">What is looked at.</param>
        /// <param name="yaw">Angle about the vertical axis, degrees: 0 looks along +z, 90 along +x.</param>
        /// <param name="pitch">Angle downwards, degrees: 90 looks straight down.</param>
        /// <param name="distance">From the view to the centre.</param>
        public OrbitPose(Vector3 centre, float yaw, float pitch, float distance)
        {
            Centre = centre;
            Yaw = yaw;
            Pitch = pitch;
            Distance = distance;
        }

        /// <summary>What is looked at.</summary>
        public Vector3 Centre { get; }

        /// <summary>Angle about the vertical axis, degrees: 0 looks along +z, 90 along +x.</summary>
        public float Yaw { get; }

        /// <summary>Angle downwards, degrees.</summary>
        public float Pitch { get; }

        /// <summary>From the view to the centre.</summary>
        public float Distance { get; }

        /// <summary>The view's rotation.</summary>
        public Quaternion Rotation => Quaternion.Euler(Pitch, Yaw, 0f);

        /// <summary>The pose of a view that looks at a centre from where it stands. One that stands in the centre keeps its direction.</summary>
        /// <param name="position">The view's place.</param>
        /// <param name="rotation">The view's rotation.</param>
        /// <param name="centre">What it is to look at.</param>
        public static OrbitPose Looking(Vector3 position, Quaternion rotation, Vector3 centre)
        {
            Vector3 to = centre - position;
            float distance = to.magnitude;
            Vector3 direction = distance > 1e-6f ? to / distance : rotation * Vector3.forward;
            float pitch = -Mathf.Asin(Mathf.Clamp(direction.y, -1f, 1f)) * Mathf.Rad2Deg;
            bool isVertical = Mathf.Abs(direction.x) < 1e-6f && Mathf.Abs(direction.z) < 1e-6f;
            float yaw = isVertical ? rotation.eulerAngles.y : Mathf.Atan2(direction.x, direction.z) * Mathf.Rad2Deg;
            return new OrbitPose(centre, yaw, pitch, distance);
        }

        /// <summary>On the way from one pose to another; distances grow by equal factors.</summary>
        public static OrbitPose Lerp(OrbitPose from, OrbitPose to, float share) => new OrbitPose(
            Vector3.LerpUnclamped(from.Centre, to.Centre, share),
            Mathf.LerpUnclamped(from.Yaw, to.Yaw, share),
            Mathf.LerpUnclamped(from.Pitch, to.Pitch, share),
            from.Distance > 0f && to.Distance > 0f
                ? from.Distance * Mathf.Pow(to.Distance / from.Distance, share)
                : Mathf.LerpUnclamped(from.Distance, to.Distance, share));

        /// <summary>The view's place.</summary>
        /// <param name="distance">How far from the centre it is to stand.</param>
        public Vector3 Position(float distance) => Centre - Rotation * new Vector3(0f, 0f, distance);

        /// <summary>The pose from which all of a ball is seen.</summary>
        /// <param name="centre">The ball's centre.</param>
        /// <param name="radius">The ball's radius, 0 or more.</param>
        /// <param name="verticalFov">The picture's angle from the lower to the upper edge, degrees.</param>
        /// <param name="aspect">The picture's width over its height.</param>
        public OrbitPose Framing(Vector3 centre, float radius, float verticalFov, float aspect)
        {
            float half = 0.5f * verticalFov * Mathf.Deg2Rad;
            float narrower = Mathf.Atan(Mathf.Tan(half) * Mathf.Min(1f, aspect));
            return new OrbitPose(centre, Yaw, Pitch, radius / Mathf.Sin(narrower));
        }

        /// <summary>Whether another pose differs by less than a share of the distance, and of a turn.</summary>
        internal bool IsNear(OrbitPose other, float share) =>
            (Centre - other.Centre).magnitude <= share * other.Distance && Mathf.Abs(Yaw - other.Yaw) <= 360f * share
            && Mathf.Abs(Pitch - other.Pitch) <= 360f * share && Mathf.Abs(Distance - other.Distance) <= share * other.Distance;
    }
}
