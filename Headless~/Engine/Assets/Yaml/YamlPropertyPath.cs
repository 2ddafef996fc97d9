using System;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>Unity's property paths, such as m_LocalPosition.x or m_Materials.Array.data[0], on a document.</summary>
    static class YamlPropertyPath
    {
        static readonly Regex s_Item = new(@"^data\[(\d+)\]$", RegexOptions.CultureInvariant);

        /// <summary>Writes a value there. What the path leads through is made where the document lacks it.</summary>
        /// <param name="document">The document to change.</param>
        /// <param name="path">The path from its body.</param>
        /// <param name="source">The document in which value and reference stand: its file and line are named if they do not fit.</param>
        /// <param name="value">The value, unless the property is a reference.</param>
        /// <param name="reference">The reference, if the property is one; otherwise fileID 0.</param>
        /// <exception cref="AssetFormatException">The path cannot be followed.</exception>
        internal static void Set(YamlDocument document, string path, YamlDocument source, YamlNode value, YamlMappingNode reference)
        {
            var parts = path.Split('.');
            YamlNode at = document.Body;
            for (var i = 0; i < parts.Length; i++)
            {
                var isLast = i == parts.Length - 1;
                if (parts[i] == "Array" && !isLast)
                {
                    i++;
                    isLast = i == parts.Length - 1;
                    var list = at as YamlSequenceNode ?? throw source.Error(value, $"'{path}' goes through something that is no list");
                    if (parts[i] == "size" && isLast)
                    {
                        Resize(list, source, value);
                        return;
                    }

                    at = Step(source, value, path, parts[i], list, isLast, n => Final(n, value, reference), i + 1 < parts.Length && parts[i + 1] == "Array");
                }
                else
                {
                    var mapping = at as YamlMappingNode ?? throw source.Error(value, $"'{path}' goes through '{parts[i]}', where there are no fields");
                    var next = YamlNodes.Child(mapping, parts[i]);
                    if (isLast)
                        mapping.Children[new YamlScalarNode(parts[i])] = Final(next, value, reference);
                    else if (next is null or YamlScalarNode { Value: null or "" or "[]" })
                        mapping.Children[new YamlScalarNode(parts[i])] = next = Container(parts[i + 1]);
                    at = next;
                }
            }

            document.Adopt(value, source);
            document.Adopt(reference, source);
        }

        static YamlNode Step(YamlDocument source, YamlNode value, string path, string part, YamlSequenceNode list, bool isLast, Func<YamlNode, YamlNode> final,
            bool listFollows)
        {
            var match = s_Item.Match(part);
            if (!match.Success || !int.TryParse(match.Groups[1].Value, NumberStyles.None, CultureInfo.InvariantCulture, out var index))
                throw source.Error(value, $"'{path}': '{part}' is neither size nor data[index]");
            if (index >= list.Children.Count)
                throw source.Error(value, $"'{path}': the list has {list.Children.Count} items");
            if (isLast)
                list.Children[index] = final(list.Children[index]);
            else if (list.Children[index] is YamlScalarNode { Value: null or "" })
                list.Children[index] = listFollows ? new YamlSequenceNode() : new YamlMappingNode();
            return list.Children[index];
        }

        /// <summary>The reference where there is one, or was one; otherwise the value.</summary>
        static YamlNode Final(YamlNode current, YamlNode value, YamlMappingNode reference) =>
            YamlNodes.Child(reference, "fileID") is YamlScalarNode { Value: not "0" } || YamlNodes.IsReference(current) ? reference : value;

        static YamlNode Container(string next) => next == "Array" ? new YamlSequenceNode() : new YamlMappingNode();

        static void Resize(YamlSequenceNode list, YamlDocument source, YamlNode value)
        {
            var size = source.Long(value);
            if (size is < 0 or > int.MaxValue)
                throw source.Error(value, $"{size} is no length of a list");
            while (list.Children.Count > size)
                list.Children.RemoveAt(list.Children.Count - 1);
            // Unity repeats the last item; whoever lengthens a list overrides the new items too, so empty ones do here.
            while (list.Children.Count < size)
                list.Children.Add(new YamlScalarNode(""));
        }
    }
}
