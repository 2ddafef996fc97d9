using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using UnityEngine.Events;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>Reads single values of any type that Unity serialises.</summary>
    sealed class YamlValues
    {
        readonly YamlDocument m_Document;
        readonly YamlReferences m_References;
        readonly YamlFields m_Fields;

        internal YamlValues(YamlDocument document, YamlReferences references, YamlFields fields)
        {
            m_Document = document;
            m_References = references;
            m_Fields = fields;
        }

        /// <param name="node">The value's node.</param>
        /// <param name="type">What to make of it.</param>
        /// <param name="current">What is there before: parts that the node lacks keep their value.</param>
        /// <exception cref="AssetFormatException">The node is no such value.</exception>
        internal object Read(YamlNode node, Type type, object current)
        {
            try
            {
                if (typeof(Object).IsAssignableFrom(type))
                    return Reference(node, type);
                if (SerializedFields.ElementOf(type) is { } element)
                    return List(node, type, element);
                if (type == typeof(string))
                    return m_Document.Scalar(node);
                if (type.IsEnum)
                    return Enum.ToObject(type, long.Parse(m_Document.Scalar(node), CultureInfo.InvariantCulture));
                if (type.IsPrimitive)
                    return Primitive(m_Document.Scalar(node), type);
                if (SerializedFields.IsEngineStruct(type))
                    return YamlStructs.Read(m_Document.Mapping(node), type, current);
                if (typeof(UnityEventBase).IsAssignableFrom(type))
                    return YamlEvents.Read(m_Document, m_References, m_Document.Mapping(node), type);
                return m_Fields.Nested(m_Document.Mapping(node), type, current);
            }
            catch (Exception e) when (e is FormatException or OverflowException or InvalidCastException)
            {
                throw m_Document.Error(node, $"expected a {type.Name}: {e.Message}");
            }
        }

        static object Primitive(string text, Type type)
        {
            if (type == typeof(bool))
                return text switch { "0" => false, "1" => true, _ => throw new FormatException($"'{text}' is neither 0 nor 1") };
            if (type == typeof(char))
                return (char)int.Parse(text, CultureInfo.InvariantCulture);
            return Convert.ChangeType(text, type, CultureInfo.InvariantCulture);
        }

        object List(YamlNode node, Type type, Type element)
        {
            var items = node is YamlScalarNode scalar
                ? YamlStructs.PackedIntegers(scalar.Value ?? "", element)
                : m_Document.List(node).Select(c => Read(c, element, null)).ToList();
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

        Object Reference(YamlNode node, Type type)
        {
            var found = m_References.Resolve(m_Document, node);
            if (found is null || type.IsInstanceOfType(found))
                return found;
            throw m_Document.Error(node, $"refers to {Describe(found)} where a {type.Name} belongs");
        }

        static string Describe(Object o) => o switch
        {
            DataComponent data => $"a {data.TypeName}, of which the host has only the data,",
            DataAsset data => $"'{data.name}', which the host knows by name only,",
            _ => "a " + o.GetType().Name,
        };
    }
}
