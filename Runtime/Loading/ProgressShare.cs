using System;

namespace AnatomyCarve
{
    /// <summary>The progress of a part of something, as a share of the whole, which may be null.</summary>
    sealed class ProgressShare : IProgress<float>
    {
        readonly IProgress<float> whole;
        readonly float start, length;

        public ProgressShare(IProgress<float> whole, float start, float length)
        {
            this.whole = whole;
            this.start = start;
            this.length = length;
        }

        public void Report(float value) => whole?.Report(start + length * value);
    }
}
