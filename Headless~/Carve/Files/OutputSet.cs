using System;
using System.Collections.Generic;
using System.IO;

namespace AnatomyCarve.Headless.Cli.Files
{
    /// <summary>
    /// Files that appear together or not at all: each is written under a temporary name beside its own, and they get their names when
    /// <see cref="Commit"/> is called. What was not committed is deleted.
    /// </summary>
    sealed class OutputSet : IDisposable
    {
        readonly List<(string Temporary, string Final)> files = [];

        /// <exception cref="IOException">The folder does not exist, or the path is a folder's.</exception>
        public void Add(string path, Action<Stream> write)
        {
            Check(path);
            var final = Path.GetFullPath(path);
            var temporary = Path.Combine(Path.GetDirectoryName(final)!, $".{Path.GetFileName(final)}.{Guid.NewGuid():N}.part");
            files.Add((temporary, final));
            using var stream = new FileStream(temporary, FileMode.CreateNew, FileAccess.Write);
            write(stream);
        }

        /// <summary>Fails early where a file could not be written later.</summary>
        /// <exception cref="IOException">The folder does not exist, or the path is a folder's.</exception>
        public static void Check(string path)
        {
            var final = Path.GetFullPath(path);
            if (Directory.Exists(final)) throw new IOException($"{path}: this is a folder, not a file to write.");
            if (!Directory.Exists(Path.GetDirectoryName(final))) throw new IOException($"{path}: its folder does not exist.");
        }

        public void Commit()
        {
            foreach (var (temporary, final) in files) File.Move(temporary, final, overwrite: true);
            files.Clear();
        }

        public void Dispose()
        {
            foreach (var (temporary, _) in files) File.Delete(temporary);
            files.Clear();
        }
    }
}
