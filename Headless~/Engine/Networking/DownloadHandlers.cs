using System;
using System.IO;
using System.Text;

namespace UnityEngine.Networking
{
    /// <summary>Takes what a request brings.</summary>
    public class DownloadHandler : IDisposable
    {
        internal DownloadHandler()
        {
        }

        /// <summary>Whether all data have arrived.</summary>
        public bool isDone { get; private set; }

        public string error { get; private set; }

        /// <summary>A copy of the data; null where they are not kept.</summary>
        public byte[] data => GetData();

        /// <summary>The data as UTF-8.</summary>
        public string text => GetText();

        public virtual void Dispose()
        {
        }

        protected virtual byte[] GetData() => null;

        protected virtual string GetText() => GetData() is { } bytes ? Encoding.UTF8.GetString(bytes) : null;

        /// <summary>Begins with the data; called on another thread.</summary>
        internal virtual void Begin()
        {
        }

        internal virtual void Receive(ReadOnlySpan<byte> bytes)
        {
        }

        /// <summary>Ends with the data.</summary>
        /// <param name="failed">What went wrong; null if all are there.</param>
        internal virtual void End(string failed)
        {
            isDone = failed == null;
            error = failed;
        }
    }

    /// <summary>Keeps the data in memory.</summary>
    public sealed class DownloadHandlerBuffer : DownloadHandler
    {
        readonly MemoryStream m_Bytes = new();

        public DownloadHandlerBuffer()
        {
        }

        /// <exception cref="InvalidOperationException">The request is not done, or failed.</exception>
        public static string GetContent(UnityWebRequest www) => www.isDone && www.error == null
            ? www.downloadHandler.text
            : throw new InvalidOperationException(www.error ?? "Cannot get content from an unfinished UnityWebRequest object");

        public override void Dispose() => m_Bytes.Dispose();

        protected override byte[] GetData() => m_Bytes.ToArray();

        internal override void Receive(ReadOnlySpan<byte> bytes) => m_Bytes.Write(bytes);
    }

    /// <summary>Writes the data into a file.</summary>
    public sealed class DownloadHandlerFile : DownloadHandler
    {
        readonly string m_Path;
        readonly bool m_Append;
        FileStream m_File;

        public DownloadHandlerFile(string path) : this(path, false)
        {
        }

        /// <param name="path">The file; its folder is made if need be.</param>
        /// <param name="append">Whether what it holds stays.</param>
        public DownloadHandlerFile(string path, bool append)
        {
            m_Path = path ?? throw new ArgumentNullException(nameof(path));
            m_Append = append;
            if (Path.GetDirectoryName(path) is { Length: > 0 } folder)
                Directory.CreateDirectory(folder);
        }

        /// <summary>Whether a request that fails leaves no file.</summary>
        public bool removeFileOnAbort { get; set; }

        public override void Dispose() => m_File?.Dispose();

        protected override byte[] GetData() => throw new NotSupportedException("Raw data access is not supported");

        protected override string GetText() => throw new NotSupportedException("String access is not supported");

        internal override void Begin() => m_File = new FileStream(m_Path, m_Append ? FileMode.Append : FileMode.Create);

        internal override void Receive(ReadOnlySpan<byte> bytes) => m_File.Write(bytes);

        internal override void End(string failed)
        {
            m_File?.Dispose();
            m_File = null;
            if (failed != null && removeFileOnAbort)
                File.Delete(m_Path);
            base.End(failed);
        }
    }
}
