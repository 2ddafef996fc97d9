using System;
using System.Collections.Generic;

namespace UnityEngine.InputSystem
{
    /// <summary>States and parts of states that wait for the next update. Their memory is used again.</summary>
    sealed class EventQueue
    {
        readonly List<Event> m_Queued = new();
        readonly Stack<Event> m_Free = new();
        int m_LastId;

        internal int Count => m_Queued.Count;

        /// <summary>Bytes that go to an offset in a device's state.</summary>
        internal void Add(InputDevice device, uint byteOffset, ReadOnlySpan<byte> bytes, double time)
        {
            var item = m_Free.Count > 0 ? m_Free.Pop() : new Event();
            item.Device = device;
            item.ByteOffset = byteOffset;
            item.Size = bytes.Length;
            item.Time = time;
            item.Id = ++m_LastId;
            if (item.Bytes.Length < bytes.Length)
                item.Bytes = new byte[bytes.Length];
            bytes.CopyTo(item.Bytes);
            m_Queued.Add(item);
        }

        /// <summary>Hands out what is queued, in order, also what is queued meanwhile.</summary>
        internal void Drain(Action<Event> take)
        {
            try
            {
                for (var i = 0; i < m_Queued.Count; i++)
                    take(m_Queued[i]);
            }
            finally
            {
                foreach (var item in m_Queued)
                {
                    item.Device = null;
                    m_Free.Push(item);
                }

                m_Queued.Clear();
            }
        }

        internal sealed class Event
        {
            internal InputDevice Device;
            internal uint ByteOffset;
            internal byte[] Bytes = Array.Empty<byte>();
            internal int Size;
            internal double Time;
            internal int Id;
        }
    }
}
