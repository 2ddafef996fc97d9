using System;
using UnityEngine.Events;

namespace UnityEngine.SceneManagement
{
    /// <summary>Whether loading a scene ends the others.</summary>
    public enum LoadSceneMode
    {
        Single = 0,
        Additive = 1,
    }

    /// <summary>The scenes of the running player. Loading takes effect with the next frame.</summary>
    public class SceneManager
    {
        public SceneManager()
        {
        }

        /// <summary>Raised after Awake and OnEnable of a loaded scene, before its Start.</summary>
        public static event UnityAction<Scene, LoadSceneMode> sceneLoaded;

        public static event UnityAction<Scene> sceneUnloaded;

        public static event UnityAction<Scene, Scene> activeSceneChanged;

        public static int sceneCount => LoadedScenes.All.Count;

        public static int loadedSceneCount => LoadedScenes.All.Count;

        public static int sceneCountInBuildSettings => BuildScenes.Count;

        public static Scene GetActiveScene() => new(LoadedScenes.Active);

        /// <exception cref="ArgumentException">The scene is not loaded.</exception>
        public static bool SetActiveScene(Scene scene)
        {
            MainThread.Check("SetActiveScene");
            var data = scene.Data ?? throw new ArgumentException("SceneManager.SetActiveScene failed; invalid scene");
            var before = LoadedScenes.Active;
            if (ReferenceEquals(before, data))
                return false;
            LoadedScenes.Active = data;
            RaiseActiveChanged(before, data);
            return true;
        }

        /// <exception cref="IndexOutOfRangeException">There are not so many.</exception>
        public static Scene GetSceneAt(int index)
        {
            if (index < 0 || index >= sceneCount)
                throw new IndexOutOfRangeException($"Scene index \"{index}\" is out of range.");
            return new Scene(LoadedScenes.All[index]);
        }

        public static Scene GetSceneByName(string name) => Loaded(s => s.Name == name);

        public static Scene GetSceneByPath(string scenePath) => Loaded(s => s.Path == scenePath);

        /// <summary>An empty scene beside the others.</summary>
        public static Scene CreateScene(string sceneName)
        {
            MainThread.Check("CreateScene");
            if (string.IsNullOrEmpty(sceneName))
                throw new ArgumentException("SceneManager.CreateScene failed; the scene name must not be empty.");
            var scene = new SceneData(sceneName, "");
            LoadedScenes.Add(scene);
            return new Scene(scene);
        }

        public static void LoadScene(string sceneName) => LoadScene(sceneName, LoadSceneMode.Single);

        /// <summary>Loads a scene of the build at the start of the next frame.</summary>
        public static void LoadScene(string sceneName, LoadSceneMode mode) => LoadSceneAsync(sceneName, mode);

        public static void LoadScene(int sceneBuildIndex) => LoadScene(sceneBuildIndex, LoadSceneMode.Single);

        public static void LoadScene(int sceneBuildIndex, LoadSceneMode mode) => LoadSceneAsync(sceneBuildIndex, mode);

        public static AsyncOperation LoadSceneAsync(string sceneName) => LoadSceneAsync(sceneName, LoadSceneMode.Single);

        /// <returns>Null, with an error in the log, if the build has no such scene.</returns>
        public static AsyncOperation LoadSceneAsync(string sceneName, LoadSceneMode mode) =>
            Begin(string.IsNullOrEmpty(sceneName) ? null : BuildScenes.Find(sceneName), $"'{sceneName}'", mode);

        public static AsyncOperation LoadSceneAsync(int sceneBuildIndex) => LoadSceneAsync(sceneBuildIndex, LoadSceneMode.Single);

        public static AsyncOperation LoadSceneAsync(int sceneBuildIndex, LoadSceneMode mode) =>
            Begin(BuildScenes.At(sceneBuildIndex), $"with build index: {sceneBuildIndex}", mode);

        /// <exception cref="ArgumentException">The scene is not loaded.</exception>
        public static AsyncOperation UnloadSceneAsync(Scene scene)
        {
            MainThread.Check("UnloadSceneAsync");
            var data = scene.Data ?? throw new ArgumentException("Scene to unload is invalid");
            if (LoadedScenes.All.Count > 1)
                return SceneLoading.Later(() => SceneLoading.Unload(data));
            Debug.LogWarning($"Unloading the last loaded scene {data.Path}, is not supported. Please use SceneManager.LoadScene()/EditorSceneManager."
                + "OpenScene() to switch to another scene.");
            return null;
        }

        public static AsyncOperation UnloadSceneAsync(string sceneName) => UnloadSceneAsync(GetSceneByName(sceneName));

        /// <exception cref="ArgumentException">The object is no root, or the scene is not loaded.</exception>
        public static void MoveGameObjectToScene(GameObject go, Scene scene)
        {
            MainThread.Check("MoveGameObjectToScene");
            if (go.transform.parent != null)
                throw new ArgumentException("Gameobject is not a root in a scene");
            go.OwnTransform.MoveTo(scene.Data ?? throw new ArgumentException("Destination scene is not valid"));
        }

        internal static void RaiseLoaded(SceneData scene, LoadSceneMode mode) => LogRouter.Guard(() => sceneLoaded?.Invoke(new Scene(scene), mode));

        internal static void RaiseUnloaded(SceneData scene) => LogRouter.Guard(() => sceneUnloaded?.Invoke(new Scene(scene)));

        internal static void RaiseActiveChanged(SceneData before, SceneData now) =>
            LogRouter.Guard(() => activeSceneChanged?.Invoke(new Scene(before), new Scene(now)));

        internal static void ForgetSubscribers()
        {
            sceneLoaded = null;
            sceneUnloaded = null;
            activeSceneChanged = null;
        }

        static AsyncOperation Begin(string path, string wanted, LoadSceneMode mode)
        {
            MainThread.Check("LoadScene");
            if (path != null)
                return SceneLoading.Later(() => SceneLoading.Load(path, mode));
            Debug.LogError($"Scene {wanted} couldn't be loaded because it has not been added to the active build profile or shared scene list or the "
                + "AssetBundle has not been loaded.");
            return null;
        }

        static Scene Loaded(Predicate<SceneData> which)
        {
            foreach (var scene in LoadedScenes.All)
                if (which(scene))
                    return new Scene(scene);
            return default;
        }
    }
}
