using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine.Events;
using UnityEngine.Serialization;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>Fills serialised fields of scripts from YAML. Fields that the file lacks keep their initial values.</summary>
    sealed class YamlFields
    {
        readonly YamlDocument m_Document;
        readonly YamlValues m_Values;
        readonly bool m_Strict;

        /// <param name="document">Where the fields stand.</param>
        /// <param name="references">Finds what references mean.</param>
        /// <param name="strict">
        /// Whether a key without a field is an error. It is for the package's own scripts; the host's versions of other packages' scripts
        /// have only some of the fields.
        /// </param>
        internal YamlFields(YamlDocument document, YamlReferences references, bool strict)
        {
            m_Document = document;
            m_Values = new YamlValues(document, references, this);
            m_Strict = strict;
        }

        internal void Read(object target, IEnumerable<KeyValuePair<YamlNode, YamlNode>> children)
        {
            var fields = SerializedFields.Of(target.GetType());
            foreach (var (key, node) in children.Select(c => (YamlNodes.Key(c), c.Value)))
            {
                var field = Array.Find(fields, f => f.Name == key) ??
                    Array.Find(fields, f => f.GetCustomAttributes<FormerlySerializedAsAttribute>().Any(a => a.oldName == key));
                if (field != null)
                    Read(target, field, node);
                else if (m_Strict)
                    throw m_Document.Error(node, $"{target.GetType().Name} has no serialised field '{key}'");
            }
        }

        /// <summary>A [Serializable] class or struct: what is there already stays where the file says nothing.</summary>
        internal object Nested(YamlMappingNode node, Type type, object current)
        {
            var value = current ?? Activator.CreateInstance(type, true);
            Read(value, node.Children.Where(c => YamlNodes.Key(c) != "serializedVersion"));
            (value as ISerializationCallbackReceiver)?.OnAfterDeserialize();
            return value;
        }

        void Read(object target, FieldInfo field, YamlNode node)
        {
            if (SerializedFields.IsReference(field))
                throw m_Document.Error(node, $"field '{field.Name}' is [SerializeReference], which is not supported in files");
            try
            {
                field.SetValue(target, m_Values.Read(node, field.FieldType, field.GetValue(target)));
            }
            catch (AssetFormatException) when (!m_Strict && IsMissingHere(field.FieldType))
            {
                // The host's version of the script has a field for something of which the host knows only that it exists.
            }
        }

        static bool IsMissingHere(Type type) => typeof(Object).IsAssignableFrom(type);
    }
}
