using System.Collections.Generic;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>One object in a file of Unity's text form: "--- !u!CLASS &amp;ID", a class name and the object's fields.</summary>
    sealed class YamlDocument
    {
        readonly int m_LinesBefore;
        Dictionary<YamlNode, YamlDocument> m_Foreign;

        internal YamlDocument(string path, int classId, long fileId, bool isStripped, string className, YamlMappingNode body, int linesBefore)
        {
            Path = path;
            ClassId = classId;
            FileId = fileId;
            IsStripped = isStripped;
            ClassName = className;
            Body = body;
            m_LinesBefore = linesBefore;
        }

        internal string Path { get; }

        internal int ClassId { get; }

        /// <summary>The object's number in its own file.</summary>
        internal long FileId { get; }

        /// <summary>True for a mere stand-in of an object that comes with a prefab instance.</summary>
        internal bool IsStripped { get; }

        internal string ClassName { get; }

        internal YamlMappingNode Body { get; }

        /// <summary>Notes that a node, with all below it, was written in another document: that of a prefab instance which overrides this one.</summary>
        internal void Adopt(YamlNode node, YamlDocument from)
        {
            m_Foreign ??= new Dictionary<YamlNode, YamlDocument>(ReferenceComparer<YamlNode>.Instance);
            foreach (var inner in YamlNodes.Tree(node))
                m_Foreign[inner] = from;
        }

        /// <summary>An error that names file and line.</summary>
        internal AssetFormatException Error(YamlNode node, string problem) =>
            m_Foreign != null && m_Foreign.TryGetValue(node, out var from)
                ? from.Error(node, problem)
                : new AssetFormatException(Path, $"line {m_LinesBefore + node.Start.Line}: {problem}");

        /// <summary>The field, which must be there.</summary>
        internal YamlNode Needed(YamlMappingNode node, string key) => YamlNodes.Child(node, key) ?? throw Error(node, $"{ClassName}: '{key}' is missing");

        internal YamlMappingNode Mapping(YamlNode node) => node as YamlMappingNode ?? throw Error(node, "expected { key: value, ... }");

        /// <summary>The items of a list; a missing one and Unity's "[]" are empty.</summary>
        internal IList<YamlNode> List(YamlNode node)
        {
            if (node is null or YamlScalarNode { Value: null or "" })
                return new List<YamlNode>();
            return (node as YamlSequenceNode ?? throw Error(node, "expected a list")).Children;
        }

        internal string Scalar(YamlNode node) => (node as YamlScalarNode ?? throw Error(node, "expected a single value")).Value ?? "";

        /// <exception cref="AssetFormatException">It is no whole number.</exception>
        internal long Long(YamlNode node) =>
            YamlNodes.TryLong(Scalar(node), out var value) ? value : throw Error(node, $"'{Scalar(node)}' is no whole number");

        /// <summary>The fileID of a reference within the file.</summary>
        internal long LocalId(YamlNode node)
        {
            var reference = Mapping(node);
            if (YamlNodes.Child(reference, "guid") is { } guid)
                throw Error(guid, "a reference to another file where one into this file belongs");
            return Long(Needed(reference, "fileID"));
        }
    }
}
