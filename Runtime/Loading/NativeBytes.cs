using System;
using System.Buffers;
using System.Runtime.InteropServices;
using Unity.Collections;

namespace AnatomyCarve
{
    /// <summary>
    /// Lets another thread read a NativeArray's bytes without a copy. Nobody may dispose of the array, or destroy what it is a view of, before that
    /// thread is done.
    /// </summary>
    sealed class NativeBytes : MemoryManager<byte>
    {
        readonly NativeArray<byte> array;

        public NativeBytes(NativeArray<byte> array) => this.array = array;

        /// <summary>The bytes: to read only, though the type would let one write.</summary>
        public override Span<byte> GetSpan()
        {
            ReadOnlySpan<byte> bytes = array.AsReadOnlySpan();
            return MemoryMarshal.CreateSpan(ref MemoryMarshal.GetReference(bytes), bytes.Length);
        }

        /// <exception cref="NotSupportedException">Always: whoever needs a pointer takes the array's own.</exception>
        public override MemoryHandle Pin(int elementIndex = 0) => throw new NotSupportedException("A view of a NativeArray cannot be pinned.");

        /// <inheritdoc/>
        public override void Unpin()
        {
        }

        protected override void Dispose(bool disposing)
        {
        }
    }
}
