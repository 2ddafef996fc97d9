using System;
using System.IO;
using System.IO.Compression;
using System.Threading;
using System.Threading.Tasks;

namespace UnityEngine.Networking
{
    /// <summary>Brings a request's data to its handler, on a thread of its own.</summary>
    sealed class Transfer
    {
        const string FileScheme = "file://", JarScheme = "jar:file://", JarEntry = "!/";
        const int BlockSize = 1 << 16;

        readonly string m_Url;
        readonly DownloadHandler m_Handler;
        readonly CancellationToken m_Cancellation;
        Task m_Task;
        long m_Received;
        long m_Total = -1;

        internal Transfer(string url, DownloadHandler handler, CancellationToken cancellation)
        {
            m_Url = url;
            m_Handler = handler;
            m_Cancellation = cancellation;
        }

        internal bool IsOver => m_Task.IsCompleted;

        internal long Received => Interlocked.Read(ref m_Received);

        internal float Progress => Interlocked.Read(ref m_Total) is var total and > 0 ? (float)Received / total : 0f;

        /// <summary>How it ended; valid once it is over.</summary>
        internal (UnityWebRequest.Result Result, string Error, long Code) Outcome { get; private set; }

        internal void Begin() => m_Task = Task.Run(Run);

        internal void Wait() => m_Task.Wait();

        void Run()
        {
            try
            {
                m_Cancellation.ThrowIfCancellationRequested();
                Copy();
                m_Handler?.End(null);
                Outcome = (UnityWebRequest.Result.Success, null, 200);
            }
            catch (OperationCanceledException)
            {
                Fail(UnityWebRequest.Result.ConnectionError, "Request aborted", 0);
            }
            catch (EntryMissingException)
            {
                Fail(UnityWebRequest.Result.ProtocolError, "HTTP/1.1 404 Not Found", 404);
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException or InvalidDataException or NotSupportedException)
            {
                Fail(UnityWebRequest.Result.ConnectionError, $"Cannot open file: {e.Message}", 0);
            }
        }

        void Copy()
        {
            if (m_Url.StartsWith(JarScheme, StringComparison.Ordinal) && m_Url.IndexOf(JarEntry, StringComparison.Ordinal) is var end and > 0)
            {
                using var package = ZipFile.OpenRead(PathIn(m_Url.Substring(JarScheme.Length, end - JarScheme.Length)));
                var entry = package.GetEntry(PathIn(m_Url.Substring(end + JarEntry.Length))) ?? throw new EntryMissingException();
                using var inside = entry.Open();
                Pass(inside, entry.Length);
                return;
            }

            if (!m_Url.StartsWith(FileScheme, StringComparison.Ordinal))
                throw new NotSupportedException($"{m_Url} is no address that the host opens; expected {FileScheme} or {JarScheme}PACKAGE{JarEntry}PATH");
            using var file = File.OpenRead(PathIn(m_Url.Substring(FileScheme.Length)));
            Pass(file, file.Length);
        }

        void Pass(Stream source, long length)
        {
            Interlocked.Exchange(ref m_Total, length);
            m_Handler?.Begin();
            var block = new byte[BlockSize];
            for (int count; (count = source.Read(block, 0, block.Length)) > 0;)
            {
                m_Cancellation.ThrowIfCancellationRequested();
                m_Handler?.Receive(block.AsSpan(0, count));
                Interlocked.Add(ref m_Received, count);
            }
        }

        void Fail(UnityWebRequest.Result result, string error, long code)
        {
            m_Handler?.End(error);
            Outcome = (result, error, code);
        }

        /// <summary>Addresses may have blanks and the like as %20; Unity takes them as they are too.</summary>
        static string PathIn(string address) => Uri.UnescapeDataString(address);

        sealed class EntryMissingException : Exception
        {
        }
    }
}
