using System;
using System.Collections.Generic;
using System.Reflection;
using System.Runtime.InteropServices;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

#pragma warning disable CS8500 // sizeof(T): T is checked to hold no references

namespace UnityEngine
{
    /// <summary>SetData and GetData of both kinds of buffers: the checks are Unity's.</summary>
    static unsafe class BufferTransfer
    {
        internal static void Set(GpuBuffer buffer, string type, Array data, int start, int bufferStart, int count)
        {
            if (data == null)
                throw new ArgumentNullException(nameof(data));
            var element = Blittable(data.GetType().GetElementType(), type + ".SetData");
            CheckRange(start, count, data.Length, bufferStart);
            CheckFits(buffer, type + ".SetData", (long)bufferStart * element, (long)count * element);
            var handle = GCHandle.Alloc(data, GCHandleType.Pinned);
            try
            {
                buffer.Write((byte*)handle.AddrOfPinnedObject() + (long)start * element, (long)bufferStart * element, (long)count * element);
            }
            finally
            {
                handle.Free();
            }
        }

        internal static void Set<T>(GpuBuffer buffer, string type, List<T> data, int start, int bufferStart, int count) where T : struct
        {
            if (data == null)
                throw new ArgumentNullException(nameof(data));
            CheckRange(start, count, data.Count, bufferStart);
            var copy = new T[count];
            data.CopyTo(start, copy, 0, count);
            Set(buffer, type, copy, 0, bufferStart, count);
        }

        internal static void Set<T>(GpuBuffer buffer, string type, NativeArray<T> data, int start, int bufferStart, int count) where T : struct
        {
            CheckRange(start, count, data.Length, bufferStart);
            CheckFits(buffer, type + ".SetData", (long)bufferStart * sizeof(T), (long)count * sizeof(T));
            buffer.Write((byte*)data.GetUnsafeReadOnlyPtr() + (long)start * sizeof(T), (long)bufferStart * sizeof(T), (long)count * sizeof(T));
        }

        internal static void Get(GpuBuffer buffer, string type, Array data, int start, int bufferStart, int count)
        {
            if (data == null)
                throw new ArgumentNullException(nameof(data));
            var element = Blittable(data.GetType().GetElementType(), type + ".GetData");
            CheckRange(start, count, data.Length, bufferStart);
            CheckFits(buffer, type + ".GetData", (long)bufferStart * element, (long)count * element);
            var handle = GCHandle.Alloc(data, GCHandleType.Pinned);
            try
            {
                buffer.Read((byte*)handle.AddrOfPinnedObject() + (long)start * element, (long)bufferStart * element, (long)count * element);
            }
            finally
            {
                handle.Free();
            }
        }

        /// <summary>The size of an element that holds plain bits alone.</summary>
        internal static int Blittable(Type element, string api)
        {
            if (!IsBlittable(element))
                throw new ArgumentException($"Array passed to {api} must be blittable.\n{element} is not blittable.");
            return (int)typeof(BufferTransfer).GetMethod(nameof(SizeOf), BindingFlags.Static | BindingFlags.NonPublic).MakeGenericMethod(element)
                .Invoke(null, null);
        }

        static int SizeOf<T>() where T : struct => sizeof(T);

        static bool IsBlittable(Type type)
        {
            if (type.IsPrimitive)
                return type != typeof(bool) && type != typeof(char);
            if (type.IsEnum || type.IsPointer)
                return true;
            if (!type.IsValueType)
                return false;
            foreach (var field in type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
                if (!IsBlittable(field.FieldType))
                    return false;
            return true;
        }

        static void CheckRange(int start, int count, int length, int bufferStart)
        {
            if (start < 0 || bufferStart < 0 || count < 0 || (long)start + count > length)
                throw new ArgumentOutOfRangeException(nameof(count), $"Bad indices/count arguments (start:{start} bufferStart:{bufferStart} count:{count})");
        }

        static void CheckFits(GpuBuffer buffer, string api, long offset, long bytes)
        {
            if (offset + bytes > buffer.Size)
                throw new ArgumentOutOfRangeException(nameof(bytes), $"{api}: {offset + bytes} bytes do not fit into a buffer of {buffer.Size}");
        }
    }
}
