using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using YamlDotNet.Core;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>Loads .asset files in Unity's text form: ScriptableObjects, one per YAML document.</summary>
    static class YamlAsset
    {
        const string ScriptTag = "tag:unity3d.com,2011:114";

        /// <summary>Keys that every script document has besides its own fields.</summary>
        static readonly HashSet<string> s_Common = new()
        {
            "m_ObjectHideFlags", "m_CorrespondingSourceObject", "m_PrefabInstance", "m_PrefabAsset", "m_GameObject", "m_Enabled", "m_EditorHideFlags",
            "m_Script", "m_Name", "m_EditorClassIdentifier",
        };

        /// <summary>Adds the file's objects by fileID. They are entered before their fields are read, so that files may refer to each other.</summary>
        /// <exception cref="AssetFormatException">Something in the file is unknown or missing.</exception>
        internal static void Load(string path, Dictionary<long, Object> objects)
        {
            var bodies = new List<(ScriptableObject Target, YamlMappingNode Body)>();
            foreach (var document in Parse(path).Documents)
            {
                var root = document.RootNode as YamlMappingNode ?? throw new AssetFormatException(path, "a document is no mapping");
                if (root.Tag.IsEmpty || root.Tag.Value != ScriptTag
                    || !long.TryParse(root.Anchor.Value, NumberStyles.Integer, CultureInfo.InvariantCulture, out var fileId))
                    throw new AssetFormatException(path,
                        $"a document with tag '{root.Tag}' and anchor '{root.Anchor}' is not supported; expected !u!114 &<fileID>");
                var body = Child(root, "MonoBehaviour") as YamlMappingNode ?? throw new AssetFormatException(path, "a document has no 'MonoBehaviour'");
                var target = ScriptableObject.Construct(TypeOf(path, body));
                AssetLibrary.Enter(objects, fileId, target, (Child(body, "m_Name") as YamlScalarNode)?.Value ?? "");
                bodies.Add((target, body));
            }

            foreach (var (target, body) in bodies)
            {
                var reader = new YamlFields(path, objects);
                reader.Read(target, body.Children.Where(c => !s_Common.Contains(((YamlScalarNode)c.Key).Value)));
                (target as ISerializationCallbackReceiver)?.OnAfterDeserialize();
            }

            foreach (var (target, _) in bodies)
                target.SendAwake();
        }

        static YamlStream Parse(string path)
        {
            try
            {
                var stream = new YamlStream();
                using var reader = new StreamReader(path);
                stream.Load(reader);
                return stream;
            }
            catch (YamlException e)
            {
                throw new AssetFormatException(path, e.Message, e);
            }
        }

        static Type TypeOf(string path, YamlMappingNode body)
        {
            var guid = (Child(body, "m_Script") as YamlMappingNode) is { } script ? (Child(script, "guid") as YamlScalarNode)?.Value : null;
            if (guid == null)
                throw new AssetFormatException(path, "has no m_Script with a GUID");
            var scriptPath = AssetLibrary.PathOf(guid) ?? throw new AssetFormatException(path, $"its script's GUID {guid} belongs to no .meta of the package");
            var type = ScriptTypes.OfScript(scriptPath, path);
            if (!typeof(ScriptableObject).IsAssignableFrom(type))
                throw new AssetFormatException(path, $"its script {scriptPath} is no ScriptableObject");
            return type;
        }

        internal static YamlNode Child(YamlMappingNode node, string key) => node.Children.TryGetValue(new YamlScalarNode(key), out var child) ? child : null;
    }
}
