using System;
using Object = UnityEngine.Object;

namespace UnityEditor.AssetImporters
{
    /// <summary>How bad an entry of an import's log is.</summary>
    [Flags]
    public enum ImportLogFlags
    {
        None = 0,
        Error = 64,
        Warning = 128,
    }

    /// <summary>What an import said.</summary>
    public sealed class ImportLog : Object
    {
        public ImportLog()
        {
        }

        public ImportLogEntry[] logEntries { get; internal set; } = Array.Empty<ImportLogEntry>();

        /// <summary>One sentence.</summary>
        public struct ImportLogEntry
        {
            public string message;
            public ImportLogFlags flags;
            public int line;
            public string file;

            public Object context { get; set; }
        }
    }
}
