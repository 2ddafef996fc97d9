using System;
using System.Collections.Generic;
using System.IO;
using System.Security.Cryptography;
using System.Text;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Scenes
{
    /// <summary>A folder of assets made for a test. A file's GUID is the hash of its path.</summary>
    sealed class Project : IDisposable
    {
        readonly HashSet<string> m_Scripts = new();

        internal Project() => Root = Directory.CreateTempSubdirectory("anatomycarve-project-").FullName;

        internal string Root { get; }

        /// <summary>Writes a file and its .meta.</summary>
        /// <returns>Its absolute path.</returns>
        internal string Write(string path, string text) => Write(path, Encoding.UTF8.GetBytes(text));

        internal string Write(string path, byte[] bytes, string importer = "")
        {
            var full = Path.Combine(Root, path);
            Directory.CreateDirectory(Path.GetDirectoryName(full));
            File.WriteAllBytes(full, bytes);
            File.WriteAllText(full + ".meta", $"fileFormatVersion: 2\nguid: {Guid(path)}\n{importer}");
            return full;
        }

        internal static string Guid(string path) => Convert.ToHexStringLower(MD5.HashData(Encoding.UTF8.GetBytes(path)));

        /// <summary>A reference to the script of a class, whose file is made if need be.</summary>
        internal string Script<T>()
        {
            var path = "Scripts/" + typeof(T).Name + ".cs";
            if (m_Scripts.Add(path))
                Write(path, $"namespace {typeof(T).Namespace} {{ }}");
            return $"{{fileID: 11500000, guid: {Guid(path)}, type: 3}}";
        }

        /// <summary>Makes the files known to the engine.</summary>
        internal void Open() => AssetLibrary.AddRoot(Root);

        public void Dispose() => Directory.Delete(Root, true);
    }
}
