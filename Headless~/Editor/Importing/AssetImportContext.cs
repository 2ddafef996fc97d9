using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor.AssetImporters
{
    /// <summary>What an importer works with: the file's path, and where the objects go that it makes.</summary>
    public class AssetImportContext
    {
        readonly List<(string Identifier, Object Object, Texture2D Thumbnail)> m_Objects = new();
        readonly List<ImportLog.ImportLogEntry> m_Log = new();
        readonly HashSet<string> m_Sources = new();

        internal AssetImportContext(string assetPath) => this.assetPath = assetPath;

        /// <summary>The file's path in the project.</summary>
        public string assetPath { get; }

        public Object mainObject { get; private set; }

        public BuildTarget selectedBuildTarget => BuildTarget.StandaloneLinux64;

        internal IReadOnlyList<(string Identifier, Object Object, Texture2D Thumbnail)> Objects => m_Objects;

        internal IReadOnlyList<ImportLog.ImportLogEntry> Log => m_Log;

        /// <summary>The other files, by their paths in the project, whose change imports this one anew.</summary>
        internal IReadOnlyCollection<string> Sources => m_Sources;

        public void AddObjectToAsset(string identifier, Object obj) => AddObjectToAsset(identifier, obj, null);

        /// <summary>Puts an object into the asset.</summary>
        /// <param name="identifier">Fixes the object's fileID: unique within the asset, and the same in every import.</param>
        /// <param name="obj">An object that is in no asset yet.</param>
        /// <param name="thumbnail">Its icon; null for the class's.</param>
        /// <exception cref="ArgumentException">The object is null, or the identifier is used already: Unity would make it unique by order.</exception>
        public void AddObjectToAsset(string identifier, Object obj, Texture2D thumbnail)
        {
            if (obj == null)
                throw new ArgumentNullException(nameof(obj), "Cannot add a null object : " + (identifier ?? "<null>"));
            if (string.IsNullOrEmpty(identifier) || m_Objects.Any(o => o.Identifier == identifier))
                throw new ArgumentException($"{assetPath}: identifier '{identifier}' is empty or used already", nameof(identifier));
            if (obj.IsAsset || m_Objects.Any(o => ReferenceEquals(o.Object, obj)))
                throw new ArgumentException($"{assetPath}: '{obj.name}' is in an asset already", nameof(obj));
            m_Objects.Add((identifier, obj, thumbnail));
        }

        /// <summary>Chooses what the asset as a whole stands for.</summary>
        /// <exception cref="ArgumentException">The object was not added.</exception>
        public void SetMainObject(Object obj)
        {
            if (obj != null && !m_Objects.Any(o => ReferenceEquals(o.Object, obj)))
                throw new ArgumentException($"{assetPath}: the main object has to be added first", nameof(obj));
            mainObject = obj;
        }

        public void GetObjects(List<Object> objects)
        {
            if (objects == null)
                throw new ArgumentNullException(nameof(objects));
            objects.Clear();
            objects.AddRange(m_Objects.Select(o => o.Object));
        }

        /// <summary>Another file was read, or looked for: when it comes, changes or goes, this asset is imported anew.</summary>
        public void DependsOnSourceAsset(string path)
        {
            if (string.IsNullOrEmpty(path))
                throw new ArgumentNullException(nameof(path), "Cannot add dependency on invalid path.");
            m_Sources.Add(path);
        }

        public void LogImportError(string msg, Object obj = null) => AddToLog(msg, obj, ImportLogFlags.Error);

        public void LogImportWarning(string msg, Object obj = null) => AddToLog(msg, obj, ImportLogFlags.Warning);

        void AddToLog(string message, Object context, ImportLogFlags flags)
        {
            m_Log.Add(new ImportLog.ImportLogEntry { message = message, context = context, flags = flags, file = "", line = 0 });
            if (flags == ImportLogFlags.Error)
                Debug.LogError(message, context);
            else
                Debug.LogWarning(message, context);
        }
    }
}
