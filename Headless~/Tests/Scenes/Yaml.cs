using System.Text;

namespace AnatomyCarve.Headless.Tests.Scenes
{
    /// <summary>Writes scenes and prefabs as Unity does.</summary>
    sealed class Yaml
    {
        readonly StringBuilder m_Text = new("%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n");

        /// <summary>A document: its header and its fields, which are given without the indentation of the first level.</summary>
        internal Yaml Add(int classId, string name, long id, string fields, bool stripped = false)
        {
            m_Text.Append($"--- !u!{classId} &{id}{(stripped ? " stripped" : "")}\n{name}:\n");
            foreach (var line in fields.Split('\n'))
                m_Text.Append("  ").Append(line).Append('\n');
            return this;
        }

        /// <summary>A GameObject and its Transform, whose number is one higher; further components are listed only.</summary>
        internal Yaml GameObject(long id, string name, long father = 0, long[] children = null, long[] components = null, bool active = true)
        {
            var list = new StringBuilder($"- component: {{fileID: {id + 1}}}");
            foreach (var component in components ?? [])
                list.Append($"\n- component: {{fileID: {component}}}");
            Add(1, "GameObject", id, $"{Plain}serializedVersion: 6\nm_Component:\n{list}\nm_Layer: 0\nm_Name: {name}\nm_TagString: Untagged\n"
                + $"m_Icon: {{fileID: 0}}\nm_NavMeshLayer: 0\nm_StaticEditorFlags: 0\nm_IsActive: {(active ? 1 : 0)}");
            return Transform(id + 1, id, father, children);
        }

        internal Yaml Transform(long id, long owner, long father = 0, long[] children = null, string position = "{x: 0, y: 0, z: 0}")
        {
            var list = new StringBuilder(children is null or [] ? " []" : "");
            foreach (var child in children ?? [])
                list.Append($"\n- {{fileID: {child}}}");
            return Add(4, "Transform", id, $"{Plain}m_GameObject: {{fileID: {owner}}}\nserializedVersion: 2\nm_LocalRotation: {{x: 0, y: 0, z: 0, w: 1}}\n"
                + $"m_LocalPosition: {position}\nm_LocalScale: {{x: 1, y: 1, z: 1}}\nm_ConstrainProportionsScale: 0\nm_Children:{list}\n"
                + $"m_Father: {{fileID: {father}}}\nm_LocalEulerAnglesHint: {{x: 0, y: 0, z: 0}}");
        }

        internal Yaml Script(long id, long owner, string script, string fields = "", bool enabled = true) =>
            Add(114, "MonoBehaviour", id, $"{Plain}m_GameObject: {{fileID: {owner}}}\nm_Enabled: {(enabled ? 1 : 0)}\nm_EditorHideFlags: 0\n"
                + $"m_Script: {script}\nm_Name: \nm_EditorClassIdentifier: {(fields.Length > 0 ? "\n" + fields : "")}");

        internal Yaml Roots(params long[] ids)
        {
            var list = new StringBuilder();
            foreach (var id in ids)
                list.Append($"\n- {{fileID: {id}}}");
            return Add(1660057539, "SceneRoots", 9223372036854775807, "m_ObjectHideFlags: 0\nm_Roots:" + (ids.Length == 0 ? " []" : list.ToString()));
        }

        /// <summary>An instance of a prefab. Changes are lines "target fileID|property path|value|object reference".</summary>
        internal Yaml Instance(long id, string prefabGuid, long parent = 0, string[] changes = null, string more = "m_RemovedComponents: []")
        {
            var list = new StringBuilder(changes is null or [] ? " []" : "");
            foreach (var change in changes ?? [])
            {
                var parts = change.Split('|');
                list.Append($"\n  - target: {{fileID: {parts[0]}, guid: {prefabGuid}, type: 3}}\n    propertyPath: {parts[1]}\n    value: {parts[2]}\n"
                    + $"    objectReference: {(parts.Length > 3 ? parts[3] : "{fileID: 0}")}");
            }

            return Add(1001, "PrefabInstance", id, $"m_ObjectHideFlags: 0\nserializedVersion: 2\nm_Modification:\n  serializedVersion: 3\n"
                + $"  m_TransformParent: {{fileID: {parent}}}\n  m_Modifications:{list}\n  {more.Replace("\n", "\n  ")}\n"
                + $"m_SourcePrefab: {{fileID: 100100000, guid: {prefabGuid}, type: 3}}");
        }

        internal Yaml StandIn(int classId, string name, long id, long source, string prefabGuid, long instance) =>
            Add(classId, name, id, $"m_CorrespondingSourceObject: {{fileID: {source}, guid: {prefabGuid}, type: 3}}\n"
                + $"m_PrefabInstance: {{fileID: {instance}}}\nm_PrefabAsset: {{fileID: 0}}", true);

        public override string ToString() => m_Text.ToString();

        internal const string Plain =
            "m_ObjectHideFlags: 0\nm_CorrespondingSourceObject: {fileID: 0}\nm_PrefabInstance: {fileID: 0}\nm_PrefabAsset: {fileID: 0}\n";
    }
}
