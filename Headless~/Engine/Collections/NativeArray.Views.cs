using System.Collections;
using System.Collections.Generic;

#pragma warning disable CS8500 // sizeof(T): see NativeArray.cs

namespace Unity.Collections
{
    public unsafe partial struct NativeArray<T>
    {
        /// <summary>Walks an array.</summary>
        public struct Enumerator : IEnumerator<T>
        {
            NativeArray<T> m_Array;
            int m_Index;

            public Enumerator(ref NativeArray<T> array)
            {
                m_Array = array;
                m_Index = -1;
            }

            public T Current => m_Array[m_Index];

            object IEnumerator.Current => Current;

            public bool MoveNext() => ++m_Index < m_Array.Length;

            public void Reset() => m_Index = -1;

            public void Dispose()
            {
            }
        }

        /// <summary>A view that does not write.</summary>
        public struct ReadOnly : IEnumerable<T>
        {
            NativeArray<T> m_Array;

            internal ReadOnly(NativeArray<T> array) => m_Array = array;

            public int Length => m_Array.Length;

            public bool IsCreated => m_Array.IsCreated;

            public T this[int index] => m_Array[index];

            internal void* Buffer => m_Array.Buffer;

            public ref readonly T UnsafeElementAt(int index) => ref m_Array.AsReadOnlySpan()[index];

            public System.ReadOnlySpan<T> AsReadOnlySpan() => m_Array.AsReadOnlySpan();

            public void CopyTo(T[] array) => Copy(m_Array, array);

            public void CopyTo(NativeArray<T> array) => Copy(m_Array, array);

            public T[] ToArray() => m_Array.ToArray();

            public NativeArray<U>.ReadOnly Reinterpret<U>() where U : struct => m_Array.Reinterpret<U>().AsReadOnly();

            public Enumerator GetEnumerator() => new(in this);

            IEnumerator<T> IEnumerable<T>.GetEnumerator() => GetEnumerator();

            IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

            public static implicit operator System.ReadOnlySpan<T>(in ReadOnly source) => source.AsReadOnlySpan();

            /// <summary>Walks a view.</summary>
            public struct Enumerator : IEnumerator<T>
            {
                ReadOnly m_Array;
                int m_Index;

                public Enumerator(in ReadOnly array)
                {
                    m_Array = array;
                    m_Index = -1;
                }

                public T Current => m_Array[m_Index];

                object IEnumerator.Current => Current;

                public bool MoveNext() => ++m_Index < m_Array.Length;

                public void Reset() => m_Index = -1;

                public void Dispose()
                {
                }
            }
        }
    }
}
