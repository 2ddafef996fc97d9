using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>The fields of one of the engine's own objects, for the reader of its class. A missing field leaves what is there.</summary>
    sealed class NativeFields
    {
        readonly YamlReferences m_References;
        readonly YamlValues m_Values;

        internal NativeFields(YamlDocument document, YamlReferences references)
        {
            Document = document;
            m_References = references;
            m_Values = new YamlValues(document, references, new YamlFields(document, references, true));
        }

        internal YamlDocument Document { get; }

        internal YamlMappingNode Body => Document.Body;

        /// <summary>A field's value, read as its type asks.</summary>
        /// <param name="key">The field's name in the file.</param>
        /// <param name="current">What there is if the file lacks it.</param>
        internal T Get<T>(string key, T current) => Get(Body, key, current);

        internal T Get<T>(YamlMappingNode from, string key, T current) =>
            YamlNodes.Child(from, key) is { } node ? (T)m_Values.Read(node, typeof(T), current) : current;

        internal T Value<T>(YamlNode node) => (T)m_Values.Read(node, typeof(T), default(T));

        /// <summary>A reference to what may be any object; null where the file lacks it.</summary>
        internal Object Any(string key) => YamlNodes.Child(Body, key) is { } node ? m_References.Resolve(Document, node) : null;

        /// <summary>A part of the object that has fields of its own; an empty one where the file lacks it.</summary>
        internal YamlMappingNode Part(string key) => YamlNodes.Child(Body, key) is { } node ? Document.Mapping(node) : new YamlMappingNode();
    }
}
