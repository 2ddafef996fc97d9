using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using YamlDotNet.Core;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>Takes a file of Unity's text form (.asset, .prefab, .unity, .mat) apart into its objects.</summary>
    static class YamlFile
    {
        const string Version = "%YAML 1.1";
        const string Tag = "%TAG !u! tag:unity3d.com,2011:";

        static readonly Regex s_Header = new(@"^--- !u!(\d+) &(-?\d+)( stripped)?$", RegexOptions.CultureInvariant);

        /// <exception cref="AssetFormatException">The file is not of that form, or two objects have the same number.</exception>
        internal static List<YamlDocument> Read(string path)
        {
            var lines = File.ReadAllText(path).Replace("\r\n", "\n").Split('\n');
            if (lines.Length < 2 || lines[0] != Version || lines[1] != Tag)
                throw new AssetFormatException(path, $"line 1: expected the two lines '{Version}' and '{Tag}'");
            var documents = new List<YamlDocument>();
            for (var start = 2; start < lines.Length;)
            {
                var end = start + 1;
                while (end < lines.Length && !lines[end].StartsWith("--- ", StringComparison.Ordinal))
                    end++;
                if (lines.Skip(start).Take(end - start).Any(l => l.Length > 0))
                    documents.Add(Document(path, lines, start, end));
                start = end;
            }

            if (documents.GroupBy(d => d.FileId).FirstOrDefault(g => g.Count() > 1) is { } twice)
                throw twice.Last().Error(twice.Last().Body, $"a second object with the number {twice.Key}");
            return documents;
        }

        static YamlDocument Document(string path, string[] lines, int start, int end)
        {
            var header = s_Header.Match(lines[start]);
            if (!header.Success || !int.TryParse(header.Groups[1].Value, NumberStyles.None, CultureInfo.InvariantCulture, out var classId)
                || !YamlNodes.TryLong(header.Groups[2].Value, out var fileId) || fileId == 0)
                throw new AssetFormatException(path, $"line {start + 1}: '{lines[start]}' is not '--- !u!<class> &<number>'");
            var root = Parse(path, lines, start + 1, end) as YamlMappingNode;
            if (root == null || root.Children.Count != 1 || root.Children.Single().Value is not YamlMappingNode body)
                throw new AssetFormatException(path, $"line {start + 2}: expected a class name and below it its fields");
            return new YamlDocument(path, classId, fileId, header.Groups[3].Success, YamlNodes.Key(root.Children.Single()), body, start + 1);
        }

        static YamlNode Parse(string path, string[] lines, int start, int end)
        {
            try
            {
                var stream = new YamlStream();
                stream.Load(new StringReader(string.Join("\n", lines, start, end - start)));
                return stream.Documents.FirstOrDefault()?.RootNode;
            }
            catch (YamlException e)
            {
                throw new AssetFormatException(path, $"line {start + e.Start.Line}: {e.Message}", e);
            }
        }
    }
}
