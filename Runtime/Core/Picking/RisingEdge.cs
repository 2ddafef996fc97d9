using System;

namespace AnatomyCarve.Picking
{
    /// <summary>Where opacity, sampled from place to place along a ray, last rose through a level.</summary>
    struct RisingEdge
    {
        const double LeastRise = 1e-6;

        readonly double level;
        double lastOpacity, lastPlace;

        /// <param name="level">an opacity</param>
        /// <param name="begin">where the first places lie; the edge if opacity is at the level there</param>
        public RisingEdge(double level, double begin)
        {
            this.level = level;
            Position = begin;
            lastOpacity = lastPlace = 0;
        }

        /// <summary>-1 where opacity is below the level.</summary>
        public double Position { get; private set; }

        public void Add(double place, double opacity)
        {
            if (opacity < level)
                Position = -1;
            else if (Position < 0)
                Position = place - (opacity - level) / Math.Max(opacity - lastOpacity, LeastRise) * (place - lastPlace);
            (lastOpacity, lastPlace) = (opacity, place);
        }
    }
}
