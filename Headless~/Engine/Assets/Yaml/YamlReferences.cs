using System;
using System.Collections.Generic;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>Finds what { fileID, guid, type } means: an object of the same file, an asset, a built-in resource or a part of another package.</summary>
    sealed class YamlReferences
    {
        readonly IReadOnlyDictionary<long, Object> m_Local;

        internal YamlReferences(IReadOnlyDictionary<long, Object> local) => m_Local = local;

        /// <summary>The object; null for fileID 0.</summary>
        /// <exception cref="AssetFormatException">There is no such object.</exception>
        internal Object Resolve(YamlDocument document, YamlNode node)
        {
            // An override of a prefab instance spells "none" as an empty value where the prefab has no such field.
            if (node is YamlScalarNode { Value: null or "" })
                return null;
            var reference = document.Mapping(node);
            var fileId = document.Long(document.Needed(reference, "fileID"));
            if (fileId == 0)
                return null;
            var guid = YamlNodes.Child(reference, "guid");
            if (guid == null)
                return m_Local.TryGetValue(fileId, out var local)
                    ? local
                    : throw document.Error(node, $"refers to fileID {fileId}, which the file does not have");
            return External(document, reference, document.Scalar(guid), fileId);
        }

        /// <summary>Finds every reference in a document.</summary>
        /// <exception cref="AssetFormatException">One leads nowhere.</exception>
        internal void CheckAll(YamlDocument document)
        {
            var script = YamlNodes.Child(document.Body, "m_Script");
            foreach (var reference in YamlNodes.References(document.Body))
                if (!ReferenceEquals(reference, script))
                    Resolve(document, reference);
        }

        static Object External(YamlDocument document, YamlMappingNode node, string guid, long fileId)
        {
            var type = document.Long(document.Needed(node, "type"));
            if (BuiltinResources.IsBuiltin(guid))
            {
                CheckType(document, node, type, 0, "a built-in resource");
                return BuiltinResources.Find(guid, fileId)
                    ?? throw document.Error(node, $"refers to fileID {fileId} of GUID {guid}, which no built-in resource known here has");
            }

            if (AssetLibrary.PathOf(guid) is { } path)
            {
                CheckType(document, node, type, AssetLibrary.IsNative(path) ? 2 : 3, path);
                var objects = AssetLibrary.LoadFile(path);
                if (objects.TryGetValue(fileId, out var asset))
                    return asset;
                var present = objects.Count == 0 ? "no objects" : "only " + string.Join(", ", objects.Keys);
                throw document.Error(node, $"refers to fileID {fileId} of {path}, which has {present}");
            }

            if (InstalledPackages.Find(guid) is not { } part)
                throw document.Error(node, $"refers to GUID {guid}, which no .meta of the package has, nor a package that it depends on");
            part.EnsureInstalled(document, node);
            if (Array.IndexOf(part.FileIds, fileId) < 0)
                throw document.Error(node, $"refers to fileID {fileId} of {part.Name} in {part.Package}, which has only {string.Join(", ", part.FileIds)}");
            return DataAsset.Of(part.Package + "/" + part.Name, fileId);
        }

        static void CheckType(YamlDocument document, YamlNode node, long type, long expected, string what)
        {
            if (type != expected)
                throw document.Error(node, $"a reference to {what} has type {expected}, not {type}");
        }
    }
}
