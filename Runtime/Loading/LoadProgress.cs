using System;

namespace AnatomyCarve
{
    /// <summary>
    /// One load's progress, 0 to 1. The thread that reads reports it, any thread may ask. Each load has its own: one that was cancelled disturbs no other.
    /// </summary>
    sealed class LoadProgress : IProgress<float>
    {
        readonly IProgress<float> next;
        volatile float value;

        public LoadProgress(IProgress<float> next) => this.next = next;

        public float Value => value;

        public void Report(float value)
        {
            this.value = value;
            next?.Report(value);
        }
    }
}
