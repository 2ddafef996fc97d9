using System;

namespace UnityEngine
{
    /// <summary>
    /// A component of which the host has only the data: of Unity's packages, or an engine class that nothing here needs. It can be referred to, found,
    /// switched and copied, and does nothing.
    /// </summary>
    sealed class DataComponent : Behaviour
    {
        /// <summary>The class that it stands for, with its namespace.</summary>
        internal string TypeName { get; private set; }

        /// <summary>What the file says of it.</summary>
        internal YamlDocument Document { get; private set; }

        internal void Fill(string typeName, YamlDocument document)
        {
            TypeName = typeName;
            Document = document;
        }

        internal override void CopyNativeState(Component source, Func<Object, Object> remap)
        {
            var other = (DataComponent)source;
            Fill(other.TypeName, other.Document);
        }
    }
}
