using System;
using NUnit.Framework;

namespace AnatomyCarve.Tests
{
    /// <summary>What a thread leaves to the garbage collector.</summary>
    static class AllocatedBytes
    {
        const int Known = 1000;

        /// <summary>
        /// Bytes that this thread has allocated so far. Where the runtime does not count them, the test ends as inconclusive instead of passing for nothing:
        /// Unity's Mono answers 0; look at <c>GC Alloc</c> in the Profiler there.
        /// </summary>
        public static long OfThisThread()
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            GC.KeepAlive(new byte[Known]);
            Assume.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.GreaterThanOrEqualTo(Known), "this runtime does not count what threads allocate");
            return GC.GetAllocatedBytesForCurrentThread();
        }
    }
}
