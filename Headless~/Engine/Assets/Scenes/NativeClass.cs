using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;

namespace UnityEngine
{
    /// <summary>One of the engine's own classes as files know it: by number, with the fields that it has there (Tables/native-classes.txt).</summary>
    sealed class NativeClass
    {
        internal const int GameObject = 1, Transform = 4, Material = 21, OcclusionCullingSettings = 29, RenderSettings = 104, MonoBehaviour = 114,
            LightmapSettings = 157, NavMeshSettings = 196, RectTransform = 224, PrefabInstance = 1001, SceneRoots = 1660057539;

        static readonly Dictionary<int, NativeClass> s_ById = Read();

        readonly HashSet<string> m_Fields = new(StringComparer.Ordinal);
        readonly NativeClass m_Base;

        NativeClass(int id, string name, NativeClass parent)
        {
            Id = id;
            Name = name;
            m_Base = parent;
            if (parent != null)
                m_Fields.UnionWith(parent.m_Fields);
        }

        internal int Id { get; }

        internal string Name { get; }

        internal bool IsComponent => Is("Component");

        internal bool IsTransform => Is("Transform");

        internal bool IsSettings => Id is OcclusionCullingSettings or RenderSettings or LightmapSettings or NavMeshSettings;

        /// <summary>The class of a document.</summary>
        /// <exception cref="AssetFormatException">The number is unknown, or it is another class's.</exception>
        internal static NativeClass Of(YamlDocument document)
        {
            if (!s_ById.TryGetValue(document.ClassId, out var found))
                throw document.Error(document.Body, $"class {document.ClassId} ({document.ClassName}) is unknown to the host");
            if (document.ClassName != found.Name)
                throw document.Error(document.Body, $"class {document.ClassId} is {found.Name}, not {document.ClassName}");
            return found;
        }

        /// <summary>True for a field that every file has for such an object, whatever its script.</summary>
        internal bool Has(string field) => m_Fields.Contains(field);

        /// <exception cref="AssetFormatException">A field is not one of the class's.</exception>
        internal void CheckFields(YamlDocument document)
        {
            foreach (var field in document.Body.Children)
                if (!m_Fields.Contains(YamlNodes.Key(field)))
                    throw document.Error(field.Value, $"{Name} has no serialised field '{YamlNodes.Key(field)}'");
        }

        bool Is(string name)
        {
            for (var c = this; c != null; c = c.m_Base)
                if (c.Name == name)
                    return true;
            return false;
        }

        static Dictionary<int, NativeClass> Read()
        {
            var byName = new Dictionary<string, NativeClass>();
            NativeClass current = null;
            foreach (var line in TextTable.Lines("native-classes.txt"))
            {
                if (line[0] == ' ')
                {
                    current.m_Fields.UnionWith(Regex.Matches(line, "\"([^\"]+)\"|\\[(\\w+)\\]|(\\w+)").Cast<Match>()
                        .Select(m => m.Groups.Cast<Group>().Skip(1).First(g => g.Success).Value));
                    continue;
                }

                var words = line.Split(' ');
                current = new NativeClass(int.Parse(words[0], CultureInfo.InvariantCulture), words[1], words.Length > 3 ? byName[words[3]] : null);
                byName.Add(current.Name, current);
            }

            return byName.Values.Where(c => c.Id != 0).ToDictionary(c => c.Id);
        }
    }
}
