using System;

namespace Unity.Collections
{
    public unsafe partial struct NativeArray<T>
    {
        /// <exception cref="ArgumentException">The lengths differ.</exception>
        public void CopyFrom(T[] array) => Copy(array, this);

        public void CopyFrom(NativeArray<T> array) => Copy(array, this);

        public void CopyTo(T[] array) => Copy(this, array);

        public void CopyTo(NativeArray<T> array) => Copy(this, array);

        public static void Copy(NativeArray<T> src, NativeArray<T> dst) => Whole(src.AsReadOnlySpan(), dst.AsSpan());

        public static void Copy(ReadOnly src, NativeArray<T> dst) => Whole(src.AsReadOnlySpan(), dst.AsSpan());

        public static void Copy(T[] src, NativeArray<T> dst) => Whole(src, dst.AsSpan());

        public static void Copy(NativeArray<T> src, T[] dst) => Whole(src.AsReadOnlySpan(), dst);

        public static void Copy(ReadOnly src, T[] dst) => Whole(src.AsReadOnlySpan(), dst);

        public static void Copy(NativeArray<T> src, NativeArray<T> dst, int length) => Copy(src, 0, dst, 0, length);

        public static void Copy(ReadOnly src, NativeArray<T> dst, int length) => Copy(src, 0, dst, 0, length);

        public static void Copy(T[] src, NativeArray<T> dst, int length) => Copy(src, 0, dst, 0, length);

        public static void Copy(NativeArray<T> src, T[] dst, int length) => Copy(src, 0, dst, 0, length);

        public static void Copy(ReadOnly src, T[] dst, int length) => Copy(src, 0, dst, 0, length);

        public static void Copy(NativeArray<T> src, int srcIndex, NativeArray<T> dst, int dstIndex, int length) =>
            src.AsReadOnlySpan().Slice(srcIndex, length).CopyTo(dst.AsSpan().Slice(dstIndex, length));

        public static void Copy(ReadOnly src, int srcIndex, NativeArray<T> dst, int dstIndex, int length) =>
            src.AsReadOnlySpan().Slice(srcIndex, length).CopyTo(dst.AsSpan().Slice(dstIndex, length));

        public static void Copy(T[] src, int srcIndex, NativeArray<T> dst, int dstIndex, int length) =>
            new ReadOnlySpan<T>(src, srcIndex, length).CopyTo(dst.AsSpan().Slice(dstIndex, length));

        public static void Copy(NativeArray<T> src, int srcIndex, T[] dst, int dstIndex, int length) =>
            src.AsReadOnlySpan().Slice(srcIndex, length).CopyTo(new Span<T>(dst, dstIndex, length));

        public static void Copy(ReadOnly src, int srcIndex, T[] dst, int dstIndex, int length) =>
            src.AsReadOnlySpan().Slice(srcIndex, length).CopyTo(new Span<T>(dst, dstIndex, length));

        static void Whole(ReadOnlySpan<T> src, Span<T> dst)
        {
            if (src.Length != dst.Length)
                throw new ArgumentException("source and destination length must be the same");
            src.CopyTo(dst);
        }
    }
}
