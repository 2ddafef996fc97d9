using System;
using System.IO;
using System.Text;
using System.Threading;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>Reads a volume in whichever format its content shows: NIfTI-1 or NRRD. The file's name plays no part.</summary>
    public static class VolumeReader
    {
        /// <summary>So many bytes tell every format: DICOM has its mark at 128.</summary>
        const int StartBytes = 352;

        /// <summary>Reads a file.</summary>
        /// <param name="path">The file.</param>
        /// <param name="cancellation">Cancels the work.</param>
        /// <param name="progress">Told the share done, 0 to 1; may be null.</param>
        /// <exception cref="VolumeFormatException">The file can't be read; says what stands where, and what was expected.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public static VolumeData Read(string path, CancellationToken cancellation = default, IProgress<float> progress = null) =>
            VolumeFile.Read(path, stream => Read(stream, path, cancellation, progress));

        /// <summary>Reads from a stream, from its position on.</summary>
        /// <param name="stream">Can be read and positioned; stays open.</param>
        /// <param name="name">What messages call it.</param>
        /// <param name="cancellation">Cancels the work.</param>
        /// <param name="progress">Told the share done, 0 to 1; may be null.</param>
        /// <exception cref="VolumeFormatException">The data can't be read; says what stands where, and what was expected.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public static VolumeData Read(Stream stream, string name, CancellationToken cancellation = default, IProgress<float> progress = null)
        {
            switch (FormatOf(stream, name))
            {
                case Content.Nrrd:
                    return NrrdReader.Read(stream, name, cancellation, progress);
                default:
                    return NiftiReader.Read(stream, name, cancellation, progress);
            }
        }

        /// <summary>Reads what a file's header says, without its voxels.</summary>
        /// <param name="path">The file.</param>
        /// <exception cref="VolumeFormatException">The header can't be read; says what stands where, and what was expected.</exception>
        public static VolumeFileInfo ReadInfo(string path) => VolumeFile.Read(path, stream => ReadInfo(stream, path));

        /// <summary>Reads what the header of a file's content says, without its voxels.</summary>
        /// <param name="content">All bytes of the file.</param>
        /// <param name="name">What messages call it.</param>
        /// <exception cref="VolumeFormatException">The header can't be read; says what stands where, and what was expected.</exception>
        public static VolumeFileInfo ReadInfo(ReadOnlyMemory<byte> content, string name)
        {
            using (var stream = new MemoryContentStream(content))
                return ReadInfo(stream, name);
        }

        static VolumeFileInfo ReadInfo(Stream stream, string name)
        {
            switch (FormatOf(stream, name))
            {
                case Content.Nrrd:
                    return NrrdReader.ReadInfo(stream, new ReadContext(name, "NRRD", default, null));
                default:
                    return NiftiReader.ReadInfo(stream, new ReadContext(name, "NIfTI-1", default, null));
            }
        }

        /// <summary>NRRD or NIfTI; refuses everything else.</summary>
        static Content FormatOf(Stream stream, string name)
        {
            VolumeFile.CheckStream(stream);
            byte[] start = Start(stream, name);
            Content content = Recognise(start);
            switch (content)
            {
                case Content.Nrrd:
                case Content.Nifti:
                    return content;
                case Content.MetaImage:
                    throw new VolumeFormatException(name, "the format", "MetaImage", "NIfTI-1 or NRRD: MetaImage is not read yet");
                case Content.Dicom:
                    throw new VolumeFormatException(name, "the format", "DICOM", "NIfTI-1 or NRRD: DICOM is not read directly, convert the series first");
                default:
                    throw new VolumeFormatException(
                        name, "the file's start", start.Length == 0 ? "missing (the file is empty)" : "\"" + Printable(start) + "\"", "the header of NIfTI-1 (.nii, .nii.gz) or NRRD (.nrrd)");
            }
        }

        /// <summary>Reads a file's content from memory. Nothing is copied, and nothing keeps the memory when the call ends.</summary>
        /// <param name="content">All bytes of the file.</param>
        /// <param name="name">What messages call it.</param>
        /// <param name="cancellation">Cancels the work.</param>
        /// <param name="progress">Told the share done, 0 to 1; may be null.</param>
        /// <exception cref="VolumeFormatException">The data can't be read; says what stands where, and what was expected.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public static VolumeData Read(
            ReadOnlyMemory<byte> content, string name, CancellationToken cancellation = default, IProgress<float> progress = null)
        {
            using (var stream = new MemoryContentStream(content))
                return Read(stream, name, cancellation, progress);
        }

        /// <summary>True when a file is there and starts as NIfTI or NRRD do; says nothing of the rest of it.</summary>
        public static bool CanRead(string path)
        {
            try
            {
                Content content = VolumeFile.Read(path, stream => Recognise(Start(stream, path)));
                return content == Content.Nrrd || content == Content.Nifti;
            }
            catch (VolumeFormatException)
            {
                return false;
            }
        }

        /// <summary>True when a file's content starts as NIfTI or NRRD do; says nothing of the rest of it.</summary>
        public static bool CanRead(ReadOnlyMemory<byte> content)
        {
            try
            {
                Content found;
                using (var stream = new MemoryContentStream(content))
                    found = Recognise(Start(stream, "content"));
                return found == Content.Nrrd || found == Content.Nifti;
            }
            catch (VolumeFormatException)
            {
                return false;
            }
        }

        /// <summary>The first bytes, inflated where they are gzip data; the stream's position stays.</summary>
        static byte[] Start(Stream stream, string name)
        {
            long position = stream.Position;
            var start = new byte[StartBytes];
            int length;
            try
            {
                if (GzipData.StartsAt(stream))
                    using (Stream inflated = GzipData.Open(stream))
                        length = VolumeFile.ReadFully(inflated, start);
                else
                    length = VolumeFile.ReadFully(stream, start);
            }
            catch (InvalidDataException problem)
            {
                throw new VolumeFormatException(name, "the gzip data", "damaged or cut off", "an intact gzip stream", problem);
            }

            stream.Position = position;
            Array.Resize(ref start, length);
            return start;
        }

        static Content Recognise(byte[] start)
        {
            string text = Encoding.ASCII.GetString(start);
            if (text.StartsWith("NRRD", StringComparison.Ordinal))
                return Content.Nrrd;

            // A damaged header may still show one of both marks; the reader then says what is wrong with the other.
            int size = start.Length >= 4 ? NiftiHeader.SizeOf(start) : 0;
            bool magic = start.Length >= NiftiHeader.Size && (Has(text, NiftiHeader.Size - 4, "n+1") || Has(text, NiftiHeader.Size - 4, "ni1"));
            if (size == NiftiHeader.Size || size == NiftiHeader.Size2 || magic)
                return Content.Nifti;
            if (text.StartsWith("ObjectType", StringComparison.Ordinal) || text.StartsWith("NDims", StringComparison.Ordinal))
                return Content.MetaImage;
            return Has(text, 128, "DICM") ? Content.Dicom : Content.Unknown;
        }

        static bool Has(string text, int place, string mark) =>
            text.Length >= place + mark.Length && string.CompareOrdinal(text, place, mark, 0, mark.Length) == 0;

        static string Printable(byte[] start)
        {
            var text = new StringBuilder();
            for (int n = 0; n < Math.Min(16, start.Length); n++)
                text.Append(start[n] >= ' ' && start[n] < 0x7F ? (char)start[n] : '?');
            return text.ToString();
        }

        enum Content
        {
            Unknown,
            Nrrd,
            Nifti,
            MetaImage,
            Dicom,
        }
    }
}
