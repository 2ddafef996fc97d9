using System;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>Where a read-back is in its life.</summary>
    enum ReadbackState
    {
        Pending,
        Done,
        Failed,
        Expired,
    }

    /// <summary>One read-back: mapped memory that the device fills, readable for one frame.</summary>
    sealed unsafe class ReadbackOperation
    {
        NativeMemory m_View;
        byte* m_Converted;

        internal ReadbackState State { get; private set; }

        internal int Width { get; set; }

        internal int Height { get; set; }

        internal int Layers { get; set; } = 1;

        /// <summary>Bytes of a layer as the caller sees it.</summary>
        internal long LayerBytes { get; set; }

        /// <summary>The frame in which it was asked for.</summary>
        internal long Frame { get; set; }

        /// <summary>Filled by the device.</summary>
        internal VulkanBuffer Buffer { get; set; }

        /// <summary>Formats of the device's texels and of those the caller sees; null if they are the same.</summary>
        internal (FormatInfo From, FormatInfo To)? Conversion { get; set; }

        /// <summary>Where the bytes are copied; an array that is not valid if nowhere.</summary>
        internal NativeArray<byte> Output { get; set; }

        internal Action<AsyncGPUReadbackRequest> Callback { get; set; }

        byte* Result => m_Converted != null ? m_Converted : Buffer.Mapped;

        internal static ReadbackOperation Failure() => new() { State = ReadbackState.Failed };

        /// <summary>The device is done: the bytes become readable, and the callback runs.</summary>
        internal void Complete()
        {
            State = ReadbackState.Done;
            if (Conversion is { } conversion)
            {
                var texels = (long)Width * Height * Layers;
                m_Converted = (byte*)Marshal.AllocHGlobal((IntPtr)(LayerBytes * Layers));
                TexelCodec.Convert(conversion.From, Buffer.Mapped, conversion.To, m_Converted, texels);
            }
            if (Output.IsCreated)
                new ReadOnlySpan<byte>(Result, checked((int)(LayerBytes * Layers))).CopyTo(Output.AsSpan());
            Invoke();
        }

        internal void Fail()
        {
            State = ReadbackState.Failed;
            Invoke();
        }

        internal NativeArray<T> Data<T>(int layer) where T : struct
        {
            m_View ??= NativeMemory.Borrow(Result);
            return new NativeArray<T>(m_View, Result + LayerBytes * layer, checked((int)(LayerBytes / PixelTransfer.SizeOf<T>())));
        }

        /// <summary>Ends the access to the bytes.</summary>
        internal void Expire()
        {
            m_View?.Invalidate();
            m_View = null;
            if (m_Converted != null)
                Marshal.FreeHGlobal((IntPtr)m_Converted);
            m_Converted = null;
            if (State == ReadbackState.Done)
                State = ReadbackState.Expired;
        }

        void Invoke()
        {
            var callback = Callback;
            Callback = null;
            if (callback != null)
                LogRouter.Guard(() => callback(new AsyncGPUReadbackRequest(this)));
        }
    }
}
