using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>
    /// Spells prefab instances out: an instance becomes the documents of its prefab, with the instance's overrides written into them and all
    /// numbers turned into those of the file that holds it.
    /// </summary>
    static class PrefabExpansion
    {
        /// <summary>The fileID by which an instance refers to its prefab as a whole.</summary>
        const long PrefabFileId = 100100000;

        /// <summary>Unity numbers an object of an instance by both numbers, without the sign.</summary>
        const long Positive = 0x7fffffffffffffff;

        /// <exception cref="AssetFormatException">Something in the file, or in a prefab that it uses, is unknown or leads nowhere.</exception>
        internal static ObjectGraph Read(string path) => Read(path, new List<string>());

        static ObjectGraph Read(string path, List<string> users)
        {
            var graph = new ObjectGraph(path);
            var documents = YamlFile.Read(path);
            foreach (var document in documents.Where(d => !d.IsStripped && d.ClassId != NativeClass.PrefabInstance))
            {
                if (document.ClassId == NativeClass.SceneRoots)
                    graph.SceneRoots = document;
                graph.Items.Add(new GraphItem(document, document.FileId));
            }

            var own = graph.Items.ToList();
            var standIns = documents.Where(d => d.IsStripped).Select(d => new StandIn(d)).ToList();
            foreach (var document in documents.Where(d => d.ClassId == NativeClass.PrefabInstance))
                Expand(graph, document, standIns, users.Append(path).ToList());
            foreach (var lost in standIns.Where(s => !s.IsUsed))
                throw lost.Document.Error(lost.Document.Body,
                    $"stands for object {lost.SourceId} of the prefab instance {lost.InstanceId}, which has no such object");
            PrefabAdditions.Hang(graph, own, documents.FindAll(d => d.ClassId == NativeClass.PrefabInstance), standIns);
            return graph;
        }

        static void Expand(ObjectGraph graph, YamlDocument instance, List<StandIn> standIns, List<string> users)
        {
            NativeClass.Of(instance).CheckFields(instance);
            var source = Source(instance, users, out var guid);
            var prefab = Read(source, users);
            if (prefab.Roots.Count != 1)
                throw instance.Error(instance.Body, $"the prefab {source} has {prefab.Roots.Count} roots instead of one");
            var root = prefab.Roots[0];
            var modification = instance.Mapping(instance.Needed(instance.Body, "m_Modification"));
            var numbers = prefab.Items.ToDictionary(i => i.Id, i => Number(instance, i, guid, standIns));
            foreach (var item in prefab.Items)
            {
                Renumber(item, numbers);
                if (graph.Find(item.Id) != null)
                    throw instance.Error(instance.Body, $"two objects have the number {item.Id}");
                graph.Items.Add(item);
            }

            // The overrides speak of the prefab's objects by its numbers, and of others by the file's.
            new PrefabOverrides(graph, instance, guid, numbers).Apply(modification);
            root.Document.Body.Children["m_Father"] = instance.Needed(modification, "m_TransformParent");
            root.Document.Adopt(root.Document.Body.Children["m_Father"], instance);
            graph.InstanceRoots.Add(instance.FileId, root.Id);
        }

        static string Source(YamlDocument instance, List<string> users, out string guid)
        {
            var node = instance.Mapping(instance.Needed(instance.Body, "m_SourcePrefab"));
            guid = instance.Scalar(instance.Needed(node, "guid"));
            if (instance.Long(instance.Needed(node, "fileID")) != PrefabFileId)
                throw instance.Error(node, $"a prefab as a whole has the fileID {PrefabFileId}");
            var path = AssetLibrary.PathOf(guid)
                ?? throw instance.Error(node, $"is an instance of the prefab with GUID {guid}, which no .meta of the package has");
            if (users.Contains(path))
                throw instance.Error(node, $"the prefab {path} contains itself");
            return path;
        }

        /// <summary>The number that the holding file gives an object of the instance.</summary>
        static long Number(YamlDocument instance, GraphItem item, string guid, List<StandIn> standIns)
        {
            var standIn = standIns.Find(s => s.InstanceId == instance.FileId && s.SourceId == item.Id);
            if (standIn == null)
                return (instance.FileId ^ item.Id) & Positive;
            var document = standIn.Document;
            if (document.ClassId != item.Document.ClassId)
                throw document.Error(document.Body, $"is a {document.ClassName}, but stands for a {item.Document.ClassName} of {item.Document.Path}");
            if (standIn.SourceGuid != guid)
                throw document.Error(document.Body, $"stands for an object of {standIn.SourceGuid}, but its prefab instance is one of {guid}");
            standIn.IsUsed = true;
            return document.FileId;
        }

        /// <summary>Turns the numbers of an object, and of those to which it refers, into the holding file's.</summary>
        static void Renumber(GraphItem item, Dictionary<long, long> numbers)
        {
            item.Id = numbers[item.Id];
            foreach (var key in new[] { "m_CorrespondingSourceObject", "m_PrefabInstance", "m_PrefabAsset" })
                item.Document.Body.Children.Remove(key);
            foreach (var reference in YamlNodes.References(item.Document.Body).Where(r => YamlNodes.Child(r, "guid") == null))
            {
                var id = (YamlScalarNode)YamlNodes.Child(reference, "fileID");
                var number = item.Document.Long(id);
                if (number == 0)
                    continue;
                if (!numbers.TryGetValue(number, out var renumbered))
                    throw item.Document.Error(reference, $"refers to fileID {number}, which the file does not have");
                id.Value = renumbered.ToString(CultureInfo.InvariantCulture);
            }
        }
    }

    /// <summary>A stripped document: the number by which a file knows an object of one of its prefab instances.</summary>
    sealed class StandIn
    {
        internal StandIn(YamlDocument document)
        {
            Document = document;
            InstanceId = document.LocalId(document.Needed(document.Body, "m_PrefabInstance"));
            var source = document.Mapping(document.Needed(document.Body, "m_CorrespondingSourceObject"));
            SourceId = document.Long(document.Needed(source, "fileID"));
            SourceGuid = document.Scalar(document.Needed(source, "guid"));
        }

        internal YamlDocument Document { get; }

        internal long InstanceId { get; }

        /// <summary>The object's number in the prefab.</summary>
        internal long SourceId { get; }

        internal string SourceGuid { get; }

        internal bool IsUsed { get; set; }
    }
}
