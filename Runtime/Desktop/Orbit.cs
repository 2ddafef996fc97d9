using System;
using UnityEngine;

namespace AnatomyCarve.Desktop
{
    /// <summary>
    /// A view's place on a sphere around a centre, and its smooth way to where it was sent. Angles are degrees, lengths world units. Knows no camera, so
    /// that it can be tested and used without one.
    /// </summary>
    public sealed class Orbit
    {
        // Nearer to its goal than this share of the distance, a view is there.
        const float Settled = 1e-6f;

        OrbitPose home;
        OrbitLimits limits = OrbitLimits.Default;

        /// <summary>Begins at a pose.</summary>
        public Orbit(OrbitPose start)
        {
            home = start;
            Goal = Current = Kept(start);
        }

        /// <summary>Where the view is.</summary>
        public OrbitPose Current { get; private set; }

        /// <summary>Where it goes.</summary>
        public OrbitPose Goal { get; private set; }

        /// <summary>What poses are possible; the goal is moved into them at once.</summary>
        /// <exception cref="ArgumentException">A limit is not finite, or a smallest value lies above its largest.</exception>
        public OrbitLimits Limits
        {
            get => limits;
            set
            {
                limits = value.Checked();
                Goal = Kept(Goal);
            }
        }

        /// <summary>Turns around the centre.</summary>
        /// <param name="yaw">Degrees; a positive one shows more of what was hidden behind the picture's left.</param>
        /// <param name="pitch">Degrees; a positive one shows more of what was hidden above.</param>
        public void Turn(float yaw, float pitch) => Go(new OrbitPose(Goal.Centre, Goal.Yaw + yaw, Goal.Pitch + pitch, Goal.Distance));

        /// <summary>Moves the centre, and the view with it, in the picture's plane.</summary>
        /// <param name="right">World units to the picture's right.</param>
        /// <param name="up">World units to the picture's upper edge.</param>
        public void Slide(float right, float up)
        {
            Quaternion rotation = Goal.Rotation;
            Go(new OrbitPose(Goal.Centre + rotation * new Vector3(right, up, 0f), Goal.Yaw, Goal.Pitch, Goal.Distance));
        }

        /// <summary>Changes the distance to the centre by a factor, within the limits: never through it.</summary>
        /// <param name="factor">Above 0; below 1 comes nearer.</param>
        public void Scale(float factor) => Go(new OrbitPose(Goal.Centre, Goal.Yaw, Goal.Pitch, Goal.Distance * factor));

        /// <summary>Sends the view to a pose, the shorter way round.</summary>
        public void Send(OrbitPose pose)
        {
            float turns = Mathf.Round((Goal.Yaw - pose.Yaw) / 360f);
            Go(new OrbitPose(pose.Centre, pose.Yaw + 360f * turns, pose.Pitch, pose.Distance));
        }

        /// <summary>Where <see cref="GoHome"/> leads from now on.</summary>
        public void SetHome(OrbitPose pose) => home = pose;

        /// <summary>Sends the view home.</summary>
        public void GoHome() => Send(home);

        /// <summary>Is at the goal at once.</summary>
        public void Arrive() => Current = Goal;

        /// <summary>
        /// Comes nearer to the goal: the way that is left shrinks to 1/e in each smooth time, so that the number of frames in between does not matter.
        /// </summary>
        /// <param name="seconds">Time that passed.</param>
        /// <param name="smoothTime">Seconds; 0 arrives at once.</param>
        public void Step(float seconds, float smoothTime)
        {
            float share = smoothTime > 0f ? 1f - Mathf.Exp(-seconds / smoothTime) : 1f;
            OrbitPose next = OrbitPose.Lerp(Current, Goal, share);
            Current = next.IsNear(Goal, Settled) ? Goal : next;
        }

        void Go(OrbitPose pose) => Goal = Kept(pose);

        OrbitPose Kept(OrbitPose pose) => new OrbitPose(
            pose.Centre, pose.Yaw, Mathf.Clamp(pose.Pitch, limits.MinPitch, limits.MaxPitch), Mathf.Clamp(pose.Distance, limits.MinDistance, limits.MaxDistance));
    }
}
