using System;
using System.IO;
using System.Text;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// Carving files: JSON, UTF-8, <c>{"version": 1, "space": "LPS", "spheres": [{"centerMm": [x, y, z], "radiusMm": r, "clipped": [{"label": 5, "name":
    /// "liver"}]}]}</c>. The fixed spheres come first, oldest first; the one in the hand, if there is one, comes last and says <c>"active": true</c>.
    /// "RAS" is understood on reading. Numbers keep every bit but the sign of zero.
    /// </summary>
    public static class CarvingFile
    {
        /// <summary>The version that is written and read.</summary>
        public const int Version = 1;

        /// <summary>Reads a carving file.</summary>
        /// <param name="path">The file.</param>
        /// <exception cref="ArgumentNullException"><paramref name="path"/> is null.</exception>
        /// <exception cref="CarvingFileException">The file cannot be read, or is no carving file of this version.</exception>
        public static CarvingDocument Read(string path)
        {
            if (path == null)
                throw new ArgumentNullException(nameof(path));
            try
            {
                using var reader = new StreamReader(path, new UTF8Encoding(false, true));
                return CarvingFileReader.Read(reader, path);
            }
            catch (Exception problem) when (IsFileProblem(problem))
            {
                throw new CarvingFileException(path, "the file", "not readable (" + problem.Message.TrimEnd('.') + ")", "a carving file", problem);
            }
        }

        /// <summary>Reads the text of a carving file.</summary>
        /// <param name="json">The text.</param>
        /// <param name="name">What stands for the file's name in messages.</param>
        /// <exception cref="ArgumentNullException"><paramref name="json"/> is null.</exception>
        /// <exception cref="CarvingFileException">The text is no carving file of this version.</exception>
        public static CarvingDocument Parse(string json, string name = "carving")
        {
            using var reader = new StringReader(json ?? throw new ArgumentNullException(nameof(json)));
            return CarvingFileReader.Read(reader, name);
        }

        /// <summary>The text of a carving file.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="document"/> is null.</exception>
        public static string Format(CarvingDocument document)
        {
            using var writer = new StringWriter { NewLine = "\n" };
            CarvingFileWriter.Write(document ?? throw new ArgumentNullException(nameof(document)), writer);
            return writer.ToString();
        }

        /// <summary>
        /// Writes a carving file: first beside it, then in its place, so that a failure leaves the old file whole. The folder must exist.
        /// </summary>
        /// <param name="document">What to write.</param>
        /// <param name="path">The file; an existing one is replaced.</param>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        /// <exception cref="CarvingFileException">The file cannot be written.</exception>
        public static void Write(CarvingDocument document, string path)
        {
            if (path == null)
                throw new ArgumentNullException(nameof(path));
            string text = Format(document);
            string temporary = path + "." + Guid.NewGuid().ToString("N") + ".tmp";
            try
            {
                WriteThrough(temporary, text);
                if (File.Exists(path))
                    File.Replace(temporary, path, null);
                else
                    File.Move(temporary, path);
            }
            catch (Exception problem) when (IsFileProblem(problem))
            {
                throw new CarvingFileException(path, "the file", "not writable (" + problem.Message.TrimEnd('.') + ")", "a place to write to", problem);
            }
            finally
            {
                if (File.Exists(temporary))
                    File.Delete(temporary);
            }
        }

        static void WriteThrough(string path, string text)
        {
            byte[] bytes = new UTF8Encoding(false).GetBytes(text);
            using var stream = new FileStream(path, FileMode.CreateNew, FileAccess.Write);
            stream.Write(bytes, 0, bytes.Length);
            stream.Flush(true);
        }

        static bool IsFileProblem(Exception problem) =>
            problem is IOException || problem is UnauthorizedAccessException || problem is ArgumentException || problem is NotSupportedException;
    }
}
