using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEditor.AssetImporters;
using UnityEngine;
using YamlDotNet.Core;
using YamlDotNet.RepresentationModel;
using Object = UnityEngine.Object;
using YamlDocument = UnityEngine.YamlDocument;

namespace UnityEditor
{
    /// <summary>What a .meta file says of a scripted importer: which script, and its settings.</summary>
    sealed class MetaSettings
    {
        const string Block = "ScriptedImporter";

        /// <summary>What the block of every scripted importer has besides its own fields.</summary>
        static readonly HashSet<string> s_Common = new()
        {
            "internalIDToNameTable", "externalObjects", "serializedVersion", "userData", "assetBundleName", "assetBundleVariant", "script",
        };

        readonly YamlDocument m_Document;

        MetaSettings(YamlDocument document) => m_Document = document;

        /// <summary>Null for a file without .meta, and for one whose .meta names another kind of importer.</summary>
        /// <exception cref="AssetFormatException">The .meta cannot be read.</exception>
        internal static MetaSettings Of(string path)
        {
            var meta = path + ".meta";
            if (!File.Exists(meta))
                return null;
            try
            {
                var stream = new YamlStream();
                using var reader = new StreamReader(meta);
                stream.Load(reader);
                return stream.Documents.FirstOrDefault()?.RootNode is YamlMappingNode root && YamlNodes.Child(root, Block) is YamlMappingNode body
                    ? new MetaSettings(new YamlDocument(meta, 0, 0, false, Block, body, 0))
                    : null;
            }
            catch (YamlException e)
            {
                throw new AssetFormatException(meta, $"line {e.Start.Line}: {e.Message}", e);
            }
        }

        /// <summary>The importer's class; null if the .meta names none, or one that is not a script of the project.</summary>
        internal Type ImporterType()
        {
            if (YamlNodes.Child(m_Document.Body, "script") is not YamlMappingNode script || YamlNodes.Child(script, "guid") is not { } guid
                || AssetLibrary.PathOf(m_Document.Scalar(guid)) is not { } path)
                return null;
            var type = ScriptTypes.OfScript(path, m_Document.Path);
            return typeof(ScriptedImporter).IsAssignableFrom(type) ? type : throw m_Document.Error(script, $"{type.FullName} is no ScriptedImporter");
        }

        /// <summary>Fills the importer's serialised fields.</summary>
        /// <exception cref="AssetFormatException">A field is unknown, or its value does not fit.</exception>
        internal void Fill(ScriptedImporter importer)
        {
            if (YamlNodes.Child(m_Document.Body, "userData") is { } userData)
                importer.userData = m_Document.Scalar(userData);
            new YamlFields(m_Document, new YamlReferences(new Dictionary<long, Object>()), true)
                .Read(importer, m_Document.Body.Children.Where(c => !s_Common.Contains(YamlNodes.Key(c))));
        }
    }
}
