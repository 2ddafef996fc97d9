namespace Unity.Collections.LowLevel.Unsafe
{
    /// <summary>Pointers to the memory of native arrays.</summary>
    public static unsafe class NativeArrayUnsafeUtility
    {
        public static void* GetUnsafePtr<T>(this NativeArray<T> nativeArray) where T : struct => nativeArray.Buffer;

        public static void* GetUnsafeReadOnlyPtr<T>(this NativeArray<T> nativeArray) where T : struct => nativeArray.Buffer;

        public static void* GetUnsafeReadOnlyPtr<T>(this NativeArray<T>.ReadOnly nativeArray) where T : struct => nativeArray.Buffer;

        public static void* GetUnsafeBufferPointerWithoutChecks<T>(NativeArray<T> nativeArray) where T : struct =>
            nativeArray.IsCreated ? nativeArray.Buffer : null;

        /// <summary>An array over memory that the caller owns and keeps alive.</summary>
        public static NativeArray<T> ConvertExistingDataToNativeArray<T>(void* dataPointer, int length, Allocator allocator) where T : struct
        {
            if (length < 0)
                throw new System.ArgumentOutOfRangeException(nameof(length), "Length must be >= 0");
            if (allocator != Allocator.None)
                throw new System.ArgumentException("Only memory that stays its owner's (Allocator.None) is supported", nameof(allocator));
            return new NativeArray<T>(NativeMemory.Borrow(dataPointer), dataPointer, length);
        }
    }
}
