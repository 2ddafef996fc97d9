using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using UnityEditor.AssetImporters;
using UnityEngine;

namespace UnityEditor
{
    /// <summary>Which importers scripts bring, by the last extension of a file's name.</summary>
    sealed class ImporterTypes
    {
        readonly Dictionary<string, Type> m_Default = new(StringComparer.OrdinalIgnoreCase);
        readonly Dictionary<string, List<Type>> m_Override = new(StringComparer.OrdinalIgnoreCase);

        /// <param name="types">The classes to look through. As in Unity two importers that claim an extension are both rejected.</param>
        internal ImporterTypes(IEnumerable<Type> types)
        {
            var claims = new List<(string Extension, Type Type)>();
            foreach (var type in types.Where(t => typeof(ScriptedImporter).IsAssignableFrom(t)))
            {
                if (type.GetCustomAttribute<ScriptedImporterAttribute>(false) is not { } attribute)
                    continue;
                claims.AddRange(attribute.fileExtensions.Select(e => (e, type)));
                foreach (var extension in attribute.overrideFileExtensions)
                    Overriding(extension).Add(type);
            }

            foreach (var claim in claims.GroupBy(c => c.Extension, StringComparer.OrdinalIgnoreCase))
            {
                if (claim.Count() == 1)
                    m_Default.Add(claim.Key, claim.Single().Type);
                else
                    Debug.LogError($"Multiple scripted importers are targeting the extension '{claim.Key}' and have all been rejected: "
                        + string.Join(", ", claim.Select(c => c.Type.FullName)));
            }
        }

        internal Type DefaultOf(string path) => m_Default.TryGetValue(Extension(path), out var type) ? type : null;

        /// <summary>All that may import the file, the default one first.</summary>
        internal Type[] AvailableFor(string path)
        {
            var all = new List<Type>(Overriding(Extension(path)));
            if (DefaultOf(path) is { } byDefault)
                all.Insert(0, byDefault);
            return all.ToArray();
        }

        List<Type> Overriding(string extension)
        {
            if (!m_Override.TryGetValue(extension, out var types))
                m_Override.Add(extension, types = new List<Type>());
            return types;
        }

        static string Extension(string path) => Path.GetExtension(path).TrimStart('.');
    }
}
