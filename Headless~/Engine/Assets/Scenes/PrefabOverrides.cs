using System.Collections.Generic;
using System.Linq;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>Writes what a prefab instance changes into the documents of its objects: values, removed components, removed GameObjects.</summary>
    sealed class PrefabOverrides
    {
        readonly ObjectGraph m_Graph;
        readonly YamlDocument m_Instance;
        readonly string m_Guid;
        readonly IReadOnlyDictionary<long, long> m_Numbers;

        /// <param name="graph">The file's objects, the instance's among them.</param>
        /// <param name="instance">The prefab instance's document.</param>
        /// <param name="guid">Its prefab.</param>
        /// <param name="numbers">From the prefab's numbers to the file's.</param>
        internal PrefabOverrides(ObjectGraph graph, YamlDocument instance, string guid, IReadOnlyDictionary<long, long> numbers)
        {
            m_Graph = graph;
            m_Instance = instance;
            m_Guid = guid;
            m_Numbers = numbers;
        }

        internal void Apply(YamlMappingNode modification)
        {
            foreach (var item in m_Instance.List(YamlNodes.Child(modification, "m_Modifications")))
                Set(m_Instance.Mapping(item));
            foreach (var removed in m_Instance.List(YamlNodes.Child(modification, "m_RemovedComponents")))
                Remove(Source(removed), removed);
            foreach (var removed in m_Instance.List(YamlNodes.Child(modification, "m_RemovedGameObjects")))
                Remove(Source(removed), removed);
        }

        void Set(YamlMappingNode item)
        {
            var target = Source(m_Instance.Needed(item, "target"));
            var path = m_Instance.Scalar(m_Instance.Needed(item, "propertyPath"));
            var reference = m_Instance.Mapping(m_Instance.Needed(item, "objectReference"));
            var value = m_Instance.Needed(item, "value");
            YamlPropertyPath.Set(target.Document, path, m_Instance, value, reference);
        }

        /// <summary>The object of the instance that an override means by the prefab's numbers.</summary>
        GraphItem Source(YamlNode node)
        {
            var reference = m_Instance.Mapping(node);
            if (m_Instance.Scalar(m_Instance.Needed(reference, "guid")) is var guid && guid != m_Guid)
                throw m_Instance.Error(node, $"changes an object of {guid}, but this is an instance of {m_Guid}");
            var id = m_Instance.Long(m_Instance.Needed(reference, "fileID"));
            if (!m_Numbers.TryGetValue(id, out var number) || m_Graph.Find(number) is not { } item)
                throw m_Instance.Error(node, $"changes object {id}, which the prefab does not have");
            return item;
        }

        void Remove(GraphItem item, YamlNode why)
        {
            if (item.Class.IsTransform)
                throw m_Instance.Error(why, "removes a Transform; only whole GameObjects can go");
            if (item.Class.Id == NativeClass.GameObject)
            {
                var transform = m_Graph.Items.Find(i => i.Class.IsTransform && ObjectGraph.Owner(i) == item.Id);
                RemoveTree(transform);
            }
            else
            {
                Forget(item);
            }
        }

        void RemoveTree(GraphItem transform)
        {
            foreach (var child in m_Graph.Items.FindAll(i => i.Class.IsTransform && ObjectGraph.Father(i) == transform.Id))
                RemoveTree(child);
            var owner = ObjectGraph.Owner(transform);
            foreach (var component in m_Graph.Items.FindAll(i => i.Class.IsComponent && ObjectGraph.Owner(i) == owner))
                Forget(component);
            Forget(m_Graph.Find(owner));
        }

        /// <summary>Takes the object out; lists lose it, other references to it become none.</summary>
        void Forget(GraphItem gone)
        {
            m_Graph.Items.Remove(gone);
            foreach (var number in m_Numbers.Values)
            {
                if (m_Graph.Find(number) is not { } item)
                    continue;
                foreach (var key in new[] { "m_Component", "m_Children" })
                    if (YamlNodes.Child(item.Document.Body, key) is YamlSequenceNode list)
                        foreach (var entry in list.Children.Where(e => YamlNodes.References(e).Any(r => IsTo(item, r, gone))).ToList())
                            list.Children.Remove(entry);
                foreach (var reference in YamlNodes.References(item.Document.Body).Where(r => IsTo(item, r, gone)))
                    ((YamlScalarNode)YamlNodes.Child(reference, "fileID")).Value = "0";
            }
        }

        static bool IsTo(GraphItem item, YamlMappingNode reference, GraphItem target) =>
            YamlNodes.Child(reference, "guid") == null && item.Document.Long(YamlNodes.Child(reference, "fileID")) == target.Id;
    }
}
