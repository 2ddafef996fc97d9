using System;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.InputSystem;

namespace AnatomyCarve.Desktop
{
    /// <summary>
    /// Points a <see cref="SegmentPointer"/> through the mouse, which no longer points by itself then. A click turns the pointed segment over in the active
    /// sphere's mask: whether the sphere clips it.
    /// </summary>
    [AddComponentMenu("AnatomyCarve/Mouse Pointer")]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(-10)] // after the view and the sphere, before what renders
    [ManualPage("components")]
    public sealed class MousePointer : MonoBehaviour
    {
        /// <summary>Before the name of a segment that stays, shown in green: <c>+</c>.</summary>
        public const string StaysSign = "+";

        /// <summary>Before the name of a segment that the sphere clips, shown in red: <c>×</c>.</summary>
        public const string ClippedSign = "\u00D7";

        [SerializeField, Tooltip("The camera whose picture the mouse is in; empty = the one on this GameObject")]
        Camera view;

        [SerializeField, Tooltip("What is pointed; empty = the one on this GameObject")]
        SegmentPointer pointer;

        [SerializeField, Tooltip("Other controls: a map 'Desktop' with the actions of the package's own; empty = those")]
        InputActionAsset controls;

        [SerializeField, Tooltip("Says when mouse and keys belong to something else; empty = never")]
        InputGate gate;

        ControlSet input;
        InputAction point, toggle;
        string label = "";
        SegmentPointer taken;
        bool pointedByItself;

        /// <summary>Raised when <see cref="Segment"/> or <see cref="WillBeClipped"/> changed.</summary>
        public event Action Changed;

        /// <summary>The camera whose picture the mouse is in: the one that was set, or else the one on this GameObject.</summary>
        public Camera View
        {
            get => this.WiredOrSibling(view);
            set => view = value;
        }

        /// <summary>What is pointed: the one that was set, or else the one on this GameObject.</summary>
        public SegmentPointer Pointer
        {
            get => this.WiredOrSibling(pointer);
            set => pointer = value;
        }

        /// <summary>Other controls than the package's; taken when the component is enabled. Null = the package's.</summary>
        public InputActionAsset Controls
        {
            get => controls;
            set => controls = value;
        }

        /// <summary>Says when the mouse belongs to something else; null = never.</summary>
        public InputGate Gate
        {
            get => gate;
            set => gate = value;
        }

        /// <summary>The segment under the mouse; null = none.</summary>
        public Segment Segment { get; private set; }

        /// <summary>Whether the active sphere clips the segment under the mouse (red); false = it stays (green), or there is none.</summary>
        public bool WillBeClipped { get; private set; }

        /// <summary>A sign and the name of the segment under the mouse, which say the same without colour; empty = none.</summary>
        public string Label => label;

        /// <summary>One frame; called from LateUpdate.</summary>
        internal void Tick()
        {
            if (View == null || Pointer == null)
                return;
            if (PictureRay.Contains(View, point) && !InputGate.IsPointerBlocked(gate))
            {
                Pointer.Point(PictureRay.Of(View, point));
                if (toggle.WasPerformedThisFrame())
                    Pointer.ToggleSegment();
            }
            else if (Pointer.Current.Hit)
            {
                Pointer.Point(Nowhere());
            }
            Tell(Pointer.CurrentSegment, Pointer.WillBeClipped);
        }

        void OnEnable()
        {
            input = new ControlSet(controls, this);
            point = input.Vector2("Point");
            toggle = input.Button("Toggle Segment");
            if (!input.Enable())
                enabled = false;
            else if (didStart)
                Take();
        }

        void Start()
        {
            enabled = this.Has(View, nameof(View)) && this.Has(Pointer, nameof(Pointer));
            if (enabled)
                Take();
        }

        void OnDisable()
        {
            input?.Release();
            if (taken != null)
                taken.AutoPoint = pointedByItself;
            taken = null;
            Tell(null, false);
        }

        void LateUpdate() => Tick();

        void Take()
        {
            taken = Pointer;
            pointedByItself = taken.AutoPoint;
            taken.AutoPoint = false;
        }

        void Tell(Segment segment, bool clipped)
        {
            if (ReferenceEquals(segment, Segment) && clipped == WillBeClipped)
                return;
            Segment = segment;
            WillBeClipped = clipped;
            label = segment == null ? "" : $"{(clipped ? ClippedSign : StaysSign)} {segment.Name}";
            Changed?.Invoke();
        }

        /// <summary>A ray that leaves the volume behind: what a pointer without a mouse points along.</summary>
        Ray Nowhere()
        {
            Transform eye = View.transform;
            Vector3 centre = Pointer.Target != null ? Pointer.Target.transform.position : eye.position;
            return new Ray(centre + Vector3.up * Far(eye.position - centre), Vector3.up);
        }

        float Far(Vector3 offset) => 1e3f * (1f + offset.magnitude + View.farClipPlane);
    }
}
