namespace AnatomyCarve.Metrics
{
    /// <summary>The difference of two depth pictures.</summary>
    public readonly struct DepthDifference
    {
        internal DepthDifference(double rmseMm, int both, int onlyOne)
        {
            RmseMm = rmseMm;
            Both = both;
            OnlyOne = onlyOne;
        }

        /// <summary>
        /// Root mean square difference in millimetres over the pixels where both have a depth. Where there is no such pixel: 0 if neither picture has
        /// any depth, otherwise NaN.
        /// </summary>
        public double RmseMm { get; }

        /// <summary>The number of pixels where both have a depth.</summary>
        public int Both { get; }

        /// <summary>The number of pixels where only one has a depth.</summary>
        public int OnlyOne { get; }
    }
}
