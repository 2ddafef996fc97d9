using System;
using UnityEngine;
using UnityEngine.InputSystem;

namespace AnatomyCarve.Desktop
{
    /// <summary>
    /// Carves with mouse and keys. While Shift is held the active sphere follows the mouse in a plane parallel to the picture, and the wheel resizes it;
    /// keys move, push and resize it, fix it, remove the last fixed one, reset the mask, undo and redo. Where there is no sphere yet, the first move makes
    /// one. Whatever is done until Shift, or the last of the moving keys, is let go is one step to undo.
    /// </summary>
    [AddComponentMenu("AnatomyCarve/Mouse Sphere")]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(-20)] // after the view, before what points and what renders
    [ManualPage("components")]
    public sealed class MouseSphere : MonoBehaviour
    {
        [SerializeField, Tooltip("The camera whose picture the mouse is in; empty = the one on this GameObject")]
        Camera view;

        [SerializeField, Tooltip("The carving; empty = the one on this GameObject")]
        ClipSphereStack stack;

        [SerializeField, Tooltip("Finds the surface that a new drag starts on; empty = the one on this GameObject, if there is one")]
        SegmentPointer pointer;

        [SerializeField, Range(0.01f, 1f), Tooltip("How much larger a notch of the wheel makes the sphere, as a share of its radius")]
        float growthPerNotch = 0.1f;

        [SerializeField, Range(0.05f, 2f), Tooltip("How far keys move the sphere in a second, as a share of the picture's height")]
        float heightsPerSecond = 0.3f;

        [SerializeField, Range(0.05f, 5f), Tooltip("How much larger keys make the sphere in a second, as a share of its radius")]
        float growthPerSecond = 0.8f;

        [SerializeField, Tooltip("Other controls: a map 'Desktop' with the actions of the package's own; empty = those")]
        InputActionAsset controls;

        [SerializeField, Tooltip("Says when mouse and keys belong to something else; empty = never")]
        InputGate gate;

        readonly SphereDrag drag = new SphereDrag();
        readonly SphereGesture gesture = new SphereGesture();
        SphereControls input;
        bool holds;

        /// <summary>The camera whose picture the mouse is in: the one that was set, or else the one on this GameObject.</summary>
        public Camera View
        {
            get => this.WiredOrSibling(view);
            set => view = value;
        }

        /// <summary>The carving: the one that was set, or else the one on this GameObject.</summary>
        public ClipSphereStack Stack
        {
            get => this.WiredOrSibling(stack);
            set => stack = value;
        }

        /// <summary>
        /// Finds the surface that a new drag starts on: the one that was set, or else the one on this GameObject. Null = the sphere never comes to the
        /// surface by itself.
        /// </summary>
        public SegmentPointer Pointer
        {
            get => this.WiredOrSibling(pointer);
            set => pointer = value;
        }

        /// <summary>How much larger a notch of the wheel makes the sphere, as a share of its radius: 0.01 to 1.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float GrowthPerNotch
        {
            get => growthPerNotch;
            set => growthPerNotch = SettingRange.Checked(value, 0.01f, 1f, nameof(GrowthPerNotch));
        }

        /// <summary>How far keys move the sphere in a second, as a share of the picture's height: 0.05 to 2.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float HeightsPerSecond
        {
            get => heightsPerSecond;
            set => heightsPerSecond = SettingRange.Checked(value, 0.05f, 2f, nameof(HeightsPerSecond));
        }

        /// <summary>How much larger keys make the sphere in a second, as a share of its radius: 0.05 to 5.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float GrowthPerSecond
        {
            get => growthPerSecond;
            set => growthPerSecond = SettingRange.Checked(value, 0.05f, 5f, nameof(GrowthPerSecond));
        }

        /// <summary>Other controls than the package's; taken when the component is enabled. Null = the package's.</summary>
        public InputActionAsset Controls
        {
            get => controls;
            set => controls = value;
        }

        /// <summary>Says when mouse and keys belong to something else; null = never.</summary>
        public InputGate Gate
        {
            get => gate;
            set => gate = value;
        }

        /// <summary>Whether the sphere follows the mouse at the moment.</summary>
        public bool IsDragging => drag.IsDragging;

        /// <summary>One frame of the given length; called from LateUpdate.</summary>
        internal void Tick(float seconds)
        {
            bool keys = !InputGate.AreKeysBlocked(gate);
            if (View == null || !WorldSphere.TryGet(Stack, out WorldSphere sphere))
            {
                LetGo();
                return;
            }
            if (keys)
                input.Edit(Stack);
            holds = Holds(keys);
            Vector3 motion = keys ? input.Motion : Vector3.zero;
            float growth = keys ? input.Growth : 0f;
            gesture.Follow(holds || motion != Vector3.zero || growth != 0f, sphere.Carving);
            if (holds)
                Hold(sphere);
            else
                drag.End();
            Move(sphere, motion, growth, Mathf.Min(seconds, PictureRay.LongestFrame));
        }

        void OnEnable()
        {
            input = new SphereControls(controls, this);
            if (!input.Enable())
                enabled = false;
        }

        void Start() => enabled = this.Has(View, nameof(View)) && this.Has(Stack, nameof(Stack));

        void OnDisable()
        {
            LetGo();
            input?.Release();
        }

        void LateUpdate() => Tick(Time.unscaledDeltaTime);

        void OnValidate()
        {
            growthPerNotch = Mathf.Clamp(growthPerNotch, 0.01f, 1f);
            heightsPerSecond = Mathf.Clamp(heightsPerSecond, 0.05f, 2f);
            growthPerSecond = Mathf.Clamp(growthPerSecond, 0.05f, 5f);
        }

        /// <summary>A hold begins where the mouse is ours, and goes on wherever it gets to.</summary>
        bool Holds(bool keys) => input.Hold.IsPressed()
            && (holds || (keys && PictureRay.Contains(View, input.Point) && !InputGate.IsPointerBlocked(gate)));

        void Hold(in WorldSphere sphere)
        {
            float notches = input.ResizeNotches;
            if (notches != 0f)
                sphere.Scale(Math.Exp(growthPerNotch * notches));
            drag.Follow(input.Point.ReadValue<Vector2>(), View, sphere, Pointer);
        }

        void Move(in WorldSphere sphere, Vector3 motion, float growth, float seconds)
        {
            if (growth != 0f)
                sphere.Scale(Math.Exp(growthPerSecond * seconds * growth));
            if (motion == Vector3.zero)
                return;
            Transform eye = View.transform;
            float depth = Mathf.Max(View.nearClipPlane, Vector3.Dot(sphere.Centre - eye.position, eye.forward));
            sphere.MoveTo(sphere.Centre + eye.rotation * motion * (heightsPerSecond * PictureRay.Height(View, depth) * seconds));
        }

        void LetGo()
        {
            holds = false;
            drag.End();
            gesture.End();
        }
    }
}
