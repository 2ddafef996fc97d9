using System;
using System.IO;
using System.Security;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>Opens files and turns what the file system says into the package's own exception.</summary>
    static class VolumeFile
    {
        const int BufferBytes = 65536;

        /// <summary>Opens a file, reads from it, closes it.</summary>
        /// <exception cref="VolumeFormatException">The file is missing or can't be read.</exception>
        internal static T Read<T>(string path, Func<Stream, T> read)
        {
            if (string.IsNullOrEmpty(path))
                throw new ArgumentException("A path is needed.", nameof(path));
            try
            {
                using (var stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read, BufferBytes, FileOptions.SequentialScan))
                    return read(stream);
            }
            catch (Exception problem) when (problem is FileNotFoundException || problem is DirectoryNotFoundException)
            {
                throw new VolumeFormatException(path, "the file", "not there", "a file that can be read", problem);
            }
            catch (Exception problem) when (problem is IOException || problem is UnauthorizedAccessException || problem is SecurityException)
            {
                throw new VolumeFormatException(path, "the file", "unreadable (" + problem.Message + ")", "a file that can be read", problem);
            }
        }

        /// <summary>Throws when a stream can't be used by the readers.</summary>
        internal static void CheckStream(Stream stream)
        {
            if (!(stream ?? throw new ArgumentNullException(nameof(stream))).CanRead || !stream.CanSeek)
                throw new ArgumentException("A volume is read from a stream that can be read and positioned (copy it into a MemoryStream first).", nameof(stream));
        }

        /// <summary>Reads until a buffer is full or the stream ends.</summary>
        /// <returns>The number of bytes read.</returns>
        internal static int ReadFully(Stream stream, Span<byte> buffer)
        {
            int filled = 0;
            while (filled < buffer.Length)
            {
                int read = stream.Read(buffer.Slice(filled));
                if (read == 0)
                    break;
                filled += read;
            }

            return filled;
        }

        /// <summary>Reads bytes that are not wanted.</summary>
        /// <returns>False when the stream ended before.</returns>
        internal static bool Skip(Stream stream, long bytes, ReadContext context)
        {
            var buffer = new byte[(int)Math.Min(bytes, BufferBytes)];
            while (bytes > 0)
            {
                context.Cancellation.ThrowIfCancellationRequested();
                int read = stream.Read(buffer, 0, (int)Math.Min(bytes, buffer.Length));
                if (read == 0)
                    return false;
                bytes -= read;
            }

            return true;
        }
    }
}
