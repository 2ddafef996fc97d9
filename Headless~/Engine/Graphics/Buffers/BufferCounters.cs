using System;

namespace UnityEngine
{
    /// <summary>The hidden counters of append, consume and counter buffers.</summary>
    static class BufferCounters
    {
        internal static void Set(GpuBuffer buffer, uint value)
        {
            if (buffer.Counter == null)
                throw new InvalidOperationException("Only buffers of the targets Append and Counter have a counter.");
            buffer.SetCounter(value);
        }

        internal static void Copy(GpuBuffer source, GpuBuffer target, int offset)
        {
            if (source is not { IsAlive: true })
                throw new ArgumentNullException(nameof(source));
            if (target is not { IsAlive: true })
                throw new ArgumentNullException(nameof(target));
            if (source.Counter == null)
                throw new InvalidOperationException("Only buffers of the targets Append and Counter have a counter.");
            if (offset < 0 || offset % 4 != 0 || offset + 4 > target.Size)
                throw new ArgumentOutOfRangeException(nameof(offset), offset, "The offset is a multiple of 4 inside the target.");
            target.CopyFrom(source.Counter, 0, (ulong)offset, 4);
        }
    }
}
