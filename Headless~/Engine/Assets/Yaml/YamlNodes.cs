using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Runtime.CompilerServices;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>Small steps on YAML trees.</summary>
    static class YamlNodes
    {
        internal static YamlNode Child(YamlMappingNode node, string key) => node.Children.TryGetValue(new YamlScalarNode(key), out var child) ? child : null;

        internal static string Key(KeyValuePair<YamlNode, YamlNode> field) => (field.Key as YamlScalarNode)?.Value ?? "";

        internal static bool TryLong(string text, out long value) =>
            long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out value);

        /// <summary>The node and all below it, keys left out.</summary>
        internal static IEnumerable<YamlNode> Tree(YamlNode node)
        {
            yield return node;
            var inner = node switch
            {
                YamlMappingNode mapping => mapping.Children.Values,
                YamlSequenceNode sequence => sequence.Children,
                _ => Enumerable.Empty<YamlNode>(),
            };
            foreach (var child in inner)
                foreach (var below in Tree(child))
                    yield return below;
        }

        /// <summary>True for { fileID: ..., ... }.</summary>
        internal static bool IsReference(YamlNode node) => node is YamlMappingNode mapping && Child(mapping, "fileID") is YamlScalarNode;

        /// <summary>All references in a tree.</summary>
        internal static IEnumerable<YamlMappingNode> References(YamlNode node) => Tree(node).Where(IsReference).Cast<YamlMappingNode>();
    }

    /// <summary>Tells objects apart by identity, whatever they think of equality themselves.</summary>
    sealed class ReferenceComparer<T> : IEqualityComparer<T> where T : class
    {
        internal static readonly ReferenceComparer<T> Instance = new();

        public bool Equals(T x, T y) => ReferenceEquals(x, y);

        public int GetHashCode(T obj) => RuntimeHelpers.GetHashCode(obj);
    }
}
