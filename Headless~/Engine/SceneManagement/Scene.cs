using System;
using System.Collections.Generic;

namespace UnityEngine.SceneManagement
{
    /// <summary>A handle of a scene in memory.</summary>
    [Serializable]
    public struct Scene
    {
        readonly int m_Handle;

        internal Scene(SceneData data) => m_Handle = data?.Handle ?? 0;

        public int handle => m_Handle;

        /// <summary>The file's name without extension.</summary>
        /// <exception cref="InvalidOperationException">Set for a scene that came from a file, or that is gone.</exception>
        public string name
        {
            get => Data?.Name ?? "";
            set
            {
                var data = Data ?? throw new InvalidOperationException("The scene is invalid.");
                if (data.Path.Length > 0)
                    throw new InvalidOperationException($"Setting a name on a saved scene is not allowed (the filename is used as name). Scene: '{data.Path}'");
                data.Name = value;
            }
        }

        /// <summary>The file's path in the project.</summary>
        public string path => Data?.Path ?? "";

        public bool isLoaded => Data is { IsLoaded: true };

        /// <summary>Headless, the place in the host's list of scenes; -1 for another.</summary>
        public int buildIndex => Data is { } data ? BuildScenes.IndexOf(data.Path) : -1;

        public int rootCount => Data?.Roots.Count ?? 0;

        internal SceneData Data => LoadedScenes.Find(m_Handle);

        public bool IsValid() => Data != null;

        /// <exception cref="ArgumentException">The scene is gone.</exception>
        public GameObject[] GetRootGameObjects() => Roots().ToArray();

        public void GetRootGameObjects(List<GameObject> rootGameObjects)
        {
            rootGameObjects.Clear();
            rootGameObjects.AddRange(Roots());
        }

        public override bool Equals(object other) => other is Scene scene && scene.m_Handle == m_Handle;

        public override int GetHashCode() => m_Handle;

        public static bool operator ==(Scene lhs, Scene rhs) => lhs.m_Handle == rhs.m_Handle;

        public static bool operator !=(Scene lhs, Scene rhs) => lhs.m_Handle != rhs.m_Handle;

        List<GameObject> Roots() => (Data ?? throw new ArgumentException("The scene is invalid.")).RootObjects;
    }
}
