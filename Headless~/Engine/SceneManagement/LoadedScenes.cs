using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.SceneManagement
{
    /// <summary>The scenes in memory. There is always one that is active: new GameObjects go there.</summary>
    static class LoadedScenes
    {
        const string DontDestroyName = "DontDestroyOnLoad";

        static readonly List<SceneData> s_All = new() { new SceneData("", "") };

        static SceneData s_Active = s_All[0];
        static SceneData s_DontDestroy = new(DontDestroyName, DontDestroyName);

        internal static IReadOnlyList<SceneData> All => s_All;

        internal static SceneData Active { get => s_Active; set => s_Active = value; }

        /// <summary>Where objects live that scene changes leave alone; it is not among <see cref="All"/>.</summary>
        internal static SceneData DontDestroy => s_DontDestroy;

        /// <summary>The roots of all scenes, in order.</summary>
        internal static List<Transform> Roots => s_All.Append(s_DontDestroy).SelectMany(s => s.Roots).ToList();

        internal static SceneData Find(int handle) => handle == s_DontDestroy.Handle ? s_DontDestroy : s_All.Find(s => s.Handle == handle);

        internal static void Add(SceneData scene) => s_All.Add(scene);

        internal static void Remove(SceneData scene)
        {
            scene.IsLoaded = false;
            s_All.Remove(scene);
            if (s_All.Count == 0)
                s_All.Add(new SceneData("", ""));
            if (ReferenceEquals(s_Active, scene))
                s_Active = s_All[0];
        }

        /// <summary>An empty scene, as at start.</summary>
        internal static void Forget()
        {
            s_All.Clear();
            s_All.Add(s_Active = new SceneData("", ""));
            s_DontDestroy = new SceneData(DontDestroyName, DontDestroyName);
        }
    }
}
