using System;
using System.Collections;
using System.Collections.Generic;

#pragma warning disable CS8500 // sizeof(T): T is a struct without references, which the constructor checks

namespace Unity.Collections
{
    /// <summary>An array in native memory. Indices and life time are checked always, as in the Editor.</summary>
    public unsafe partial struct NativeArray<T> : IDisposable, IEnumerable<T>, IEquatable<NativeArray<T>>
        where T : struct
    {
        readonly NativeMemory m_Memory;
        readonly void* m_Buffer;
        readonly int m_Length;

        /// <exception cref="ArgumentOutOfRangeException">The length is negative.</exception>
        public NativeArray(int length, Allocator allocator, NativeArrayOptions options = NativeArrayOptions.ClearMemory)
        {
            if (length < 0)
                throw new ArgumentOutOfRangeException(nameof(length), "Length must be >= 0");
            m_Memory = NativeMemory.Allocate((long)length * sizeof(T), allocator, options);
            m_Buffer = m_Memory.Pointer;
            m_Length = length;
        }

        public NativeArray(T[] array, Allocator allocator)
            : this((array ?? throw new ArgumentNullException(nameof(array))).Length, allocator, NativeArrayOptions.UninitializedMemory) =>
                array.CopyTo(AsSpan());

        public NativeArray(NativeArray<T> array, Allocator allocator)
            : this(array.Length, allocator, NativeArrayOptions.UninitializedMemory) => array.AsReadOnlySpan().CopyTo(AsSpan());

        /// <summary>A view of memory whose life <paramref name="memory"/> tells.</summary>
        internal NativeArray(NativeMemory memory, void* buffer, int length)
        {
            m_Memory = memory;
            m_Buffer = buffer;
            m_Length = length;
        }

        public int Length => m_Length;

        public bool IsCreated => m_Memory is { IsValid: true };

        public T this[int index]
        {
            get
            {
                CheckIndex(index);
                return AsSpan()[index];
            }
            set
            {
                CheckIndex(index);
                AsSpan()[index] = value;
            }
        }

        internal void* Buffer
        {
            get
            {
                CheckAlive();
                return m_Buffer;
            }
        }

        internal NativeMemory Memory => m_Memory;

        /// <exception cref="ObjectDisposedException">The array was disposed of, or never made.</exception>
        /// <exception cref="InvalidOperationException">The array is a view that its owner frees.</exception>
        public void Dispose()
        {
            CheckAlive();
            if (m_Memory.Allocator == Allocator.None)
                throw new InvalidOperationException("The NativeArray can not be Disposed because it was not allocated with a valid allocator.");
            m_Memory.Invalidate();
        }

        public Span<T> AsSpan()
        {
            if (m_Memory == null)
                return default;
            CheckAlive();
            return new Span<T>(m_Buffer, m_Length);
        }

        public ReadOnlySpan<T> AsReadOnlySpan() => AsSpan();

        public ReadOnly AsReadOnly() => new(this);

        public T[] ToArray() => AsSpan().ToArray();

        public NativeArray<T> GetSubArray(int start, int length)
        {
            CheckAlive();
            if (start < 0 || length < 0 || (long)start + length > m_Length)
                throw new ArgumentOutOfRangeException(nameof(length),
                    $"sub array range {start}-{(long)start + length - 1} is outside the range of the native array 0-{m_Length - 1}");
            return new NativeArray<T>(m_Memory, (byte*)m_Buffer + (long)start * sizeof(T), length);
        }

        /// <summary>The same memory seen as elements of another type of the same size.</summary>
        public NativeArray<U> Reinterpret<U>() where U : struct
        {
            if (sizeof(T) != sizeof(U))
                throw new InvalidOperationException($"Types {typeof(T)} and {typeof(U)} are different sizes - direct reinterpretation is not possible. If "
                    + "this is what you intended, use Reinterpret(<type size>)");
            return Reinterpret<U>(sizeof(T));
        }

        public NativeArray<U> Reinterpret<U>(int expectedTypeSize) where U : struct
        {
            CheckAlive();
            if (expectedTypeSize != sizeof(T))
                throw new InvalidOperationException($"Type {typeof(T)} was expected to be {expectedTypeSize} but is {sizeof(T)} bytes");
            var bytes = (long)m_Length * sizeof(T);
            if (bytes % sizeof(U) != 0)
                throw new InvalidOperationException($"Types {typeof(T)} (array length {m_Length}) and {typeof(U)} cannot be aliased due to size "
                    + "constraints. The size of the types and lengths involved must line up.");
            return new NativeArray<U>(m_Memory, m_Buffer, checked((int)(bytes / sizeof(U))));
        }

        public Enumerator GetEnumerator()
        {
            var array = this;
            return new Enumerator(ref array);
        }

        IEnumerator<T> IEnumerable<T>.GetEnumerator() => GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

        public bool Equals(NativeArray<T> other) => m_Buffer == other.m_Buffer && m_Length == other.m_Length;

        public override bool Equals(object obj) => obj is NativeArray<T> other && Equals(other);

        public override int GetHashCode() => (int)(long)m_Buffer * 397 ^ m_Length;

        public static bool operator ==(NativeArray<T> left, NativeArray<T> right) => left.Equals(right);

        public static bool operator !=(NativeArray<T> left, NativeArray<T> right) => !left.Equals(right);

        public static implicit operator Span<T>(in NativeArray<T> source) => source.AsSpan();

        public static implicit operator ReadOnlySpan<T>(in NativeArray<T> source) => source.AsReadOnlySpan();

        void CheckAlive()
        {
            if (m_Memory is not { IsValid: true })
                throw new ObjectDisposedException("The NativeArray has been deallocated, it is not allowed to access it");
        }

        void CheckIndex(int index)
        {
            CheckAlive();
            if ((uint)index >= (uint)m_Length)
                throw new IndexOutOfRangeException($"Index {index} is out of range of '{m_Length}' Length.");
        }
    }
}
