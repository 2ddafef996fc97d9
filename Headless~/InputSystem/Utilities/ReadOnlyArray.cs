using System;
using System.Collections;
using System.Collections.Generic;

namespace UnityEngine.InputSystem.Utilities
{
    /// <summary>Part of an array that one may read. It follows the array, and enumerating it leaves no garbage.</summary>
    public struct ReadOnlyArray<TValue> : IReadOnlyList<TValue>
    {
        internal readonly TValue[] m_Array;
        readonly int m_Start;

        public ReadOnlyArray(TValue[] array) : this(array, 0, array?.Length ?? 0)
        {
        }

        public ReadOnlyArray(TValue[] array, int index, int length)
        {
            m_Array = array;
            m_Start = index;
            Count = length;
        }

        public int Count { get; }

        public TValue this[int index]
        {
            get
            {
                if (index < 0 || index >= Count)
                    throw new ArgumentOutOfRangeException(nameof(index));
                return m_Array[m_Start + index];
            }
        }

        public static implicit operator ReadOnlyArray<TValue>(TValue[] array) => new(array);

        public TValue[] ToArray()
        {
            var copy = new TValue[Count];
            if (Count > 0)
                Array.Copy(m_Array, m_Start, copy, 0, Count);
            return copy;
        }

        /// <summary>-1 where there is none.</summary>
        public int IndexOf(Predicate<TValue> predicate)
        {
            if (predicate == null)
                throw new ArgumentNullException(nameof(predicate));
            for (var i = 0; i < Count; i++)
                if (predicate(m_Array[m_Start + i]))
                    return i;
            return -1;
        }

        public Enumerator GetEnumerator() => new(m_Array, m_Start, Count);

        IEnumerator<TValue> IEnumerable<TValue>.GetEnumerator() => GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

        public struct Enumerator : IEnumerator<TValue>
        {
            readonly TValue[] m_Array;
            readonly int m_First;
            readonly int m_End;
            int m_Index;

            internal Enumerator(TValue[] array, int index, int length)
            {
                m_Array = array;
                m_First = index - 1;
                m_End = index + length;
                m_Index = m_First;
            }

            public TValue Current => m_Array[m_Index];

            object IEnumerator.Current => Current;

            public void Dispose()
            {
            }

            public bool MoveNext() => m_Index < m_End && ++m_Index < m_End;

            public void Reset() => m_Index = m_First;
        }
    }
}
