using System;
using System.Runtime.InteropServices;

namespace UnityEngine.InputSystem
{
    /// <summary>A device's state in memory: now, at the end of the frame before, and at rest.</summary>
    sealed unsafe class DeviceState
    {
        readonly byte* m_Memory;

        internal DeviceState(uint sizeInBytes)
        {
            Size = (int)sizeInBytes;
            m_Memory = (byte*)Marshal.AllocHGlobal(Math.Max(Size, 1) * 4);
            new Span<byte>(m_Memory, Size * 4).Clear();
        }

        ~DeviceState() => Marshal.FreeHGlobal((IntPtr)m_Memory);

        internal int Size { get; }

        internal byte* Current => m_Memory;

        internal byte* Previous => m_Memory + Size;

        internal byte* Default => m_Memory + Size * 2;

        /// <summary>The state before the change that is being made.</summary>
        internal byte* Before => m_Memory + Size * 3;

        internal void KeepAsPrevious() => Copy(Current, Previous);

        internal void KeepAsBefore() => Copy(Current, Before);

        internal void Reset() => Copy(Default, Current);

        void Copy(byte* from, byte* to) => Buffer.MemoryCopy(from, to, Size, Size);
    }
}
