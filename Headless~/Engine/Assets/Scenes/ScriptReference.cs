using System;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>The class that a document's m_Script means.</summary>
    readonly struct ScriptReference
    {
        ScriptReference(Type type, string typeName, bool isOwn)
        {
            Type = type;
            TypeName = typeName;
            IsOwn = isOwn;
        }

        /// <summary>The class; null if it belongs to a package of which the host knows the names only.</summary>
        internal Type Type { get; }

        /// <summary>Its name with the namespace.</summary>
        internal string TypeName { get; }

        /// <summary>True for a script of the package or of a sample, false for one of another package.</summary>
        internal bool IsOwn { get; }

        /// <exception cref="AssetFormatException">There is no such script.</exception>
        internal static ScriptReference Of(YamlDocument document)
        {
            var script = document.Mapping(document.Needed(document.Body, "m_Script"));
            var guid = YamlNodes.Child(script, "guid") is { } node ? document.Scalar(node) : throw document.Error(script, "m_Script has no GUID");
            if (document.Long(document.Needed(script, "fileID")) != PackagePart.ScriptFileId || document.Long(document.Needed(script, "type")) != 3)
                throw document.Error(script, $"a script is referred to by {{fileID: {PackagePart.ScriptFileId}, guid: ..., type: 3}}");
            var found = Find(document, script, guid);
            CheckIdentifier(document, found);
            return found;
        }

        static ScriptReference Find(YamlDocument document, YamlNode script, string guid)
        {
            if (AssetLibrary.PathOf(guid) is { } path)
            {
                var type = ScriptTypes.OfScript(path, document.Path);
                return new ScriptReference(type, type.FullName, true);
            }

            if (InstalledPackages.Find(guid) is not { IsScript: true } part)
                throw document.Error(script, $"its script's GUID {guid} belongs to no .meta of the package, nor to a script of a package that it depends on");
            part.EnsureInstalled(document, script);
            return new ScriptReference(ScriptTypes.Find(part.Name), part.Name, false);
        }

        /// <summary>Newer versions of Unity note assembly and class beside the GUID.</summary>
        static void CheckIdentifier(YamlDocument document, ScriptReference script)
        {
            if (YamlNodes.Child(document.Body, "m_EditorClassIdentifier") is not YamlScalarNode { Value: { Length: > 0 } noted } node)
                return;
            var name = noted.Substring(noted.LastIndexOf(':') + 1);
            if (name != script.TypeName)
                throw document.Error(node, $"names the class {name}, but its script is {script.TypeName}");
        }
    }
}
