using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>One object that a file will make: its document and its number in that file.</summary>
    sealed class GraphItem
    {
        internal GraphItem(YamlDocument document, long id)
        {
            Document = document;
            Id = id;
            Class = NativeClass.Of(document);
        }

        internal YamlDocument Document { get; }

        /// <summary>The number by which the file at hand knows it, which for an object of a prefab instance is another than in the prefab.</summary>
        internal long Id { get; set; }

        internal NativeClass Class { get; }
    }

    /// <summary>What a scene or prefab file consists of, after its prefab instances have been spelt out.</summary>
    sealed class ObjectGraph
    {
        internal ObjectGraph(string path) => Path = path;

        internal string Path { get; }

        internal List<GraphItem> Items { get; } = new();

        /// <summary>The order of a scene's roots: transforms, or prefab instances. Null in prefabs and in old scenes.</summary>
        internal YamlDocument SceneRoots { get; set; }

        /// <summary>By a prefab instance's number, that of its root transform.</summary>
        internal Dictionary<long, long> InstanceRoots { get; } = new();

        internal GraphItem Find(long id) => Items.Find(i => i.Id == id);

        /// <summary>Transforms without a parent.</summary>
        internal List<GraphItem> Roots => Items.Where(i => i.Class.IsTransform && Father(i) == 0).ToList();

        /// <summary>The number of a transform's parent; 0 if it has none.</summary>
        internal static long Father(GraphItem transform) => Reference(transform, "m_Father");

        /// <summary>The number of a component's GameObject; 0 for a script without one.</summary>
        internal static long Owner(GraphItem component) => Reference(component, "m_GameObject");

        static long Reference(GraphItem item, string key) =>
            YamlNodes.Child(item.Document.Body, key) is { } node ? item.Document.LocalId(node) : 0;
    }
}
