using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>The scene: transforms without a parent, in order.</summary>
    static class SceneRoots
    {
        internal static List<Transform> Transforms { get; } = new();

        internal static void Add(Transform t) => Transforms.Add(t);

        internal static void Remove(Transform t) => Transforms.RemoveAll(r => ReferenceEquals(r, t));
    }
}
