using System;

namespace AnatomyCarve.Formats
{
    /// <summary>The progress of a part of something, as a share of the whole, which may be null.</summary>
    public sealed class ProgressShare : IProgress<float>
    {
        readonly IProgress<float> whole;
        readonly float start, length;

        /// <param name="whole">Told the whole's progress; may be null.</param>
        /// <param name="start">Where the part begins, 0 to 1.</param>
        /// <param name="length">What share of the whole it is, 0 to 1.</param>
        public ProgressShare(IProgress<float> whole, float start, float length)
        {
            this.whole = whole;
            this.start = start;
            this.length = length;
        }

        /// <summary>Tells the part's progress, 0 to 1.</summary>
        public void Report(float value) => whole?.Report(start + length * value);
    }
}
