using System;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// Loads a segmented volume, from an asset, from files or from memory, and publishes it to the components on its GameObject, whose local space is then the
    /// patient's: +x left, +y superior, +z posterior, in metres around the volume's centre. What is shown stays until another volume has been loaded completely;
    /// where nothing is shown, a large volume is shown coarse first.
    /// </summary>
    [AddComponentMenu("AnatomyCarve/Volume Loader")]
    [DisallowMultipleComponent]
    [ExecuteAlways]
    [ManualPage("components")]
    public sealed class VolumeLoader : MonoBehaviour
    {
        [SerializeField, Tooltip("A volume that the Editor imported: the fastest way; it comes before files")]
        VolumeAsset asset;

        [SerializeField, Tooltip("NIfTI or NRRD file with intensities; a relative path counts from StreamingAssets")]
        string intensityPath = "";

        [SerializeField, Tooltip("NIfTI or NRRD file with labels on the same grid; empty = everything is unlabelled")]
        string labelsPath = "";

        [SerializeField, Tooltip("Load the asset or these files when the scene starts, and in the Editor outside Play")]
        bool loadOnStart = true;

        [SerializeField, Tooltip("What to do with large volumes")]
        MemorySettings memory = new MemorySettings();

        StartSource begun;
        LoadRun load;

        /// <summary>Raised on the main thread when another volume has been loaded completely, or set.</summary>
        public event Action<SegmentedVolume> Loaded;

        /// <summary>
        /// Raised on the main thread when a coarse volume is shown while the rest of it loads. It has all segments and can be carved already. If the load fails
        /// or is cancelled, it is taken away.
        /// </summary>
        public event Action<SegmentedVolume> CoarseLoaded;

        /// <summary>Raised on the main thread when a load knows what its volume will take, before anything large is taken. <see cref="Cancel"/> stops it.</summary>
        public event Action<MemoryForecast> Forecast;

        /// <summary>Raised on the main thread when loading failed; not when it was cancelled.</summary>
        public event Action<Exception> Failed;

        /// <summary>The volume that is shown, which may be a coarse one; null while there is none.</summary>
        public SegmentedVolume Volume { get; private set; }

        /// <summary>Whether <see cref="Volume"/> is a coarse one, of which the rest is being loaded.</summary>
        public bool IsCoarse { get; private set; }

        /// <summary>Progress of the load that runs or ran last, 0 to 1.</summary>
        public float Progress => load?.Progress ?? 0f;

        /// <summary>Whether a load is running.</summary>
        public bool IsLoading => load != null && load.IsRunning;

        /// <summary>The imported volume that is loaded on start; it comes before files. Null = none.</summary>
        public VolumeAsset Asset { get => asset; set => asset = value; }

        /// <summary>The file with intensities that is loaded on start. A relative path counts from StreamingAssets.</summary>
        public string IntensityPath { get => intensityPath; set => intensityPath = value ?? ""; }

        /// <summary>The file with labels that is loaded on start; empty = everything is unlabelled.</summary>
        public string LabelsPath { get => labelsPath; set => labelsPath = value ?? ""; }

        /// <summary>Whether the asset or the files are loaded when the component starts.</summary>
        public bool LoadOnStart { get => loadOnStart; set => loadOnStart = value; }

        /// <summary>What is done with large volumes. Changes take effect with the next load.</summary>
        public MemorySettings Memory => memory;

        /// <summary>Loads an imported volume; no medical format has to be parsed. It is unpacked on other threads; everything else as with files.</summary>
        /// <inheritdoc cref="LoadAsync(string, string, CancellationToken, IProgress{float})"/>
        /// <param name="asset">The asset.</param>
        /// <exception cref="ArgumentNullException"><paramref name="asset"/> is null.</exception>
        public Task<SegmentedVolume> LoadAsync(VolumeAsset asset, CancellationToken cancellationToken = default, IProgress<float> progress = null)
        {
            if (asset == null)
                throw new ArgumentNullException(nameof(asset));
            return LoadAsync(() => VolumeOpening.OfAsset(asset), cancellationToken, progress);
        }

        /// <summary>
        /// Loads a volume from files. They are read on another thread; a load that is still running is cancelled. Call it on the main thread, where it also
        /// ends. If it fails or is cancelled, the volume that was there stays. What was odd in the files is logged, a warning each.
        /// </summary>
        /// <param name="intensityPath">File with intensities (NIfTI-1 or NRRD). A relative path counts from StreamingAssets, on every platform; an address that
        /// begins with https:// is fetched.</param>
        /// <param name="labelsPath">File with labels on the same grid, path likewise; null or empty = everything is unlabelled.</param>
        /// <param name="cancellationToken">Stops the load; destroying the component and quitting do so too.</param>
        /// <param name="progress">Gets 0 to 1 on the thread that reads; a <see cref="Progress{T}"/> made on the main thread brings it there.</param>
        /// <returns>The volume, which is <see cref="Volume"/> by then.</returns>
        /// <exception cref="ArgumentException">There is no path.</exception>
        /// <exception cref="VolumeFormatException">It cannot be read.</exception>
        /// <exception cref="VolumeMismatchException">Intensities and labels are on different grids.</exception>
        /// <exception cref="VolumeTooLargeException">The device cannot hold it, and <see cref="Memory"/> says to refuse it; or main memory cannot.</exception>
        /// <exception cref="AnatomyCarveException">A file could not be fetched out of the application's package or from an address.</exception>
        /// <exception cref="OperationCanceledException">The load was cancelled, or another one was started.</exception>
        public Task<SegmentedVolume> LoadAsync(
            string intensityPath, string labelsPath = null, CancellationToken cancellationToken = default, IProgress<float> progress = null)
        {
            if (string.IsNullOrEmpty(intensityPath))
                throw new ArgumentException("A volume needs a file with intensities.", nameof(intensityPath));
            return LoadAsync(() => VolumeOpening.OfFiles(intensityPath, labelsPath), cancellationToken, progress);
        }

        /// <summary>Loads a volume from files' contents, as they come from a server or a picker; everything else as with files.</summary>
        /// <inheritdoc cref="LoadAsync(string, string, CancellationToken, IProgress{float})"/>
        /// <param name="intensity">All bytes of a file with intensities (NIfTI-1, gzipped or not, or NRRD). Not to be changed before the end.</param>
        /// <param name="labels">All bytes of a file with labels on the same grid; null = everything is unlabelled.</param>
        /// <param name="name">What messages call it.</param>
        /// <exception cref="ArgumentNullException"><paramref name="intensity"/> is null.</exception>
        public Task<SegmentedVolume> LoadAsync(
            byte[] intensity, byte[] labels = null, string name = "volume", CancellationToken cancellationToken = default, IProgress<float> progress = null)
        {
            if (intensity == null)
                throw new ArgumentNullException(nameof(intensity));
            return LoadAsync(() => VolumeOpening.OfContents(intensity, labels, name), cancellationToken, progress);
        }

        /// <summary>Shows a volume that is in memory already, as it is. A load that is still running is cancelled.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="volume"/> is null; <see cref="Unload"/> shows nothing.</exception>
        public void SetVolume(SegmentedVolume volume)
        {
            if (volume == null)
                throw new ArgumentNullException(nameof(volume));
            Cancel();
            Publish(volume, false);
        }

        /// <summary>Shows nothing any more and lets go of the volume; renderers free its textures. A load that is still running is cancelled.</summary>
        public void Unload()
        {
            Cancel();
            Volume = null;
        }

        /// <summary>Cancels the load that is running, if any; a coarse volume goes with it.</summary>
        public void Cancel()
        {
            load?.Cancel();
            if (IsCoarse)
                Publish(null, false);
        }

        /// <summary>Begins what is to be loaded: once in Play, and outside Play whenever something else is to be loaded.</summary>
        void Update()
        {
            var wanted = new StartSource(asset, intensityPath, labelsPath, loadOnStart);
            if (begun.IsSet && (Application.isPlaying || wanted.Equals(begun)))
                return;
            bool first = !begun.IsSet;
            begun = wanted;
            if (wanted.HasSource && (!first || (Volume == null && !IsLoading)))
                wanted.LoadInto(this);
            else if (!first)
                Unload();
        }

        void OnDestroy() => Unload();

        void OnValidate() => memory?.Clamp();

        async Task<SegmentedVolume> LoadAsync(Func<VolumeOpening> open, CancellationToken cancellationToken, IProgress<float> progress)
        {
            Cancel();
            load = new LoadRun(cancellationToken, destroyCancellationToken, progress)
            {
                Forecast = forecast => Forecast?.Invoke(forecast),
                Coarse = Volume == null ? coarse => Publish(coarse, coarse != null) : null,
                Failed = e => Failed?.Invoke(e),
            };
            SegmentedVolume volume = await load.Run(open, this);
            foreach (string warning in volume.Warnings)
                Debug.LogWarning(warning, this);
            Publish(volume, false);
            return volume;
        }

        void Publish(SegmentedVolume volume, bool isCoarse)
        {
            (Volume, IsCoarse) = (volume, isCoarse);
            LoadEvents.Raise(isCoarse ? CoarseLoaded : Loaded, volume, () => Volume == volume);
            if (!Application.isPlaying)
                EditorLink.RequestRefresh();
        }
    }
}
