using System;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Volumes;
using UnityEngine.Networking;

namespace AnatomyCarve
{
    /// <summary>
    /// Files that no stream can be opened on, because they lie inside the application's package (StreamingAssets on Android) or on a server: copied to
    /// a folder for temporary files, and removed again. Main thread only.
    /// </summary>
    sealed class FetchedFiles : IDisposable
    {
        readonly string folder;

        /// <param name="temporaryFolder">Where the copies' own folder is made when it is needed.</param>
        public FetchedFiles(string temporaryFolder) => folder = Path.Combine(temporaryFolder, "anatomycarve-" + Guid.NewGuid().ToString("N"));

        /// <summary>Copies a file, streaming, if it is one of these.</summary>
        /// <param name="path">A path or an address; null = no file.</param>
        /// <returns>The path of the copy, which has the same file name; paths and null come back as they are.</returns>
        /// <exception cref="AnatomyCarveException">It cannot be fetched.</exception>
        public async Task<string> FetchAsync(string path, CancellationToken cancellationToken, IProgress<float> progress)
        {
            if (!VolumePaths.IsAddress(path))
                return path;
            string copy = Path.Combine(folder, VolumePaths.FileNameOf(path));
            using UnityWebRequest request = UnityWebRequest.Get(path);
            request.downloadHandler = new DownloadHandlerFile(copy) { removeFileOnAbort = true };
            UnityWebRequestAsyncOperation operation = request.SendWebRequest();
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

        public void Dispose()
        {
            if (Directory.Exists(folder))
                Directory.Delete(folder, true);
        }
    }
}
