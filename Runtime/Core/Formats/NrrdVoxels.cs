using System;
using System.IO;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>Reads the voxels behind an NRRD header, in whichever encoding it names.</summary>
    sealed class NrrdVoxels
    {
        readonly Stream stream;
        readonly NrrdHeader header;
        readonly ReadContext context;
        readonly VoxelType type;
        readonly long count;

        NrrdVoxels(Stream stream, NrrdHeader header, VoxelType type, long count, ReadContext context)
        {
            this.stream = stream;
            this.header = header;
            this.type = type;
            this.count = count;
            this.context = context;
        }

        long ByteCount => count * type.SizeOf();

        /// <summary>Reads the voxels.</summary>
        /// <param name="stream">Behind the header's empty line.</param>
        internal static Array Read(Stream stream, NrrdHeader header, VoxelType type, long count, ReadContext context) =>
            new NrrdVoxels(stream, header, type, count, context).Read();

        Array Read()
        {
            string encoding = header.Require("encoding").ToLowerInvariant();
            SkipLines(NrrdText.Whole(header, "line skip", 0, context));
            long byteSkip = NrrdText.Whole(header, "byte skip", 0, context);
            if (byteSkip < -1)
                throw context.Refusal("byte skip", $"{byteSkip}", "a number of bytes, or -1");
            switch (encoding)
            {
                case "raw":
                    return ReadRaw(byteSkip);
                case "gz":
                case "gzip":
                    return ReadGzip(byteSkip);
                case "hex":
                    return ReadHex(byteSkip);
                case "txt":
                case "text":
                case "ascii":
                    SkipBytes(stream, FromStart(byteSkip));
                    return TextVoxels.Read(stream, type, count, context);
                case "bz2":
                case "bzip2":
                    throw context.Refusal("encoding", $"{encoding}", "raw, gzip, ascii or hex: bzip2 is not read yet");
                default:
                    throw context.Refusal("encoding", $"\"{NrrdHeader.Excerpt(encoding)}\"", "raw, gzip, ascii or hex");
            }
        }

        Array ReadRaw(long byteSkip)
        {
            long present = stream.Length - stream.Position;
            if (byteSkip == -1 && present >= ByteCount)
                stream.Position = stream.Length - ByteCount;
            else if (byteSkip > 0)
                SkipBytes(stream, byteSkip);
            present = stream.Length - stream.Position;
            if (present > ByteCount)
                context.Warn($"{present - ByteCount} bytes follow behind the last voxel; they are ignored.");
            return VoxelBlocks.Read(stream, type, count, IsBigEndian(), present, true, context);
        }

        Array ReadGzip(long byteSkip)
        {
            long start = stream.Position;
            try
            {
                if (byteSkip == -1)
                {
                    byteSkip = Math.Max(0, InflatedSize() - ByteCount);
                    stream.Position = start;
                }

                long largest = GzipData.LargestInflatedSize(stream);
                using (Stream inflated = GzipData.Open(stream))
                {
                    SkipBytes(inflated, byteSkip);
                    Array voxels = VoxelBlocks.Read(inflated, type, count, IsBigEndian(), largest - byteSkip, false, context);
                    GzipData.CheckEnd(inflated, context);
                    return voxels;
                }
            }
            catch (InvalidDataException problem)
            {
                throw GzipData.Damaged(context, problem);
            }
        }

        Array ReadHex(long byteSkip)
        {
            long largest = (stream.Length - stream.Position) / 2;
            using (var bytes = new HexStream(stream, context))
            {
                SkipBytes(bytes, FromStart(byteSkip));
                return VoxelBlocks.Read(bytes, type, count, IsBigEndian(), largest, true, context);
            }
        }

        /// <summary>How much the gzip data at the stream's position inflate to; nothing of it is kept.</summary>
        long InflatedSize()
        {
            long size = 0;
            var block = new byte[65536];
            using (Stream inflated = GzipData.Open(stream))
            {
                int read;
                while ((read = inflated.Read(block, 0, block.Length)) > 0)
                {
                    context.Cancellation.ThrowIfCancellationRequested();
                    size += read;
                }
            }

            return size;
        }

        long FromStart(long byteSkip) =>
            byteSkip >= 0 ? byteSkip : throw context.Refusal("byte skip", $"-1", "a number of bytes in this encoding");

        void SkipBytes(Stream stream, long bytes)
        {
            if (!VolumeFile.Skip(stream, bytes, context))
                throw context.Refusal("byte skip", $"{bytes}", "a place inside the data");
        }

        void SkipLines(long lines)
        {
            if (lines < 0)
                throw context.Refusal("line skip", $"{lines}", "a number of lines");
            for (long line = 0; line < lines; line++)
            {
                int next;
                while ((next = stream.ReadByte()) != '\n')
                    if (next < 0)
                        throw context.Refusal("line skip", $"{lines}", "a number of lines that the file has");
            }
        }

        bool IsBigEndian()
        {
            string endian = type.SizeOf() == 1 ? "little" : header.Require("endian");
            switch (endian.ToLowerInvariant())
            {
                case "big":
                    return true;
                case "little":
                    return false;
                default:
                    throw context.Refusal("endian", $"\"{NrrdHeader.Excerpt(endian)}\"", "big or little");
            }
        }
    }
}
