using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>Puts the transforms of a file below each other and finds its roots. Parents and children, scene and roots must agree.</summary>
    sealed class HierarchyBuilder
    {
        readonly ObjectGraph m_Graph;
        readonly IReadOnlyDictionary<long, Object> m_Objects;

        internal HierarchyBuilder(ObjectGraph graph, IReadOnlyDictionary<long, Object> objects)
        {
            m_Graph = graph;
            m_Objects = objects;
        }

        /// <returns>The root objects, in order.</returns>
        /// <exception cref="AssetFormatException">Two places of the file contradict each other.</exception>
        internal List<GameObject> Build()
        {
            var transforms = m_Graph.Items.FindAll(i => i.Class.IsTransform);
            foreach (var parent in transforms)
                foreach (var node in parent.Document.List(YamlNodes.Child(parent.Document.Body, "m_Children")))
                {
                    var id = parent.Document.LocalId(node);
                    var child = transforms.Find(t => t.Id == id) ?? throw parent.Document.Error(node, $"lists child {id}, which is no Transform of the file");
                    if (ObjectGraph.Father(child) != parent.Id)
                        throw child.Document.Error(child.Document.Body, $"its m_Father is {ObjectGraph.Father(child)}, but {parent.Id} lists it as a child");
                    if (Transform(child).ParentOrNull is not null)
                        throw parent.Document.Error(node, $"lists child {id} twice");
                    Transform(child).HangBelow(Transform(parent));
                }

            foreach (var child in transforms)
                if (ObjectGraph.Father(child) != 0 && Transform(child).ParentOrNull is null)
                    throw child.Document.Error(child.Document.Body, $"its m_Father {ObjectGraph.Father(child)} does not list it as a child");
            var roots = m_Graph.SceneRoots == null ? m_Graph.Roots : Ordered();
            if (roots.Sum(r => Transform(r).Subtree(true).Count()) != transforms.Count)
                throw new AssetFormatException(m_Graph.Path, "some Transforms are their own ancestors");
            foreach (var item in m_Graph.Items.Where(i => i.Class.Id == NativeClass.GameObject))
                ((GameObject)m_Objects[item.Id]).SetSelfFlag(new NativeFields(item.Document, new YamlReferences(m_Objects)).Get("m_IsActive", true));
            return roots.ConvertAll(r => Transform(r).Owner);
        }

        /// <summary>The roots in the order that the scene gives.</summary>
        List<GraphItem> Ordered()
        {
            var document = m_Graph.SceneRoots;
            var roots = m_Graph.Roots;
            var ordered = new List<GraphItem>();
            foreach (var node in document.List(document.Needed(document.Body, "m_Roots")))
            {
                var id = document.LocalId(node);
                var rootId = m_Graph.InstanceRoots.TryGetValue(id, out var ofInstance) ? ofInstance : id;
                var root = roots.Find(r => r.Id == rootId) ?? throw document.Error(node, $"lists {id} as a root, which is no Transform without a parent");
                if (ordered.Contains(root))
                    throw document.Error(node, $"lists {id} twice");
                ordered.Add(root);
            }

            if (roots.Except(ordered).FirstOrDefault() is { } lost)
                throw document.Error(document.Body, $"SceneRoots does not list Transform {lost.Id}, which has no parent");
            return ordered;
        }

        Transform Transform(GraphItem item) => (Transform)m_Objects[item.Id];
    }
}
