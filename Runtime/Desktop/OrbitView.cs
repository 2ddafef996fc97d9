using System;
using UnityEngine;
using UnityEngine.InputSystem;

namespace AnatomyCarve.Desktop
{
    /// <summary>
    /// Turns the camera on its GameObject around a target by mouse and keys: right button turns, middle button slides, the wheel comes nearer, Home goes
    /// back. Works with perspective and parallel cameras, in unscaled time. The camera is its own while it is enabled.
    /// </summary>
    [AddComponentMenu("AnatomyCarve/Orbit View")]
    [RequireComponent(typeof(Camera))]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(-30)] // before those that look through the camera
    [ManualPage("components")]
    public sealed class OrbitView : MonoBehaviour
    {
        [SerializeField, Tooltip("What is looked at, the volume as a rule; empty = the point below")]
        Transform target;

        [SerializeField, Tooltip("What is looked at where there is no target, in world space")]
        Vector3 targetPoint;

        [SerializeField, Tooltip("How near, far, low and high the view goes")]
        OrbitLimits limits = OrbitLimits.Default;

        [SerializeField, Range(10f, 720f), Tooltip("Degrees that a drag over the whole height of the picture turns")]
        float degreesPerHeight = 180f;

        [SerializeField, Range(0.01f, 1f), Tooltip("How much nearer a notch of the wheel comes, as a share of the distance")]
        float zoomPerNotch = 0.12f;

        [SerializeField, Range(1f, 360f), Tooltip("Degrees that a key turns in a second")]
        float degreesPerSecond = 90f;

        [SerializeField, Range(0f, 1f), Tooltip("Seconds in which about two thirds of a movement are made; 0 = at once")]
        float smoothTime = 0.08f;

        [SerializeField, Tooltip("Other controls: a map 'Desktop' with the actions of the package's own; empty = those")]
        InputActionAsset controls;

        [SerializeField, Tooltip("Says when mouse and keys belong to something else; empty = never")]
        InputGate gate;

        Camera view;
        Orbit orbit;
        OrbitControls input;
        float standOff;

        /// <summary>What is looked at; null = <see cref="TargetPoint"/>.</summary>
        public Transform Target { get => target; set => target = value; }

        /// <summary>What is looked at where there is no target, in world space.</summary>
        public Vector3 TargetPoint { get => targetPoint; set => targetPoint = value; }

        /// <summary>How near, far, low and high the view goes.</summary>
        /// <exception cref="ArgumentException">The limits are none.</exception>
        public OrbitLimits Limits
        {
            get => limits;
            set
            {
                limits = value.Checked();
                if (orbit != null)
                    orbit.Limits = limits;
            }
        }

        /// <summary>Degrees that a drag over the whole height of the picture turns: 10 to 720.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float DegreesPerHeight { get => degreesPerHeight; set => degreesPerHeight = SettingRange.Checked(value, 10f, 720f, nameof(DegreesPerHeight)); }

        /// <summary>How much nearer a notch of the wheel comes, as a share of the distance: 0.01 to 1.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float ZoomPerNotch { get => zoomPerNotch; set => zoomPerNotch = SettingRange.Checked(value, 0.01f, 1f, nameof(ZoomPerNotch)); }

        /// <summary>Degrees that a key turns in a second: 1 to 360.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float DegreesPerSecond { get => degreesPerSecond; set => degreesPerSecond = SettingRange.Checked(value, 1f, 360f, nameof(DegreesPerSecond)); }

        /// <summary>Seconds in which about two thirds of a movement are made, 0 to 1; 0 = at once.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float SmoothTime
        {
            get => smoothTime;
            set => smoothTime = SettingRange.Checked(value, 0f, 1f, nameof(SmoothTime));
        }

        /// <summary>Other controls than the package's; taken when the component is enabled. Null = the package's.</summary>
        public InputActionAsset Controls { get => controls; set => controls = value; }

        /// <summary>Says when mouse and keys belong to something else; null = never.</summary>
        public InputGate Gate { get => gate; set => gate = value; }

        /// <summary>The pose that the view is in, its centre relative to the target; null before it was enabled.</summary>
        public OrbitPose? Pose => orbit?.Current;

        Vector3 Origin => target != null ? target.position : targetPoint;

        /// <summary>Sends the view to where all of a box is seen, in the direction that it looks in. The Home key leads there from then on.</summary>
        /// <param name="bounds">The box in world space.</param>
        public void Frame(Bounds bounds)
        {
            Begin();
            OrbitPose pose = orbit.Goal.Framing(bounds.center - Origin, bounds.extents.magnitude, view.fieldOfView, view.aspect);
            standOff = Mathf.Max(standOff, pose.Distance);
            orbit.SetHome(pose);
            orbit.Send(pose);
        }

        /// <summary>Sends the view to where it looks from an angle.</summary>
        /// <param name="yaw">About the vertical axis, degrees: 0 looks along +z, which is the face of a patient who was not turned; 90 along +x.</param>
        /// <param name="pitch">Downwards, degrees.</param>
        public void LookFrom(float yaw, float pitch)
        {
            Begin();
            orbit.Send(new OrbitPose(orbit.Goal.Centre, yaw, pitch, orbit.Goal.Distance));
        }

        /// <summary>Sends the view back: to where it was when it was first enabled, or to what <see cref="Frame"/> showed last.</summary>
        public void GoHome()
        {
            Begin();
            orbit.GoHome();
        }

        /// <summary>One frame of the given length; called from LateUpdate.</summary>
        internal void Tick(float seconds)
        {
            input.Apply(orbit, view, gate, seconds, degreesPerHeight, zoomPerNotch, degreesPerSecond);
            orbit.Step(seconds, smoothTime);
            Show();
        }

        void OnEnable()
        {
            input = new OrbitControls(controls, this);
            if (!input.Enable())
            {
                enabled = false;
                return;
            }
            Begin();
        }

        void OnDisable() => input?.Release();

        void LateUpdate() => Tick(Time.unscaledDeltaTime);

        void OnValidate()
        {
            limits = limits.Clamped();
            degreesPerHeight = Mathf.Clamp(degreesPerHeight, 10f, 720f);
            zoomPerNotch = Mathf.Clamp(zoomPerNotch, 0.01f, 1f);
            degreesPerSecond = Mathf.Clamp(degreesPerSecond, 1f, 360f);
            smoothTime = Mathf.Clamp01(smoothTime);
            if (orbit != null)
                orbit.Limits = limits;
        }

        /// <summary>The first time: from where the camera stands.</summary>
        void Begin()
        {
            if (orbit != null)
                return;
            view = GetComponent<Camera>();
            OrbitPose seen = OrbitPose.Looking(transform.position, transform.rotation, Origin);
            standOff = seen.Distance;
            if (view.orthographic)
                seen = new OrbitPose(seen.Centre, seen.Yaw, seen.Pitch, 2f * view.orthographicSize / PictureRay.PerspectiveHeight(view, 1f));
            orbit = new Orbit(new OrbitPose(Vector3.zero, seen.Yaw, seen.Pitch, seen.Distance)) { Limits = limits };
            orbit.Arrive();
        }

        /// <summary>A parallel camera stays where nothing is behind it, and changes its size instead.</summary>
        void Show()
        {
            OrbitPose pose = orbit.Current;
            if (view.orthographic)
                view.orthographicSize = 0.5f * PictureRay.PerspectiveHeight(view, pose.Distance);
            float distance = view.orthographic ? standOff : pose.Distance;
            transform.SetPositionAndRotation(Origin + pose.Position(distance), pose.Rotation);
        }
    }
}
