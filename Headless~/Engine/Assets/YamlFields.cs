using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using UnityEngine.Serialization;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>Fills serialised fields from YAML. Fields that the file lacks keep their initial values; unknown keys are errors.</summary>
    sealed class YamlFields
    {
        readonly string m_Path;
        readonly Dictionary<long, Object> m_Local;

        internal YamlFields(string path, Dictionary<long, Object> local)
        {
            m_Path = path;
            m_Local = local;
        }

        internal void Read(object target, IEnumerable<KeyValuePair<YamlNode, YamlNode>> children)
        {
            var fields = SerializedFields.Of(target.GetType());
            foreach (var (key, node) in children.Select(c => (((YamlScalarNode)c.Key).Value, c.Value)))
            {
                var field = fields.FirstOrDefault(f => f.Name == key) ??
                    fields.FirstOrDefault(f => f.GetCustomAttributes<FormerlySerializedAsAttribute>().Any(a => a.oldName == key));
                if (field == null)
                    throw Error(node, $"{target.GetType().Name} has no serialised field '{key}'");
                if (SerializedFields.IsReference(field))
                    throw Error(node, $"field '{key}' is [SerializeReference], which is not supported in files");
                field.SetValue(target, Value(node, field.FieldType));
            }
        }

        object Value(YamlNode node, Type type)
        {
            try
            {
                if (typeof(Object).IsAssignableFrom(type))
                    return Reference(Mapping(node), type);
                if (SerializedFields.ElementOf(type) is { } element)
                    return List(node, type, element);
                if (type == typeof(string))
                    return Scalar(node);
                if (type.IsEnum)
                    return Enum.ToObject(type, long.Parse(Scalar(node), CultureInfo.InvariantCulture));
                if (type == typeof(bool))
                    return Scalar(node) switch { "0" => false, "1" => true, var other => throw new FormatException($"'{other}' is neither 0 nor 1") };
                if (type == typeof(char))
                    return (char)int.Parse(Scalar(node), CultureInfo.InvariantCulture);
                if (type.IsPrimitive)
                    return Convert.ChangeType(Scalar(node), type, CultureInfo.InvariantCulture);
                if (SerializedFields.IsEngineStruct(type))
                    return YamlStructs.Read(Mapping(node), type);
                return Nested(Mapping(node), type);
            }
            catch (Exception e) when (e is FormatException or OverflowException or InvalidCastException)
            {
                throw Error(node, $"expected a {type.Name}: {e.Message}");
            }
        }

        object Nested(YamlMappingNode node, Type type)
        {
            var value = Activator.CreateInstance(type, true);
            Read(value, node.Children.Where(c => ((YamlScalarNode)c.Key).Value != "serializedVersion"));
            (value as ISerializationCallbackReceiver)?.OnAfterDeserialize();
            return value;
        }

        object List(YamlNode node, Type type, Type element)
        {
            var items = node switch
            {
                YamlSequenceNode sequence => sequence.Children.Select(c => Value(c, element)).ToList(),
                YamlScalarNode scalar => YamlStructs.PackedIntegers(scalar.Value ?? "", element),
                _ => throw Error(node, "expected a list"),
            };
            if (type.IsArray)
            {
                var array = Array.CreateInstance(element, items.Count);
                for (var i = 0; i < items.Count; i++)
                    array.SetValue(items[i], i);
                return array;
            }

            var list = (IList)Activator.CreateInstance(type);
            items.ForEach(i => list.Add(i));
            return list;
        }

        Object Reference(YamlMappingNode node, Type type)
        {
            var fileId = long.Parse(Scalar(YamlAsset.Child(node, "fileID") ?? throw Error(node, "a reference without fileID")), CultureInfo.InvariantCulture);
            if (fileId == 0)
                return null;
            var guid = YamlAsset.Child(node, "guid");
            Object found;
            if (guid != null)
                found = AssetLibrary.Load(Scalar(guid), fileId, m_Path);
            else if (!m_Local.TryGetValue(fileId, out found))
                throw Error(node, $"refers to fileID {fileId}, which the file does not have");
            if (!type.IsInstanceOfType(found))
                throw Error(node, $"refers to a {found.GetType().Name} where a {type.Name} belongs");
            return found;
        }

        YamlMappingNode Mapping(YamlNode node) => node as YamlMappingNode ?? throw Error(node, "expected { key: value, ... }");

        string Scalar(YamlNode node) => (node as YamlScalarNode ?? throw Error(node, "expected a single value")).Value ?? "";

        AssetFormatException Error(YamlNode node, string problem) => new(m_Path, $"line {node.Start.Line}: {problem}");
    }
}
