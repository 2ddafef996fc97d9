using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Text;

namespace UnityEngine.Vulkan
{
    /// <summary>Zero-terminated UTF-8 strings that live until this is disposed.</summary>
    sealed unsafe class NativeText : IDisposable
    {
        readonly List<nint> m_Blocks = new();

        internal static string Read(byte* text)
        {
            if (text == null)
                return "";
            var length = 0;
            while (text[length] != 0)
                length++;
            return Encoding.UTF8.GetString(text, length);
        }

        internal byte* Add(string text)
        {
            var bytes = Encoding.UTF8.GetBytes(text);
            var block = Marshal.AllocHGlobal(bytes.Length + 1);
            m_Blocks.Add(block);
            Marshal.Copy(bytes, 0, block, bytes.Length);
            ((byte*)block)[bytes.Length] = 0;
            return (byte*)block;
        }

        /// <summary>An array of pointers to the strings; null when there are none.</summary>
        internal byte** AddAll(IReadOnlyList<string> texts)
        {
            if (texts.Count == 0)
                return null;
            var block = Marshal.AllocHGlobal(texts.Count * sizeof(nint));
            m_Blocks.Add(block);
            var pointers = (byte**)block;
            for (var i = 0; i < texts.Count; i++)
                pointers[i] = Add(texts[i]);
            return pointers;
        }

        public void Dispose()
        {
            foreach (var block in m_Blocks)
                Marshal.FreeHGlobal(block);
            m_Blocks.Clear();
        }
    }
}
