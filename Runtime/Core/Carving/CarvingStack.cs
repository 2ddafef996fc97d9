using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// The carving of one volume: fixed clip spheres in order and at most one active sphere, with undo and redo. A voxel is clipped where any
    /// sphere that contains its centre has its segment in the mask (Eq. 1 of the design), so the order never matters for the picture.
    /// Every edit that changes anything raises <see cref="Changed"/> once. Not thread safe; <see cref="State"/> can be handed to any thread.
    /// </summary>
    public sealed class CarvingStack
    {
        /// <summary>A new active sphere's share of the fixed one's radius, unless set otherwise.</summary>
        public const float DefaultActiveRadiusFactor = 0.75f;

        /// <summary>The number of steps that can be undone, unless set otherwise.</summary>
        public const int DefaultHistoryLimit = 256;

        readonly CarvingHistory history = new CarvingHistory(DefaultHistoryLimit);
        float activeRadiusFactor = DefaultActiveRadiusFactor;
        int gestureDepth;
        int gesture;

        /// <summary>Makes an empty carving: no sphere; the first active sphere will clip every segment.</summary>
        /// <param name="segmentCount">The number of segments, label 0 included: 1 to <see cref="SegmentTable.MaximumCount"/>.</param>
        /// <exception cref="ArgumentOutOfRangeException">The number lies outside its range.</exception>
        public CarvingStack(int segmentCount)
        {
            SegmentCount = segmentCount;
            State = new CarvingSnapshot(Array.Empty<ClipSphere>(), null, SegmentMask.All(segmentCount));
        }

        /// <summary>Makes a carving that begins with spheres, for instance saved ones; they cannot be undone.</summary>
        /// <param name="segmentCount">The number of segments, label 0 included: 1 to <see cref="SegmentTable.MaximumCount"/>.</param>
        /// <param name="fixedSpheres">The fixed spheres, oldest first.</param>
        /// <param name="active">The active sphere; null = none, and the next active one will clip every segment.</param>
        /// <exception cref="ArgumentOutOfRangeException">The number lies outside its range.</exception>
        /// <exception cref="ArgumentNullException">The list or one of its spheres is null.</exception>
        /// <exception cref="ArgumentException">A mask is for another number of segments.</exception>
        public CarvingStack(int segmentCount, IEnumerable<ClipSphere> fixedSpheres, ClipSphere active)
            : this(segmentCount) => State = Checked(fixedSpheres, active);

        /// <summary>Raised after every change, on the caller's thread.</summary>
        public event Action<CarvingChange> Changed;

        /// <summary>The number of segments of every mask.</summary>
        public int SegmentCount { get; }

        /// <summary>The carving as it is now, immutable.</summary>
        public CarvingSnapshot State { get; private set; }

        /// <summary>The fixed spheres, oldest first; a list that later edits do not change.</summary>
        public IReadOnlyList<ClipSphere> Fixed => State.Fixed;

        /// <summary>The active sphere; null where there is none.</summary>
        public ClipSphere Active => State.Active;

        /// <summary>The active sphere's mask, or the one that the next active sphere will have.</summary>
        public SegmentMask ActiveMask => State.ActiveMask;

        /// <summary>The fixed spheres, then the active one; a list that later edits do not change.</summary>
        public IReadOnlyList<ClipSphere> Spheres => State;

        /// <summary>Grows by one with every change, undo and redo included.</summary>
        public int Version { get; private set; }

        /// <summary>The share of its radius that the active sphere keeps when it is fixed: above 0, finite. 0.75 unless set.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The factor lies outside its range.</exception>
        public float ActiveRadiusFactor
        {
            get => activeRadiusFactor;
            set
            {
                if (!(value > 0) || float.IsInfinity(value))
                    throw new ArgumentOutOfRangeException(nameof(value), value, "The factor is above 0 and finite.");
                activeRadiusFactor = value;
            }
        }

        /// <summary>Whether there is a step to undo.</summary>
        public bool CanUndo => history.CanUndo;

        /// <summary>Whether there is a step to redo.</summary>
        public bool CanRedo => history.CanRedo;

        /// <summary>The number of steps that are kept for undo: 0 or more, 256 unless set. Lowering it forgets the oldest.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The number is negative.</exception>
        public int HistoryLimit
        {
            get => history.Limit;
            set
            {
                if (value < 0)
                    throw new ArgumentOutOfRangeException(nameof(value), value, "The number of steps is 0 or more.");
                history.Limit = value;
            }
        }

        /// <summary>Places, moves or resizes the active sphere. Its mask stays what it was; the very first one clips every segment.</summary>
        /// <param name="centreLps">Centre in LPS millimetres, each coordinate within +-<see cref="ClipSphere.LargestMm"/>.</param>
        /// <param name="radiusMm">Radius in millimetres, 0 to <see cref="ClipSphere.LargestMm"/>.</param>
        /// <exception cref="ArgumentOutOfRangeException">A number lies outside its range; the carving is unchanged.</exception>
        public void SetActive(PointMm centreLps, double radiusMm) =>
            Do(CarvingChangeKind.ActiveSet, Fixed.Count, State.WithActive(new ClipSphere(centreLps, radiusMm, ActiveMask)));

        /// <summary>Takes the active sphere away; the next one will have its mask. Without an active sphere nothing happens.</summary>
        public void RemoveActive()
        {
            if (Active is object)
                Do(CarvingChangeKind.ActiveRemoved, Fixed.Count, State.WithoutActive());
        }

        /// <summary>
        /// Fixes the active sphere: it becomes the last of the fixed ones, with its mask, and a new active sphere takes its place, with the same
        /// centre and mask and <see cref="ActiveRadiusFactor"/> of its radius.
        /// </summary>
        /// <exception cref="InvalidOperationException">There is no active sphere.</exception>
        public void FixActive()
        {
            if (Active is null)
                throw new InvalidOperationException("There is no active sphere to fix.");
            Do(CarvingChangeKind.ActiveFixed, Fixed.Count, State.WithActiveFixed(activeRadiusFactor));
        }

        /// <summary>Removes the last fixed sphere. The active sphere and its mask stay as they are.</summary>
        /// <returns>False where there is no fixed sphere.</returns>
        public bool RemoveLast()
        {
            if (Fixed.Count == 0)
                return false;
            Do(CarvingChangeKind.LastRemoved, Fixed.Count - 1, State.WithoutLastFixed());
            return true;
        }

        /// <summary>Turns one segment over in the active mask.</summary>
        /// <exception cref="ArgumentOutOfRangeException">There is no such segment.</exception>
        public void ToggleSegment(int segment) => SetActiveMask(ActiveMask.Toggled(segment));

        /// <summary>Sets one segment's bit in one sphere's mask.</summary>
        /// <param name="sphereIndex">Index in <see cref="Spheres"/>.</param>
        /// <param name="segment">Dense segment index.</param>
        /// <param name="clipped">Whether the sphere clips the segment.</param>
        /// <exception cref="ArgumentOutOfRangeException">There is no such sphere or no such segment.</exception>
        public void SetSegment(int sphereIndex, int segment, bool clipped)
        {
            SegmentMask mask = State[sphereIndex].Mask.With(segment, clipped);
            if (sphereIndex < Fixed.Count)
                Do(CarvingChangeKind.MaskChanged, sphereIndex, State.WithFixed(sphereIndex, Fixed[sphereIndex].WithMask(mask)));
            else
                SetActiveMask(mask);
        }

        /// <summary>Resets the active mask: if every bit is on, all off; otherwise all on.</summary>
        public void ResetMask() => SetActiveMask(ActiveMask.Reset());

        /// <summary>Gives the active sphere another mask; without one, the next active sphere will have it.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="mask"/> is null.</exception>
        /// <exception cref="ArgumentException">The mask is for another number of segments.</exception>
        public void SetActiveMask(SegmentMask mask)
        {
            CheckMask(mask ?? throw new ArgumentNullException(nameof(mask)), nameof(mask));
            Do(CarvingChangeKind.MaskChanged, Active is null ? -1 : Fixed.Count, State.WithActiveMask(mask));
        }

        /// <summary>Goes back to the beginning: no sphere, and the next active one clips every segment. Can be undone.</summary>
        public void Clear() =>
            Do(CarvingChangeKind.Cleared, -1, new CarvingSnapshot(Array.Empty<ClipSphere>(), null, SegmentMask.All(SegmentCount)));

        /// <summary>Puts another carving in place of this one, for instance a saved one. Can be undone.</summary>
        /// <param name="fixedSpheres">The fixed spheres, oldest first.</param>
        /// <param name="active">The active sphere; null = none, and the next active one will clip every segment.</param>
        /// <exception cref="ArgumentNullException">The list or one of its spheres is null.</exception>
        /// <exception cref="ArgumentException">A mask is for another number of segments; the carving is unchanged.</exception>
        public void Replace(IEnumerable<ClipSphere> fixedSpheres, ClipSphere active = null) =>
            Do(CarvingChangeKind.Replaced, -1, Checked(fixedSpheres, active));

        /// <summary>Takes the last step back.</summary>
        /// <returns>False where there is none.</returns>
        public bool Undo()
        {
            if (!CanUndo)
                return false;
            CarvingHistory.Step step = history.TakeUndo();
            Publish(step.Kind, CarvingCause.Undone, step.SphereIndex, step.Before);
            return true;
        }

        /// <summary>Makes the last undone step again.</summary>
        /// <returns>False where nothing was undone since the last edit.</returns>
        public bool Redo()
        {
            if (!CanRedo)
                return false;
            CarvingHistory.Step step = history.TakeRedo();
            Publish(step.Kind, CarvingCause.Redone, step.SphereIndex, step.After);
            return true;
        }

        /// <summary>
        /// Begins a gesture, for instance when a hand takes the sphere: until <see cref="EndGesture"/>, moves and resizings of the active sphere that
        /// follow each other are one step to undo. Other edits stay steps of their own. Gestures may be nested; the outermost counts.
        /// </summary>
        public void BeginGesture()
        {
            if (gestureDepth++ == 0)
                gesture++;
        }

        /// <summary>Ends the gesture that was begun last.</summary>
        /// <exception cref="InvalidOperationException">No gesture was begun.</exception>
        public void EndGesture()
        {
            if (gestureDepth == 0)
                throw new InvalidOperationException("No gesture was begun.");
            gestureDepth--;
        }

        void Do(CarvingChangeKind kind, int sphereIndex, CarvingSnapshot after)
        {
            CarvingSnapshot before = State;
            if (before.SameAs(after))
                return;
            bool joinsGesture = gestureDepth > 0 && kind == CarvingChangeKind.ActiveSet;
            history.Push(kind, sphereIndex, before, after, joinsGesture ? gesture : 0);
            Publish(kind, CarvingCause.Done, sphereIndex, after);
        }

        void Publish(CarvingChangeKind kind, CarvingCause cause, int sphereIndex, CarvingSnapshot after)
        {
            CarvingSnapshot before = State;
            State = after;
            Version++;
            Changed?.Invoke(new CarvingChange(kind, cause, sphereIndex, before, after, Version));
        }

        CarvingSnapshot Checked(IEnumerable<ClipSphere> fixedSpheres, ClipSphere active)
        {
            ClipSphere[] spheres = new List<ClipSphere>(fixedSpheres ?? throw new ArgumentNullException(nameof(fixedSpheres))).ToArray();
            foreach (ClipSphere sphere in spheres)
                CheckMask((sphere ?? throw new ArgumentNullException(nameof(fixedSpheres))).Mask, nameof(fixedSpheres));
            if (active is object)
                CheckMask(active.Mask, nameof(active));
            return new CarvingSnapshot(spheres, active, active?.Mask ?? SegmentMask.All(SegmentCount));
        }

        void CheckMask(SegmentMask mask, string argument)
        {
            if (mask.SegmentCount != SegmentCount)
                throw new ArgumentException(FormattableString.Invariant(
                    $"The mask is for {mask.SegmentCount} segments, the carving for {SegmentCount}."), argument);
        }
    }
}
