using System;
using System.Threading;

namespace UnityEngine.Networking
{
    /// <summary>
    /// Fetches a file by its address. The host knows file:// and, for what lies inside an Android application's package, jar:file://PACKAGE!/PATH; it opens no
    /// connections. Data arrive on another thread; the request is done at the start of a later frame, on the main thread.
    /// </summary>
    public class UnityWebRequest : IDisposable
    {
        public const string kHttpVerbGET = "GET";

        readonly CancellationTokenSource m_Abort = new();
        Transfer m_Transfer;
        UnityWebRequestAsyncOperation m_Operation;
        string m_Error;
        bool m_Disposed;

        public UnityWebRequest() : this("")
        {
        }

        public UnityWebRequest(string url) : this(url, kHttpVerbGET)
        {
        }

        public UnityWebRequest(string url, string method) : this(url, method, null)
        {
        }

        UnityWebRequest(string url, string method, DownloadHandler handler)
        {
            MainThread.Check("UnityWebRequest constructor");
            this.url = url ?? "";
            this.method = method ?? kHttpVerbGET;
            downloadHandler = handler;
        }

        /// <summary>How a request ended.</summary>
        public enum Result
        {
            InProgress = 0,
            Success = 1,
            ConnectionError = 2,
            ProtocolError = 3,
            DataProcessingError = 4,
        }

        public string url { get; set; }

        public string method { get; set; }

        /// <summary>Takes the data; not to be changed once the request was sent.</summary>
        public DownloadHandler downloadHandler { get; set; }

        public bool disposeDownloadHandlerOnDispose { get; set; } = true;

        public Result result { get; private set; } = Result.InProgress;

        /// <summary>What went wrong; null if nothing did.</summary>
        public string error => m_Error;

        public bool isDone => m_Operation is { isDone: true };

        /// <summary>As HTTP has them: 200, 404; 0 while there is none.</summary>
        public long responseCode { get; private set; }

        public ulong downloadedBytes => m_Transfer == null ? 0 : (ulong)m_Transfer.Received;

        /// <summary>0 to 1; -1 before the request was sent.</summary>
        public float downloadProgress => m_Operation == null ? -1f : isDone ? 1f : m_Transfer.Progress;

        /// <summary>A request that takes the data into memory.</summary>
        public static UnityWebRequest Get(string uri) => new(uri, kHttpVerbGET, new DownloadHandlerBuffer());

        public static UnityWebRequest Get(Uri uri) => Get((uri ?? throw new ArgumentNullException(nameof(uri))).OriginalString);

        /// <exception cref="InvalidOperationException">It was sent before, or the address is one of http:// on another machine, as projects have it.</exception>
        public UnityWebRequestAsyncOperation SendWebRequest()
        {
            MainThread.Check("SendWebRequest");
            if (m_Disposed)
                throw new InvalidOperationException("UnityWebRequest has been disposed");
            if (m_Operation != null)
                throw new InvalidOperationException("UnityWebRequest has already been sent; cannot begin sending the request again");
            if (url.StartsWith("http://", StringComparison.OrdinalIgnoreCase) && !new Uri(url).IsLoopback)
                throw new InvalidOperationException("Insecure connection not allowed");
            m_Transfer = new Transfer(url, downloadHandler, m_Abort.Token);
            m_Operation = new UnityWebRequestAsyncOperation(this);
            m_Transfer.Begin();
            AsyncOperations.Add(m_Operation, IsOver);
            return m_Operation;
        }

        /// <summary>Ends the request as soon as possible; it is then an error.</summary>
        public void Abort()
        {
            MainThread.Check("Abort");
            if (!m_Disposed && !isDone)
                m_Abort.Cancel();
        }

        /// <summary>Ends the request, if it still runs, and frees its data.</summary>
        public void Dispose()
        {
            if (m_Disposed)
                return;
            m_Abort.Cancel();
            m_Transfer?.Wait();
            m_Disposed = true;
            if (disposeDownloadHandlerOnDispose)
                downloadHandler?.Dispose();
            m_Abort.Dispose();
            GC.SuppressFinalize(this);
        }

        internal float Progress => m_Transfer.Progress;

        bool IsOver()
        {
            if (!m_Transfer.IsOver)
                return false;
            (result, m_Error, responseCode) = m_Transfer.Outcome;
            return true;
        }
    }

    /// <summary>A request that was sent.</summary>
    public class UnityWebRequestAsyncOperation : AsyncOperation
    {
        internal UnityWebRequestAsyncOperation(UnityWebRequest request) => webRequest = request;

        public UnityWebRequest webRequest { get; }

        internal override float Progress() => webRequest.Progress;
    }
}
