using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>
    /// Hangs what a file adds to its prefab instances (components on their GameObjects, children below their transforms) into the lists of the
    /// instances' documents, which stand in the prefab and know nothing of them.
    /// </summary>
    static class PrefabAdditions
    {
        /// <param name="graph">All objects of the file.</param>
        /// <param name="own">Those that stand in the file itself.</param>
        /// <param name="instances">The file's prefab instances.</param>
        /// <param name="standIns">Its stripped documents.</param>
        /// <exception cref="AssetFormatException">An instance lists other additions than there are.</exception>
        internal static void Hang(ObjectGraph graph, List<GraphItem> own, List<YamlDocument> instances, List<StandIn> standIns)
        {
            var foreign = graph.Items.Except(own).ToDictionary(i => i.Id);
            foreach (var instance in instances)
            {
                // What hangs on an object of the instance names its parent by the number of a stripped document.
                GraphItem Parent(long id) => foreign.TryGetValue(id, out var parent)
                    && standIns.Exists(s => s.InstanceId == instance.FileId && s.Document.FileId == id) ? parent : null;
                var children = Added(own.Where(i => i.Class.IsTransform), i => Parent(ObjectGraph.Father(i)));
                var components = Added(own.Where(i => i.Class.IsComponent && !i.Class.IsTransform), i => Parent(ObjectGraph.Owner(i)));
                var modification = instance.Mapping(instance.Needed(instance.Body, "m_Modification"));
                Listed(graph, instance, modification, "m_AddedGameObjects", children);
                Listed(graph, instance, modification, "m_AddedComponents", components);
            }

            // A prefab instance that hangs below an object of another instance is not the file's own, but its place is.
            foreach (var rootId in graph.InstanceRoots.Values)
                if (foreign.TryGetValue(ObjectGraph.Father(graph.Find(rootId)), out var parent) && !Lists(parent, "m_Children", rootId))
                    Append(parent, "m_Children", Reference(rootId));
        }

        static List<(GraphItem Item, GraphItem Parent)> Added(IEnumerable<GraphItem> own, Func<GraphItem, GraphItem> parentOf) =>
            own.Select(i => (Item: i, Parent: parentOf(i))).Where(a => a.Parent != null).ToList();

        static void Listed(ObjectGraph graph, YamlDocument instance, YamlMappingNode modification, string key, List<(GraphItem Item, GraphItem Parent)> added)
        {
            var kind = key == "m_AddedComponents" ? "m_Component" : "m_Children";
            var node = YamlNodes.Child(modification, key);
            var order = added.Select(a => a.Item.Id).ToList();
            if (node != null)
            {
                order = instance.List(node).Select(n => instance.LocalId(instance.Needed(instance.Mapping(n), "addedObject"))).ToList();
                // Instances below instances are listed too, and hung by their own m_TransformParent.
                order.RemoveAll(id => graph.InstanceRoots.ContainsValue(id));
                if (!order.OrderBy(i => i).SequenceEqual(added.Select(a => a.Item.Id).OrderBy(i => i)))
                    throw instance.Error(node, $"{key} lists {Text(order)}, but {Text(added.Select(a => a.Item.Id))} hang there");
            }

            foreach (var id in order)
            {
                var (item, parent) = added.Find(a => a.Item.Id == id);
                var reference = Reference(item.Id);
                Append(parent, kind, kind == "m_Component" ? new YamlMappingNode(new YamlScalarNode("component"), reference) : reference);
            }
        }

        static bool Lists(GraphItem parent, string key, long id) => YamlNodes.Child(parent.Document.Body, key) is { } list
            && parent.Document.List(list).Any(c => parent.Document.LocalId(c) == id);

        static void Append(GraphItem parent, string key, YamlNode entry)
        {
            if (YamlNodes.Child(parent.Document.Body, key) is not YamlSequenceNode list)
                parent.Document.Body.Children[new YamlScalarNode(key)] = list = new YamlSequenceNode();
            list.Add(entry);
        }

        static YamlMappingNode Reference(long id) =>
            new(new YamlScalarNode("fileID"), new YamlScalarNode(id.ToString(CultureInfo.InvariantCulture)));

        static string Text(IEnumerable<long> ids) => ids.Any() ? string.Join(", ", ids) : "nothing";
    }
}
