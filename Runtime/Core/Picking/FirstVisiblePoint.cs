namespace AnatomyCarve.Picking
{
    /// <summary>Where a ray's alpha reaches the threshold, in steps from where the ray enters the volume.</summary>
    struct FirstVisiblePoint
    {
        /// <summary>The point itself.</summary>
        public double Position;

        /// <summary>The middle of the part of a step in which it lies, where opacity was sampled.</summary>
        public double SampledAt;

        /// <summary>The edge before it, where a surface is seen; the point itself where there is none.</summary>
        public double Edge;
    }
}
