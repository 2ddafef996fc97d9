using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;

namespace AnatomyCarve.Headless.Cli.Files
{
    /// <summary>
    /// Files that appear together or not at all: each is written under a temporary name beside its own, and they get their names when
    /// <see cref="Commit"/> is called. What was not committed is deleted, also when the process is interrupted.
    /// </summary>
    sealed class OutputSet : IDisposable
    {
        // Held while files are made, named or deleted, so that an interrupt comes before or after, never in between.
        static readonly Lock Gate = new();
        static readonly List<OutputSet> Open = [];
        static bool isAnyCommitted;

        readonly List<(string Temporary, string Final)> files = [];

        public OutputSet()
        {
            lock (Gate) Open.Add(this);
        }

        /// <exception cref="IOException">The file can't be written.</exception>
        public void Add(string path, Action<Stream> write)
        {
            Check(path);
            var final = Path.GetFullPath(path);
            var temporary = TemporaryFor(final);
            try
            {
                using var stream = Create(temporary, final);
                write(stream);
            }
            catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
            {
                throw new IOException($"{path}: it could not be written: {exception.Message.Replace(temporary, path, StringComparison.Ordinal)}", exception);
            }
        }

        /// <summary>Fails early where a file could not be written later.</summary>
        /// <exception cref="IOException">The folder does not exist or takes no new files, or the path is a folder's.</exception>
        public static void Check(string path)
        {
            var final = Path.GetFullPath(path);
            if (Directory.Exists(final)) throw new IOException($"{path}: this is a folder, not a file to write.");
            if (!Directory.Exists(Path.GetDirectoryName(final))) throw new IOException($"{path}: its folder does not exist.");
            try
            {
                var temporary = TemporaryFor(final);
                lock (Gate)
                {
                    using (File.Create(temporary))
                    {
                    }

                    File.Delete(temporary);
                }
            }
            catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
            {
                throw new IOException($"{path}: it can't be written; no file can be made in its folder.", exception);
            }
        }

        /// <summary>
        /// Deletes what is not committed yet and ends the process by <paramref name="exit"/>; nothing of the kind if files have their names
        /// already, for then the command is as good as done.
        /// </summary>
        public static void Interrupt(Action exit)
        {
            lock (Gate)
            {
                if (isAnyCommitted) return;
                foreach (var set in Open) set.Delete();
                exit();
            }
        }

        public void Commit()
        {
            lock (Gate)
            {
                foreach (var (temporary, final) in files)
                {
                    File.Move(temporary, final, overwrite: true);
                    isAnyCommitted = true;
                }

                files.Clear();
            }
        }

        public void Dispose()
        {
            lock (Gate)
            {
                Open.Remove(this);
                Delete();
            }
        }

        static string TemporaryFor(string final) => Path.Combine(Path.GetDirectoryName(final)!, $".{Path.GetFileName(final)}.{Guid.NewGuid():N}.part");

        FileStream Create(string temporary, string final)
        {
            lock (Gate)
            {
                files.Add((temporary, final));
                return new FileStream(temporary, FileMode.CreateNew, FileAccess.Write, FileShare.Delete);
            }
        }

        void Delete()
        {
            foreach (var (temporary, _) in files) File.Delete(temporary);
            files.Clear();
        }
    }
}
