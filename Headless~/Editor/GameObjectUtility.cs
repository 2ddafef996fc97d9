using System.Globalization;
using System.Linq;
using UnityEngine;

namespace UnityEditor
{
    /// <summary>What menu entries do with new objects.</summary>
    public sealed class GameObjectUtility
    {
        public GameObjectUtility()
        {
        }

        /// <summary>Hangs an object below another, in its place and on its layer; without a parent nothing happens.</summary>
        public static void SetParentAndAlign(GameObject child, GameObject parent)
        {
            if (parent == null)
                return;
            child.transform.SetParent(parent.transform, false);
            foreach (var part in child.transform.Subtree(true))
                part.layer = parent.layer;
        }

        /// <summary>A name that no child of the parent has, with a number if need be.</summary>
        /// <param name="parent">Null for the roots of the scene.</param>
        /// <param name="name">The wanted name.</param>
        public static string GetUniqueNameForSibling(Transform parent, string name)
        {
            var taken = (parent == null ? UnityEngine.SceneManagement.LoadedScenes.Active.Roots : parent.Children).Select(t => t.name).ToHashSet();
            if (!taken.Contains(name))
                return name;
            var number = 1;
            while (taken.Contains(Numbered(name, number)))
                number++;
            return Numbered(name, number);
        }

        public static void EnsureUniqueNameForSibling(GameObject self)
        {
            var name = self.name;
            self.name = "";
            self.name = GetUniqueNameForSibling(self.transform.parent, name);
        }

        static string Numbered(string name, int number) => string.Format(CultureInfo.InvariantCulture, "{0} ({1})", name, number);
    }
}
