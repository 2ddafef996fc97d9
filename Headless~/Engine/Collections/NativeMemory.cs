using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Unity.Collections
{
    /// <summary>A block of native memory and whether it may still be used; shared by all copies of a NativeArray over it.</summary>
    sealed unsafe class NativeMemory
    {
        static readonly HashSet<NativeMemory> s_Alive = new();

        readonly bool m_Owned;
        volatile bool m_Valid = true;

        NativeMemory(void* pointer, Allocator allocator, bool owned)
        {
            Pointer = pointer;
            Allocator = allocator;
            m_Owned = owned;
        }

        ~NativeMemory()
        {
            if (m_Owned && (m_Valid || Allocator == Allocator.None))
                Marshal.FreeHGlobal((IntPtr)Pointer);
        }

        internal void* Pointer { get; }

        internal Allocator Allocator { get; }

        internal bool IsValid => m_Valid;

        /// <summary>Blocks that were allocated with Persistent or TempJob and not disposed of.</summary>
        internal static int LeakCount
        {
            get { lock (s_Alive) return s_Alive.Count; }
        }

        internal static NativeMemory Allocate(long bytes, Allocator allocator, NativeArrayOptions options)
        {
            if (allocator is not (Allocator.Temp or Allocator.TempJob or Allocator.Persistent or Allocator.Domain))
                throw new ArgumentException("Allocator must be Temp, TempJob or Persistent", nameof(allocator));
            var pointer = (void*)Marshal.AllocHGlobal((IntPtr)Math.Max(bytes, 1));
            // What Unity leaves uninitialised gets a pattern that shows.
            Fill(pointer, bytes, options == NativeArrayOptions.ClearMemory ? (byte)0 : (byte)0xCD);
            var memory = new NativeMemory(pointer, allocator, true);
            if (allocator is Allocator.TempJob or Allocator.Persistent)
                lock (s_Alive)
                    s_Alive.Add(memory);
            return memory;
        }

        /// <summary>
        /// A copy of bytes, which its owner ends with <see cref="Invalidate"/>; arrays over it cannot be disposed of. The memory goes when nobody refers to
        /// it any more, so that a thread that still reads when the owner ends gets an exception, not rubbish.
        /// </summary>
        internal static NativeMemory Own(ReadOnlySpan<byte> bytes)
        {
            var pointer = (void*)Marshal.AllocHGlobal((IntPtr)Math.Max(bytes.Length, 1));
            bytes.CopyTo(new Span<byte>(pointer, bytes.Length));
            return new NativeMemory(pointer, Allocator.None, true);
        }

        /// <summary>Wraps memory that belongs to something else, which calls <see cref="Invalidate"/> when it ends.</summary>
        internal static NativeMemory Borrow(void* pointer) => new(pointer, Allocator.None, false);

        /// <summary>Ends the use of the block; owned memory is freed.</summary>
        internal void Invalidate()
        {
            if (!m_Valid)
                return;
            m_Valid = false;
            lock (s_Alive)
                s_Alive.Remove(this);
            if (m_Owned && Allocator == Allocator.None)
                return;
            if (m_Owned)
                Marshal.FreeHGlobal((IntPtr)Pointer);
            GC.SuppressFinalize(this);
        }

        internal static void ForgetLeaks()
        {
            lock (s_Alive)
                s_Alive.Clear();
        }

        static void Fill(void* pointer, long bytes, byte value)
        {
            for (var p = (byte*)pointer; bytes > 0;)
            {
                var part = (int)Math.Min(bytes, 1 << 30);
                new Span<byte>(p, part).Fill(value);
                p += part;
                bytes -= part;
            }
        }
    }
}
