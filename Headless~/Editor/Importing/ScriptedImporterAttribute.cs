using System;
using System.Linq;

namespace UnityEditor.AssetImporters
{
    /// <summary>Which files an importer takes, and the version of what it makes: a higher one imports all of them anew.</summary>
    [AttributeUsage(AttributeTargets.Class, Inherited = false)]
    public class ScriptedImporterAttribute : Attribute
    {
        public bool AllowCaching;

        public ScriptedImporterAttribute(int version, string ext) : this(version, new[] { ext }, null, 0)
        {
        }

        public ScriptedImporterAttribute(int version, string ext, int importQueueOffset) : this(version, new[] { ext }, null, importQueueOffset)
        {
        }

        public ScriptedImporterAttribute(int version, string[] exts) : this(version, exts, null, 0)
        {
        }

        public ScriptedImporterAttribute(int version, string[] exts, int importQueueOffset) : this(version, exts, null, importQueueOffset)
        {
        }

        public ScriptedImporterAttribute(int version, string[] exts, string[] overrideExts) : this(version, exts, overrideExts, 0)
        {
        }

        /// <param name="version">The version.</param>
        /// <param name="exts">The extensions that it takes by default, without a dot.</param>
        /// <param name="overrideExts">The extensions for which it can be chosen.</param>
        /// <param name="importQueueOffset">Later imports have higher ones.</param>
        public ScriptedImporterAttribute(int version, string[] exts, string[] overrideExts, int importQueueOffset)
        {
            this.version = version;
            importQueuePriority = importQueueOffset;
            fileExtensions = Trimmed(exts);
            overrideFileExtensions = Trimmed(overrideExts);
        }

        public int version { get; }

        public int importQueuePriority { get; }

        public string[] fileExtensions { get; }

        public string[] overrideFileExtensions { get; }

        static string[] Trimmed(string[] extensions) => (extensions ?? Array.Empty<string>()).Select(e => e.Trim('.')).ToArray();
    }
}
