using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.SceneManagement
{
    /// <summary>A scene in memory: its root transforms, in order.</summary>
    sealed class SceneData
    {
        static int s_NextHandle;

        internal SceneData(string name, string path)
        {
            Handle = s_NextHandle -= 2;
            Name = name;
            Path = path;
        }

        internal int Handle { get; }

        internal string Name { get; set; }

        /// <summary>Its path in the project; empty for a scene made at run time.</summary>
        internal string Path { get; }

        internal bool IsLoaded { get; set; } = true;

        internal List<Transform> Roots { get; } = new();

        internal List<GameObject> RootObjects => Roots.Select(r => r.Owner).ToList();
    }
}
