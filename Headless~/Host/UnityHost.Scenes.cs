using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEditor;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace AnatomyCarve.Headless
{
    public sealed partial class UnityHost
    {
        /// <summary>
        /// Loads a scene in place of the present one. Awake and OnEnable of everything in it have run on return; Start comes with the next
        /// <see cref="Step"/>. A scene that cannot be loaded leaves what there is as it is.
        /// </summary>
        /// <param name="path">
        /// A .unity file: by its absolute path, by its path below <see cref="PackageRoot"/>, or by its path in the project (Packages/..., Assets/...). A
        /// scene of a sample brings the sample's folder along.
        /// </param>
        /// <exception cref="FileNotFoundException">There is no such file.</exception>
        /// <exception cref="Exception">Something in the file is unknown, contradicts itself or leads nowhere; the message names file and line.</exception>
        public void LoadScene(string path)
        {
            ObjectDisposedException.ThrowIf(m_Disposed, this);
            SceneLoading.Load(ProjectPath(path), LoadSceneMode.Single);
            if (Application.InEditMode)
                EditorApplication.RaiseHierarchyChanged();
        }

        /// <summary>Destroys all that lives in scenes; what DontDestroyOnLoad keeps stays. An empty scene is left.</summary>
        public void UnloadScene()
        {
            ObjectDisposedException.ThrowIf(m_Disposed, this);
            foreach (var scene in new List<SceneData>(LoadedScenes.All))
                SceneLoading.Unload(scene);
        }

        /// <summary>Puts a copy of a prefab into the present scene; Awake and OnEnable have run on return.</summary>
        /// <param name="path">A .prefab file, given as for <see cref="LoadScene"/>.</param>
        /// <returns>The copy's root.</returns>
        /// <exception cref="FileNotFoundException">There is no such file.</exception>
        /// <exception cref="Exception">Something in the file is unknown, contradicts itself or leads nowhere; the message names file and line.</exception>
        public GameObject InstantiatePrefab(string path)
        {
            ObjectDisposedException.ThrowIf(m_Disposed, this);
            var copy = UnityEngine.Object.Instantiate((GameObject)LoadAsset(path));
            copy.name = copy.name[..^"(Clone)".Length];
            return copy;
        }

        /// <summary>The main object of an asset's file, imported at its first use.</summary>
        /// <param name="path">The file, given as for <see cref="LoadScene"/>.</param>
        /// <returns>Null if nothing imports such files.</returns>
        /// <exception cref="FileNotFoundException">There is no such file.</exception>
        public UnityEngine.Object LoadAsset(string path)
        {
            ObjectDisposedException.ThrowIf(m_Disposed, this);
            return AssetLibrary.LoadFile(AssetFiles.FullPath(ProjectPath(path))).Main;
        }

        /// <summary>
        /// Takes in folders as Unity takes in a project: their files, the assemblies of their definitions as far as this program has them, and
        /// what postprocessors make of new files.
        /// </summary>
        static void AddRoots(IEnumerable<string> roots)
        {
            var before = AssetFiles.All.ToHashSet();
            foreach (var root in roots)
                AssetFiles.AddRoot(root);
            var added = AssetFiles.All.Where(f => !before.Contains(f)).ToList();
            ScriptAssemblies.Load(added);
            Postprocessors.Send(added.Select(AssetFiles.ProjectPath), []);
        }

        /// <summary>A file's path in the project. What lies in a sample is taken in first.</summary>
        string ProjectPath(string path)
        {
            ArgumentException.ThrowIfNullOrEmpty(path);
            var full = AssetFiles.FullPath(path) ?? Path.GetFullPath(path, PackageRoot);
            if (!File.Exists(full))
                throw new FileNotFoundException($"There is no file {full}", full);
            var samples = Path.Combine(PackageRoot, "Samples~") + Path.DirectorySeparatorChar;
            if (full.StartsWith(samples, StringComparison.Ordinal) && full.IndexOf(Path.DirectorySeparatorChar, samples.Length) is var end and > 0)
                AddRoots([full[..end]]);
            return AssetFiles.ProjectPath(full);
        }
    }
}
