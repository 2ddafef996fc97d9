using System;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// Loads a segmented volume, from files or from memory, and publishes it to the components on its GameObject. Its transform is the
    /// volume's: +x is the patient's left, +y superior, +z posterior, in metres around the volume's centre. What is shown stays until another
    /// volume has been loaded completely.
    /// </summary>
    [AddComponentMenu("AnatomyCarve/Volume Loader")]
    [DisallowMultipleComponent]
    public sealed class VolumeLoader : MonoBehaviour
    {
        [SerializeField, Tooltip("NIfTI or NRRD file with intensities; a relative path counts from StreamingAssets")]
        string intensityPath = "";

        [SerializeField, Tooltip("NIfTI or NRRD file with labels on the same grid; empty = everything is unlabelled")]
        string labelsPath = "";

        [SerializeField, Tooltip("Load these files when the scene starts")]
        bool loadOnStart = true;

        CancellationTokenSource loading;
        LoadProgress newest;

        /// <summary>Raised on the main thread when another volume has been loaded or set.</summary>
        public event Action<SegmentedVolume> Loaded;

        /// <summary>Raised on the main thread when loading failed; not when it was cancelled.</summary>
        public event Action<Exception> Failed;

        /// <summary>The volume that is shown; null while there is none.</summary>
        public SegmentedVolume Volume { get; private set; }

        /// <summary>Progress of the load that runs or ran last, 0 to 1.</summary>
        public float Progress => newest?.Value ?? 0f;

        /// <summary>Whether a load is running.</summary>
        public bool IsLoading => loading != null;

        /// <summary>The file with intensities that is loaded on start. A relative path counts from StreamingAssets.</summary>
        public string IntensityPath
        {
            get => intensityPath;
            set => intensityPath = value ?? "";
        }

        /// <summary>The file with labels that is loaded on start; empty = everything is unlabelled.</summary>
        public string LabelsPath
        {
            get => labelsPath;
            set => labelsPath = value ?? "";
        }

        /// <summary>Whether the files are loaded when the component starts.</summary>
        public bool LoadOnStart
        {
            get => loadOnStart;
            set => loadOnStart = value;
        }

        /// <summary>
        /// Loads a volume. Files are read on another thread; a load that is still running is cancelled. Call it on the main thread, where it
        /// also ends. If it fails or is cancelled, the volume that was there stays. What was odd in the files is logged, a warning each.
        /// </summary>
        /// <param name="intensityPath">File with intensities (NIfTI-1 or NRRD). A relative path counts from StreamingAssets.</param>
        /// <param name="labelsPath">File with labels on the same grid, path likewise; null or empty = everything is unlabelled.</param>
        /// <param name="cancellationToken">Stops the load; destroying the component and quitting do so too.</param>
        /// <param name="progress">Gets 0 to 1 on the thread that reads; a <see cref="Progress{T}"/> made on the main thread brings it there.</param>
        /// <returns>The volume, which is <see cref="Volume"/> by then.</returns>
        /// <exception cref="ArgumentException">There is no path.</exception>
        /// <exception cref="VolumeFormatException">A file cannot be read.</exception>
        /// <exception cref="VolumeMismatchException">The two files are on different grids.</exception>
        /// <exception cref="AnatomyCarveException">A file lies inside the application's package, as StreamingAssets does on Android.</exception>
        /// <exception cref="OperationCanceledException">The load was cancelled, or another one was started.</exception>
        public async Task<SegmentedVolume> LoadAsync(
            string intensityPath, string labelsPath = null, CancellationToken cancellationToken = default, IProgress<float> progress = null)
        {
            if (string.IsNullOrEmpty(intensityPath))
                throw new ArgumentException("A volume needs a file with intensities.", nameof(intensityPath));
            Cancel();
            using (var source = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken, destroyCancellationToken, Application.exitCancellationToken))
            {
                loading = source;
                CancellationToken token = source.Token;
                var relay = new LoadProgress(progress);
                newest = relay;
                SegmentedVolume volume;
                try
                {
                    relay.Report(0f);
                    string intensity = VolumePaths.Resolve(intensityPath, Application.streamingAssetsPath);
                    string labels = VolumePaths.Resolve(labelsPath, Application.streamingAssetsPath);
                    volume = await Task.Run(() => VolumeReading.Read(intensity, labels, token, relay), token);
                    token.ThrowIfCancellationRequested();
                }
                catch (Exception e) when (!(e is OperationCanceledException))
                {
                    if (!token.IsCancellationRequested)
                        Failed?.Invoke(e);
                    throw;
                }
                finally
                {
                    if (loading == source)
                        loading = null;
                }
                relay.Report(1f);
                foreach (string warning in volume.Warnings)
                    Debug.LogWarning(warning, this);
                Publish(volume);
                return volume;
            }
        }

        /// <summary>Shows a volume that is in memory already. A load that is still running is cancelled.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="volume"/> is null; <see cref="Unload"/> shows nothing.</exception>
        public void SetVolume(SegmentedVolume volume)
        {
            if (volume == null)
                throw new ArgumentNullException(nameof(volume));
            Cancel();
            Publish(volume);
        }

        /// <summary>Shows nothing any more and lets go of the volume; renderers free its textures. A load that is still running is cancelled.</summary>
        public void Unload()
        {
            Cancel();
            Volume = null;
        }

        /// <summary>Cancels the load that is running, if any.</summary>
        public void Cancel()
        {
            loading?.Cancel();
            loading = null;
        }

        async void Start()
        {
            if (!loadOnStart || intensityPath.Length == 0 || Volume != null)
                return;
            try
            {
                await LoadAsync(intensityPath, labelsPath);
            }
            catch (OperationCanceledException)
            {
                // Another load took its place, or the scene ended.
            }
            catch (Exception e)
            {
                Debug.LogException(e, this);
            }
        }

        void OnDestroy()
        {
            Cancel();
            Volume = null;
        }

        void Publish(SegmentedVolume volume)
        {
            Volume = volume;
            Loaded?.Invoke(volume);
        }
    }
}
