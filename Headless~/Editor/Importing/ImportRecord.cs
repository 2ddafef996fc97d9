using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEditor.AssetImporters;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    /// <summary>One file's importer with its settings, and what its last import was made from.</summary>
    sealed class ImportRecord : IDisposable
    {
        readonly string m_Path;
        readonly Dictionary<string, Stamp> m_Sources = new();

        /// <exception cref="AssetFormatException">The .meta has settings that the importer does not.</exception>
        internal ImportRecord(string path, Type type)
        {
            m_Path = path;
            Importer = (ScriptedImporter)ComponentFactory.Construct(type);
            Importer.assetPath = AssetFiles.ProjectPath(path);
            Log = new ImportLog();
            try
            {
                var meta = MetaSettings.Of(path);
                Importer.importSettingsMissing = meta == null;
                meta?.Fill(Importer);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        internal ScriptedImporter Importer { get; }

        internal ImportLog Log { get; }

        internal bool IsOutdated => m_Sources.Any(s => !Stamp.Of(s.Key).Equals(s.Value));

        /// <summary>Runs the importer. What it throws is logged, and the asset is left without objects, as in Unity.</summary>
        internal void Import(AssetObjects objects)
        {
            var context = new AssetImportContext(Importer.assetPath);
            var succeeded = LogRouter.Guard(() => Importer.OnImportAsset(context));
            Remember(context);
            if (!succeeded)
            {
                foreach (var (_, half, _) in context.Objects)
                    half.Kill();
                return;
            }

            foreach (var (identifier, made, _) in context.Objects)
                AssetLibrary.Enter(objects, ImportedFileIds.Of(made, identifier), made, made.name);
            objects.Main = context.mainObject;
            if (context.mainObject is not null)
                context.mainObject.NativeName = Path.GetFileNameWithoutExtension(m_Path);
            else if (context.Objects.Count > 0)
                Debug.LogError($"{Importer.assetPath}: {Importer.GetType().Name} sets no main object");
        }

        public void Dispose()
        {
            Importer.Kill();
            Log.Kill();
        }

        void Remember(AssetImportContext context)
        {
            Log.logEntries = context.Log.ToArray();
            m_Sources.Clear();
            foreach (var source in new[] { m_Path, m_Path + ".meta" }.Concat(context.Sources.Select(AssetFiles.FullPath)).Where(p => p != null))
                m_Sources[source] = Stamp.Of(source);
        }

        /// <summary>By what a file's change is recognised.</summary>
        readonly struct Stamp : IEquatable<Stamp>
        {
            readonly long m_Length;
            readonly DateTime m_Written;

            Stamp(long length, DateTime written)
            {
                m_Length = length;
                m_Written = written;
            }

            internal static Stamp Of(string path) =>
                new FileInfo(path) is { Exists: true } info ? new Stamp(info.Length, info.LastWriteTimeUtc) : new Stamp(-1, default);

            public bool Equals(Stamp other) => m_Length == other.m_Length && m_Written == other.m_Written;

            public override bool Equals(object obj) => obj is Stamp other && Equals(other);

            public override int GetHashCode() => HashCode.Combine(m_Length, m_Written);
        }
    }
}
