using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// Points along its forward axis at a carved volume and says which segment the picture shows there. It asks the CPU's carved field, so no
    /// frame waits for the GPU. A pointed segment is green while the active sphere leaves it and red when the sphere will clip it.
    /// </summary>
    [AddComponentMenu("AnatomyCarve/Segment Pointer")]
    [DisallowMultipleComponent]
    [ManualPage("components")]
    public sealed class SegmentPointer : MonoBehaviour
    {
        [SerializeField, Tooltip("The volume to point at; empty = the one on this GameObject or its parents")]
        CarvedVolumeRenderer target;

        [SerializeField, Tooltip("Point along the forward axis in each LateUpdate")]
        bool autoPoint = true;

        [SerializeField, Min(0f), Tooltip("How far it points, in world units")]
        float maxDistance = 10f;

        CarvedVolumeRenderer found;

        /// <summary>Raised when another segment is pointed at, or none any more.</summary>
        public event Action<SegmentHit> Changed;

        /// <summary>The volume that is pointed at: the one that was set, or else the one on this GameObject or its parents. Null if there is none.</summary>
        public CarvedVolumeRenderer Target
        {
            get
            {
                if (target != null)
                    return target; // what is found is not written into the field, which would be saved with the scene
                if (found == null)
                    found = GetComponentInParent<CarvedVolumeRenderer>();
                return found;
            }
            set => target = value;
        }

        /// <summary>Whether it points along its forward axis in each LateUpdate.</summary>
        public bool AutoPoint
        {
            get => autoPoint;
            set => autoPoint = value;
        }

        /// <summary>How far it points, in world units, 0 or more.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value is negative or NaN.</exception>
        public float MaxDistance
        {
            get => maxDistance;
            set => maxDistance = value >= 0f ? value : throw new ArgumentOutOfRangeException(nameof(MaxDistance), value, "A distance is 0 or more.");
        }

        /// <summary>What it pointed at last.</summary>
        public SegmentHit Current { get; private set; } = SegmentHit.None;

        /// <summary>The segment that it pointed at last; null = none.</summary>
        public Segment CurrentSegment
        {
            get
            {
                SegmentTable segments = Target != null ? Target.Segments : null;
                return Current.Hit && segments != null && Current.Segment < segments.Count ? segments[Current.Segment] : null;
            }
        }

        /// <summary>Whether the active sphere's mask clips the pointed segment (shown red); false = it stays (green), or nothing is pointed at.</summary>
        public bool WillBeClipped => Current.Hit && CurrentMask is SegmentMask mask && Current.Segment < mask.SegmentCount && mask[Current.Segment];

        /// <summary>The point that it pointed at last, in world space; meaningless without a hit.</summary>
        public Vector3 CurrentPosition => Current.Hit && Target != null && Target.Volume != null
            ? Target.transform.TransformPoint(VolumeSpace.LpsToLocal(Target.Volume.Geometry, Current.PositionLps))
            : Vector3.zero;

        SegmentMask CurrentMask => Carving?.ActiveMask;

        CarvingStack Carving => Target != null && Target.Stack != null ? Target.Stack.Carving : null;

        /// <summary>Points along a ray and remembers what is there.</summary>
        /// <param name="worldRay">The ray in world space.</param>
        /// <returns>The first visible segment; <see cref="SegmentHit.None"/> where there is none within <see cref="MaxDistance"/>, and while the target is
        /// disabled.</returns>
        /// <exception cref="ArgumentException">The ray has no direction.</exception>
        public SegmentHit Point(Ray worldRay)
        {
            SegmentHit before = Current;
            Current = Find(worldRay);
            if (Current.Hit != before.Hit || Current.Segment != before.Segment)
                Changed?.Invoke(Current);
            return Current;
        }

        /// <summary>Turns the pointed segment over in the active sphere's mask.</summary>
        /// <returns>Whether a segment was pointed at.</returns>
        public bool ToggleSegment()
        {
            CarvingStack carving = Carving;
            if (!Current.Hit || carving == null || Current.Segment >= carving.SegmentCount)
                return false;
            carving.ToggleSegment(Current.Segment);
            return true;
        }

        /// <summary>Turns the active sphere's whole mask on; off if it is all on. Without a carving nothing happens.</summary>
        public void ResetMask() => Carving?.ResetMask();

        void LateUpdate()
        {
            if (autoPoint)
                Point(new Ray(transform.position, transform.forward));
        }

        void OnDisable()
        {
            if (!Current.Hit)
                return;
            Current = SegmentHit.None;
            Changed?.Invoke(Current);
        }

        void OnTransformParentChanged() => found = null;

        void OnValidate() => maxDistance = Mathf.Max(0f, maxDistance);

        SegmentHit Find(Ray worldRay)
        {
            CarvedField field = Target != null && Target.isActiveAndEnabled ? Target.Field : null;
            if (field == null)
                return SegmentHit.None;
            Matrix4x4 volumeToWorld = Target.transform.localToWorldMatrix;
            if (VolumeSpace.WorldScale(volumeToWorld) == 0)
                return SegmentHit.None;
            RayMm ray = VolumeSpace.RayToLps(field.Volume.Geometry, volumeToWorld, worldRay, out double mmPerWorldUnit);
            return SegmentPicker.Pick(field, ray, Target.RaySettings, maxDistance * mmPerWorldUnit);
        }
    }
}
