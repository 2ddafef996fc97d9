using System;
using System.Collections.Generic;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// The carving of the volume at its GameObject's place, in world space: fixed clip spheres in order, and one active sphere. Each loaded volume starts with the
    /// carving that is set in the Inspector, or with none. What it does is done by <see cref="CarvingStack"/>, which speaks patient millimetres.
    /// </summary>
    [AddComponentMenu("AnatomyCarve/Clip Sphere Stack")]
    [DisallowMultipleComponent]
    [ExecuteAlways]
    [ManualPage("components")]
    public sealed class ClipSphereStack : MonoBehaviour
    {
        [SerializeField, Tooltip("The volume to carve; empty = the one on this GameObject")]
        VolumeLoader loader;

        [SerializeField, Tooltip("A carving file (JSON) that each volume starts with; empty = nothing is carved")]
        TextAsset startFile;

        [SerializeField, HideInInspector, Tooltip("What was carved in the Editor, as a carving file's text; comes before the start file")]
        string startCarving = "";

        [SerializeField, Range(0.05f, 1f), Tooltip("Radius of the new active sphere when the active one is fixed, relative to the old one")]
        float activeRadiusFactor = CarvingStack.DefaultActiveRadiusFactor;

        [SerializeField, Min(0), Tooltip("How many edits can be undone")]
        int historyLimit = CarvingStack.DefaultHistoryLimit;

        readonly StartCarving start = new StartCarving();
        CarvingStack carving;
        CarvingDocument loaded;

        /// <summary>Raised after each change of the carving, with what changed.</summary>
        public event Action<CarvingChange> Changed;

        /// <summary>The volume that is carved: the one that was set, or else the one on this GameObject. Null if there is none.</summary>
        public VolumeLoader Loader { get => this.WiredOrSibling(loader); set => loader = value; }

        /// <summary>
        /// The carving; null while no volume is loaded, and another one for each volume; the whole one that follows a coarse one keeps its carving. In the Editor,
        /// outside Play, also another one when what volumes start with was changed.
        /// </summary>
        public CarvingStack Carving
        {
            get
            {
                SegmentedVolume volume = Loader != null ? Loader.Volume : null;
                if (!start.IsOf(volume) || (!Application.isPlaying && start.Differs(startCarving, startFile)))
                    Carve(volume);
                return carving;
            }
        }

        /// <summary>
        /// A carving file that volumes loaded from now on start with, unless the carving was edited in the Editor, which comes before it; null = none.
        /// </summary>
        public TextAsset StartFile { get => startFile; set => startFile = value; }

        /// <summary>Radius of the new active sphere when the active one is fixed, relative to the old one; 0.05 to 1.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value lies outside.</exception>
        public float ActiveRadiusFactor
        {
            get => activeRadiusFactor;
            set
            {
                activeRadiusFactor = SettingRange.Checked(value, 0.05f, 1f, nameof(ActiveRadiusFactor));
                Configure();
            }
        }

        /// <summary>Places the active sphere, and makes it if there is none.</summary>
        /// <param name="worldCentre">Centre in world space.</param>
        /// <param name="worldRadius">Radius in world units, 0 or more. In a volume that is scaled unevenly the sphere is round in the patient.</param>
        /// <exception cref="ArgumentException">Centre or radius is not finite, or the radius is negative, or the volume's scale is 0.</exception>
        /// <exception cref="InvalidOperationException">No volume is loaded.</exception>
        public void SetActive(Vector3 worldCentre, float worldRadius)
        {
            CarvingStack stack = Required();
            Matrix4x4 localToWorld = transform.localToWorldMatrix;
            PointMm centre = VolumeSpace.WorldToLps(Loader.Volume.Geometry, localToWorld).TransformPoint(new PointMm(worldCentre.x, worldCentre.y, worldCentre.z));
            stack.SetActive(centre, worldRadius / (VolumeSpace.WorldScale(localToWorld) * VolumeSpace.MetresPerMm));
        }

        /// <summary>Takes the active sphere away.</summary>
        /// <exception cref="InvalidOperationException">No volume is loaded.</exception>
        public void RemoveActive() => Required().RemoveActive();

        /// <summary>Fixes the active sphere where it is. A smaller active sphere with the same mask takes its place.</summary>
        /// <exception cref="InvalidOperationException">No volume is loaded, or there is no active sphere.</exception>
        public void FixActive() => Required().FixActive();

        /// <summary>Removes the sphere that was fixed last. The active sphere's mask stays as it is.</summary>
        /// <returns>Whether there was one.</returns>
        /// <exception cref="InvalidOperationException">No volume is loaded.</exception>
        public bool RemoveLast() => Required().RemoveLast();

        /// <summary>Turns a segment of the active sphere's mask on or off.</summary>
        /// <param name="segment">The segment's index in the volume's table.</param>
        /// <exception cref="InvalidOperationException">No volume is loaded.</exception>
        public void ToggleSegment(int segment) => Required().ToggleSegment(segment);

        /// <summary>Turns the active sphere's whole mask on; off if it is all on.</summary>
        /// <exception cref="InvalidOperationException">No volume is loaded.</exception>
        public void ResetMask() => Required().ResetMask();

        /// <summary>Removes all spheres.</summary>
        /// <exception cref="InvalidOperationException">No volume is loaded.</exception>
        public void Clear() => Required().Clear();

        /// <summary>Takes the last edit back.</summary>
        /// <returns>Whether there was one.</returns>
        /// <exception cref="InvalidOperationException">No volume is loaded.</exception>
        public bool Undo() => Required().Undo();

        /// <summary>Makes the edit again that was taken back last.</summary>
        /// <returns>Whether there was one.</returns>
        /// <exception cref="InvalidOperationException">No volume is loaded.</exception>
        public bool Redo() => Required().Redo();

        /// <summary>The carving as the text of a carving file; segments that the loaded one named and this volume lacks are kept.</summary>
        /// <exception cref="InvalidOperationException">No volume is loaded.</exception>
        public string ToJson() => CarvingFile.Format(Document());

        /// <summary>Saves the carving as a JSON file, as <see cref="ToJson"/> has it. The file is complete or, if saving fails, as it was before.</summary>
        /// <exception cref="InvalidOperationException">No volume is loaded.</exception>
        /// <exception cref="CarvingFileException">The file cannot be written.</exception>
        public void Save(string path) => CarvingFile.Write(Document(), path);

        /// <summary>Replaces the carving by one from a JSON file. It can be undone. If the file cannot be read, the carving stays as it is.</summary>
        /// <returns>What does not fit this volume, as sentences, which are logged as warnings too; empty = all of it fits.</returns>
        /// <exception cref="InvalidOperationException">No volume is loaded.</exception>
        /// <exception cref="CarvingFileException">The file cannot be read, is not a carving, or is of a version that this package does not know.</exception>
        public IReadOnlyList<string> Load(string path) => Take(CarvingFile.Read(path));

        /// <summary>Replaces the carving by one from the text of a carving file, as <see cref="Load"/> does from the file.</summary>
        /// <param name="json">The text.</param>
        /// <param name="source">What messages call it.</param>
        /// <inheritdoc cref="Load"/>
        public IReadOnlyList<string> LoadJson(string json, string source = "carving") => Take(CarvingFile.Parse(json, source));

        /// <summary>Makes volumes start with the carving as it is now. This is how edits outside Play are saved with the scene.</summary>
        /// <exception cref="InvalidOperationException">No volume is loaded.</exception>
        internal void KeepAsStart()
        {
            startCarving = ToJson();
            start.SetUsed(startCarving, startFile);
        }

        /// <summary>Lets go of a volume that was unloaded.</summary>
        void LateUpdate() => _ = Carving;

        void OnValidate()
        {
            activeRadiusFactor = Mathf.Clamp(activeRadiusFactor, 0.05f, 1f);
            historyLimit = Mathf.Max(0, historyLimit);
            Configure();
        }

        CarvingStack Required() => Carving ?? throw new InvalidOperationException($"{name}: no volume is loaded, so there is nothing to carve.");

        CarvingDocument Document() => CarvingBinding.Document(Required().State, Loader.Volume.Segments, loaded);

        IReadOnlyList<string> Take(CarvingDocument document)
        {
            CarvingStack stack = Required();
            CarvingBinding binding = CarvingBinding.Bind(document, Loader.Volume.Segments);
            loaded = document; // before the change is raised: a listener may save
            stack.Replace(binding.Fixed, binding.Active);
            foreach (string warning in binding.Warnings)
                Debug.LogWarning(warning, this);
            return binding.Warnings;
        }

        void Carve(SegmentedVolume volume)
        {
            if (carving != null)
                carving.Changed -= Raise;
            carving = start.Of(volume, startCarving, startFile, this, out loaded);
            if (carving != null)
                carving.Changed += Raise;
            Configure();
        }

        void Configure()
        {
            if (carving == null)
                return;
            carving.ActiveRadiusFactor = activeRadiusFactor;
            carving.HistoryLimit = historyLimit;
        }

        void Raise(CarvingChange change) => Changed?.Invoke(change);
    }
}
