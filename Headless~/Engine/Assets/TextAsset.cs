using System;
using System.Text;
using Unity.Collections;

#pragma warning disable CS8500 // sizeof(T): T is a struct without references, which NativeArray checks

namespace UnityEngine
{
    /// <summary>Text or bytes, as they are.</summary>
    public unsafe class TextAsset : Object
    {
        readonly NativeMemory m_Memory;
        readonly int m_Length;

        public TextAsset() : this(ReadOnlySpan<byte>.Empty)
        {
        }

        /// <summary>UTF-8.</summary>
        public TextAsset(string text) : this((ReadOnlySpan<byte>)Encoding.UTF8.GetBytes(text ?? ""))
        {
        }

        public TextAsset(ReadOnlySpan<byte> bytes)
        {
            MainThread.Check("TextAsset constructor");
            m_Length = bytes.Length;
            m_Memory = NativeMemory.Own(bytes);
        }

        /// <summary>A copy of the bytes with each call.</summary>
        public byte[] bytes
        {
            get { Use("get_bytes"); return new ReadOnlySpan<byte>(m_Memory.Pointer, m_Length).ToArray(); }
        }

        /// <summary>The bytes as UTF-8, or what a byte order mark says.</summary>
        public string text
        {
            get { Use("get_text"); return Decode(new ReadOnlySpan<byte>(m_Memory.Pointer, m_Length)); }
        }

        public long dataSize
        {
            get { Use("get_dataSize"); return m_Length; }
        }

        /// <summary>The bytes themselves, not a copy; valid until the asset is destroyed.</summary>
        /// <exception cref="ArgumentException">They do not divide into whole elements.</exception>
        public NativeArray<T> GetData<T>() where T : struct
        {
            Use("GetData");
            if (m_Length % sizeof(T) != 0)
                throw new ArgumentException($"Type passed to {nameof(GetData)} {typeof(T).Name} has {sizeof(T)} bytes, which do not divide {m_Length}");
            return new NativeArray<T>(m_Memory, m_Memory.Pointer, m_Length / sizeof(T));
        }

        public override string ToString() => text;

        internal override void OnNativeDestroy() => m_Memory.Invalidate();

        static string Decode(ReadOnlySpan<byte> bytes)
        {
            foreach (var encoding in new Encoding[] { new UTF8Encoding(true), new UTF32Encoding(false, true), Encoding.Unicode, Encoding.BigEndianUnicode })
                if (bytes.StartsWith(encoding.GetPreamble()))
                    return encoding.GetString(bytes[encoding.GetPreamble().Length..]);
            return Encoding.UTF8.GetString(bytes);
        }
    }
}
