using System;
using System.Globalization;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Networking;

namespace AnatomyCarve
{
    /// <summary>
    /// Files that no stream can be opened on, because they lie inside the application's package (StreamingAssets on Android) or on a server: copied to
    /// a folder for temporary files, and removed again. Main thread only.
    /// </summary>
    sealed class FetchedFiles : IDisposable
    {
        const string Prefix = "anatomycarve-";

        /// <summary>No load takes as long: a folder that is older was left by a process that was ended.</summary>
        static readonly TimeSpan Leftover = TimeSpan.FromDays(1);

        readonly string folder;
        int fetched;

        /// <param name="temporaryFolder">Where the copies' own folder is made when it is needed. What was left there long ago is removed.</param>
        public FetchedFiles(string temporaryFolder)
        {
            folder = Path.Combine(temporaryFolder, Prefix + Guid.NewGuid().ToString("N"));
            RemoveLeftovers(temporaryFolder);
        }

        /// <summary>Copies a file, streaming, if it is one of these.</summary>
        /// <param name="path">A path or an address; null = no file.</param>
        /// <returns>The path of the copy, which has the same file name; paths and null come back as they are.</returns>
        /// <exception cref="AnatomyCarveException">It cannot be fetched.</exception>
        public async Task<string> FetchAsync(string path, CancellationToken cancellationToken, IProgress<float> progress)
        {
            if (!VolumePaths.IsAddress(path))
                return path;
            // A folder for each: a scan and its labels may have the same name.
            string copy = Path.Combine(folder, (++fetched).ToString(CultureInfo.InvariantCulture), VolumePaths.FileNameOf(path));
            Directory.CreateDirectory(Path.GetDirectoryName(copy));
            using UnityWebRequest request = UnityWebRequest.Get(path);
            request.downloadHandler = new DownloadHandlerFile(copy) { removeFileOnAbort = true };
            UnityWebRequestAsyncOperation operation = Send(request, path);
            while (!operation.isDone)
            {
                if (cancellationToken.IsCancellationRequested)
                    request.Abort();
                cancellationToken.ThrowIfCancellationRequested();
                progress.Report(request.downloadProgress);
                await Task.Yield(); // until the next frame
            }
            if (request.result != UnityWebRequest.Result.Success)
                throw new AnatomyCarveException($"{path} could not be fetched: {request.error}.");
            progress.Report(1f);
            return copy;
        }

        public void Dispose() => Remove(folder);

        /// <exception cref="AnatomyCarveException">Unity refuses the address.</exception>
        static UnityWebRequestAsyncOperation Send(UnityWebRequest request, string path)
        {
            try
            {
                return request.SendWebRequest();
            }
            catch (InvalidOperationException e)
            {
                throw new AnatomyCarveException($"{path} could not be fetched: {e.Message.TrimEnd('.')}. Use https://, or allow http:// in Project "
                    + "Settings > Player > Allow downloads over HTTP.", e);
            }
        }

        static void RemoveLeftovers(string temporaryFolder)
        {
            if (!Directory.Exists(temporaryFolder))
                return;
            foreach (string old in Directory.GetDirectories(temporaryFolder, Prefix + "*"))
                if (DateTime.UtcNow - Directory.GetLastWriteTimeUtc(old) > Leftover)
                    Remove(old);
        }

        /// <summary>What cannot be removed is said, and tried again by a later load.</summary>
        static void Remove(string folder)
        {
            try
            {
                if (Directory.Exists(folder))
                    Directory.Delete(folder, true);
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
            {
                Debug.LogWarning($"Temporary files in {folder} could not be removed: {e.Message}");
            }
        }
    }
}
