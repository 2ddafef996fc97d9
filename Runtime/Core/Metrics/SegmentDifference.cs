namespace AnatomyCarve.Metrics
{
    /// <summary>The difference of two pictures of first visible segments.</summary>
    public readonly struct SegmentDifference
    {
        internal SegmentDifference(int considered, int differing)
        {
            Considered = considered;
            Differing = differing;
        }

        /// <summary>The number of pixels where at least one picture has a segment.</summary>
        public int Considered { get; }

        /// <summary>The number of those in which the two differ.</summary>
        public int Differing { get; }

        /// <summary>The share of pixels that differ, 0 to 1; 0 where neither picture has a segment.</summary>
        public double Mae => Considered > 0 ? (double)Differing / Considered : 0;
    }
}
