using System;

namespace AnatomyCarve.Carving
{
    /// <summary>Places along k, from a first to a last.</summary>
    readonly struct KRange
    {
        /// <summary>Last below first = none.</summary>
        public KRange(int first, int last)
        {
            First = first;
            Last = last;
        }

        public static KRange Nowhere => new KRange(0, -1);

        public static KRange Everywhere => new KRange(int.MinValue, int.MaxValue);

        public int First { get; }

        public int Last { get; }

        public bool IsEmpty => Last < First;

        public bool Holds(KRange other) => First <= other.First && Last >= other.Last;

        /// <summary>So many places more at both ends; nothing if it is empty.</summary>
        public KRange Widened(int places) => IsEmpty ? this : new KRange(First - places, Last + places);

        /// <summary>What both have.</summary>
        public KRange And(KRange other) => new KRange(Math.Max(First, other.First), Math.Min(Last, other.Last));

        /// <summary>The smallest range that holds both.</summary>
        public KRange Or(KRange other) => IsEmpty ? other : other.IsEmpty ? this : new KRange(Math.Min(First, other.First), Math.Max(Last, other.Last));
    }
}
