using System;
using System.Collections;
using System.Collections.Generic;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// A carving at one moment: the fixed spheres in order, then the active sphere where there is one. Immutable, so that it can be kept,
    /// compared and read on any thread. Snapshots in which only the active sphere differs share the fixed ones.
    /// </summary>
    public sealed class CarvingSnapshot : IReadOnlyList<ClipSphere>
    {
        readonly ClipSphere[] fixedSpheres;

        internal CarvingSnapshot(ClipSphere[] fixedSpheres, ClipSphere active, SegmentMask activeMask)
        {
            this.fixedSpheres = fixedSpheres;
            Fixed = Array.AsReadOnly(fixedSpheres);
            Active = active;
            ActiveMask = activeMask;
        }

        CarvingSnapshot(CarvingSnapshot sharesFixed, ClipSphere active, SegmentMask activeMask)
        {
            fixedSpheres = sharesFixed.fixedSpheres;
            Fixed = sharesFixed.Fixed;
            Active = active;
            ActiveMask = activeMask;
        }

        /// <summary>The fixed spheres, oldest first.</summary>
        public IReadOnlyList<ClipSphere> Fixed { get; }

        /// <summary>The sphere in the hand; null where there is none.</summary>
        public ClipSphere Active { get; }

        /// <summary>The active sphere's mask; where there is no active sphere, the mask that the next one will have.</summary>
        public SegmentMask ActiveMask { get; }

        /// <summary>The number of spheres, the active one included.</summary>
        public int Count => fixedSpheres.Length + (Active is null ? 0 : 1);

        /// <summary>The fixed spheres by index, then the active one.</summary>
        /// <exception cref="ArgumentOutOfRangeException">There is no such sphere.</exception>
        public ClipSphere this[int index]
        {
            get
            {
                if (index < 0 || index >= Count)
                    throw new ArgumentOutOfRangeException(nameof(index), index,
                        FormattableString.Invariant($"The carving has {Count} spheres."));
                return index < fixedSpheres.Length ? fixedSpheres[index] : Active;
            }
        }

        /// <inheritdoc/>
        public IEnumerator<ClipSphere> GetEnumerator()
        {
            foreach (ClipSphere sphere in fixedSpheres)
                yield return sphere;
            if (Active is object)
                yield return Active;
        }

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

        /// <summary>Whether both hold the very same fixed spheres (the same objects, by a shared list), so that at most the active ones differ.</summary>
        internal bool SharesFixedWith(CarvingSnapshot other) => ReferenceEquals(fixedSpheres, other.fixedSpheres);

        internal bool SameAs(CarvingSnapshot other)
        {
            if (ReferenceEquals(this, other))
                return true;
            if (!Equals(Active, other.Active) || !ActiveMask.Equals(other.ActiveMask))
                return false;
            return SharesFixedWith(other) || fixedSpheres.AsSpan().SequenceEqual(other.fixedSpheres);
        }

        internal CarvingSnapshot WithActive(ClipSphere active) => new CarvingSnapshot(this, active, active.Mask);

        internal CarvingSnapshot WithoutActive() => new CarvingSnapshot(this, null, ActiveMask);

        internal CarvingSnapshot WithActiveMask(SegmentMask mask) => new CarvingSnapshot(this, Active?.WithMask(mask), mask);

        internal CarvingSnapshot WithFixed(int index, ClipSphere sphere)
        {
            ClipSphere[] changed = (ClipSphere[])fixedSpheres.Clone();
            changed[index] = sphere;
            return new CarvingSnapshot(changed, Active, ActiveMask);
        }

        internal CarvingSnapshot WithActiveFixed(double radiusFactor)
        {
            var longer = new ClipSphere[fixedSpheres.Length + 1];
            fixedSpheres.CopyTo(longer, 0);
            longer[fixedSpheres.Length] = Active;
            return new CarvingSnapshot(longer, Active.WithRadius(Math.Min(Active.RadiusMm * radiusFactor, ClipSphere.LargestMm)), ActiveMask);
        }

        internal CarvingSnapshot WithoutLastFixed() =>
            new CarvingSnapshot(fixedSpheres.AsSpan(0, fixedSpheres.Length - 1).ToArray(), Active, ActiveMask);
    }
}
