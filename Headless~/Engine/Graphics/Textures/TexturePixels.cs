using System;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Vulkan;

#pragma warning disable CS8500 // sizeof(T): T holds no references, which its callers check

namespace UnityEngine
{
    /// <summary>
    /// The texels of a texture that the CPU fills: its own copy, made when it is first touched, and the image on the device, made at the
    /// first Apply or use. Mip levels lie one after the other; within a level slices (volume) or layers (array).
    /// </summary>
    sealed unsafe class TexturePixels : IDisposable
    {
        const byte Fill = 0xCD;

        readonly string m_Kind;
        readonly Texture m_Owner;
        readonly bool m_Uninitialized;
        NativeMemory m_View;
        byte* m_Copy;
        GpuTexture m_Native;

        internal TexturePixels(string kind, Texture owner, in ImageShape shape, FormatInfo format, bool uninitialized)
        {
            m_Kind = kind;
            m_Owner = owner;
            Shape = shape;
            Format = format;
            m_Uninitialized = uninitialized;
        }

        internal ImageShape Shape { get; }

        internal FormatInfo Format { get; }

        internal bool IsReadable { get; private set; } = true;

        internal GpuTexture Native
        {
            get
            {
                if (m_Native == null)
                    Upload();
                return m_Native;
            }
        }

        /// <summary>Bytes of all mip levels.</summary>
        long TotalBytes => Offset(Shape.Mips, 0);

        /// <summary>Bytes of one slice-complete level, or of one layer of it.</summary>
        internal long LevelBytes(int mip)
        {
            var (width, height, depth) = Shape.Mip(mip);
            return (long)width * height * depth * Format.BytesPerTexel;
        }

        internal void Set(void* source, long bytes, int mip, int layer, string api)
        {
            Check(mip, layer);
            var needed = LevelBytes(mip);
            if (bytes < needed)
                throw new UnityException($"{api}: Not enough data provided: {bytes} bytes for a mip level of {needed} (texture '{m_Owner.NameForMessages}').");
            // A level that is set as a whole needs no pattern before.
            Ensure(fill: Shape.Mips > 1 || Shape.Layers > 1);
            Buffer.MemoryCopy(source, m_Copy + Offset(mip, layer), needed, needed);
        }

        /// <summary>The copy itself as an array, valid until the copy is dropped.</summary>
        internal NativeArray<T> View<T>(int mip, int layer) where T : struct
        {
            Check(mip, layer);
            Ensure(fill: !m_Uninitialized || GpuOptions.FillNewMemory);
            return new NativeArray<T>(m_View, m_Copy + Offset(mip, layer), checked((int)(LevelBytes(mip) / sizeof(T))));
        }

        /// <summary>All levels as an array.</summary>
        internal NativeArray<T> ViewAll<T>() where T : struct
        {
            Check(0, 0);
            Ensure(fill: true);
            return new NativeArray<T>(m_View, m_Copy, checked((int)(TotalBytes / sizeof(T))));
        }

        /// <summary>A texel in the copy.</summary>
        internal byte* Texel(int mip, int layer, int x, int y, int z)
        {
            Check(mip, layer);
            Ensure(fill: true);
            var (width, height, _) = Shape.Mip(mip);
            return m_Copy + Offset(mip, layer) + (((long)z * height + y) * width + x) * Format.BytesPerTexel;
        }

        internal void Apply(bool updateMipmaps, bool makeNoLongerReadable)
        {
            if (!IsReadable)
                throw m_Owner.NotReadable();
            Ensure(fill: true);
            if (updateMipmaps && Shape.Mips > 1 && !Format.IsInteger)
                MipBuilder.Build(this);
            Upload();
            m_Owner.IncrementUpdateCount();
            if (!makeNoLongerReadable)
                return;
            IsReadable = false;
            DropCopy();
        }

        public void Dispose()
        {
            DropCopy();
            m_Native?.Release();
            m_Native = null;
        }

        void Upload()
        {
            m_Native ??= new GpuTexture(m_Kind, m_Owner.NameForMessages, Shape, Format, randomWrite: false);
            if (m_Copy == null)
            {
                m_Native.FillUndefined();
                return;
            }
            for (var mip = 0; mip < Shape.Mips; mip++)
            {
                var (width, height, depth) = Shape.Mip(mip);
                for (var layer = 0; layer < Shape.Layers; layer++)
                    m_Native.Upload(mip, new TexelBox(0, 0, layer, width, height, depth), m_Copy + Offset(mip, layer));
            }
        }

        long Offset(int mip, int layer)
        {
            long offset = 0;
            for (var m = 0; m < mip; m++)
                offset += LevelBytes(m) * Shape.Layers;
            return mip < Shape.Mips ? offset + LevelBytes(mip) * layer : offset;
        }

        void Check(int mip, int layer)
        {
            if (!IsReadable)
                throw m_Owner.NotReadable();
            if (mip < 0 || mip >= Shape.Mips)
                throw new UnityException($"Mip level {mip} is outside 0 to {Shape.Mips - 1} (texture '{m_Owner.NameForMessages}').");
            if (layer < 0 || layer >= Shape.Layers)
                throw new UnityException($"Element {layer} is outside 0 to {Shape.Layers - 1} (texture '{m_Owner.NameForMessages}').");
        }

        void Ensure(bool fill)
        {
            if (m_Copy != null)
                return;
            var bytes = TotalBytes;
            m_Copy = (byte*)Marshal.AllocHGlobal((IntPtr)bytes);
            m_View = NativeMemory.Borrow(m_Copy);
            GC.AddMemoryPressure(bytes);
            for (long done = 0; fill && done < bytes; done += 1 << 30)
                new Span<byte>(m_Copy + done, (int)Math.Min(bytes - done, 1 << 30)).Fill(Fill);
        }

        void DropCopy()
        {
            if (m_Copy == null)
                return;
            m_View.Invalidate();
            Marshal.FreeHGlobal((IntPtr)m_Copy);
            GC.RemoveMemoryPressure(TotalBytes);
            m_Copy = null;
        }
    }
}
