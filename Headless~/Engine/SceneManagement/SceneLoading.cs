using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace UnityEngine.SceneManagement
{
    /// <summary>Loads and unloads scenes: for scripts at the start of the next frame, for the host at once.</summary>
    static class SceneLoading
    {
        static readonly List<(AsyncOperation Operation, Action Work)> s_Pending = new();

        /// <summary>Loads a scene; Awake and OnEnable of everything in it have run on return, Start comes with the next frame.</summary>
        /// <param name="path">Its path in the project.</param>
        /// <param name="mode">Whether the other scenes go.</param>
        /// <exception cref="AssetFormatException">Something in the file is unknown, contradicts itself or leads nowhere; then nothing has changed.</exception>
        internal static SceneData Load(string path, LoadSceneMode mode)
        {
            // A scene that cannot be loaded leaves the others as they are.
            var roots = SceneFile.Load(AssetFiles.FullPath(path) ?? throw new AssetFormatException(path, "is no file of the project"), out var applySettings);
            var scene = new SceneData(Path.GetFileNameWithoutExtension(path), path);
            var before = LoadedScenes.Active;
            LoadedScenes.Add(scene);
            if (mode == LoadSceneMode.Single)
                foreach (var old in LoadedScenes.All.Where(s => s != scene).ToList())
                    Unload(old);
            if (mode == LoadSceneMode.Single)
                applySettings();
            foreach (var root in roots)
                root.OwnTransform.MoveTo(scene);
            Validation.SendToAll(roots);
            Activation.Begin(roots);
            if (mode == LoadSceneMode.Single)
                SceneManager.RaiseActiveChanged(before, scene);
            SceneManager.RaiseLoaded(scene, mode);
            return scene;
        }

        /// <summary>Destroys all that lives in a scene.</summary>
        internal static void Unload(SceneData scene)
        {
            foreach (var root in scene.RootObjects)
                if (Object.IsAlive(root))
                    Destruction.Now(root);
            LoadedScenes.Remove(scene);
            SceneManager.RaiseUnloaded(scene);
        }

        /// <summary>Puts work off to the start of the next frame.</summary>
        internal static AsyncOperation Later(Action work)
        {
            var operation = new AsyncOperation();
            s_Pending.Add((operation, work));
            return operation;
        }

        /// <summary>Called at the start of a frame.</summary>
        internal static void RunPending()
        {
            var due = s_Pending.FindAll(p => p.Operation.allowSceneActivation);
            s_Pending.RemoveAll(due.Contains);
            foreach (var (operation, work) in due)
            {
                LogRouter.Guard(work);
                operation.Finish();
            }
        }

        internal static void Forget()
        {
            s_Pending.Clear();
            SceneManager.ForgetSubscribers();
        }
    }
}
