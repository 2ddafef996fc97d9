using System;
using System.IO;

namespace AnatomyCarve.Formats
{
    /// <summary>Memory as a stream that can be read and positioned: what <see cref="MemoryStream"/> is to arrays, for memory of any kind.</summary>
    sealed class MemoryContentStream : Stream
    {
        readonly ReadOnlyMemory<byte> content;
        long position;

        internal MemoryContentStream(ReadOnlyMemory<byte> content) => this.content = content;

        public override bool CanRead => true;

        public override bool CanSeek => true;

        public override bool CanWrite => false;

        public override long Length => content.Length;

        public override long Position
        {
            get => position;
            set => position = value >= 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "A position is 0 or more.");
        }

        public override int Read(Span<byte> buffer)
        {
            int count = (int)Math.Min(buffer.Length, Math.Max(0, Length - position));
            if (count == 0)
                return 0;
            content.Span.Slice((int)position, count).CopyTo(buffer);
            position += count;
            return count;
        }

        public override int Read(byte[] buffer, int offset, int count) => Read(buffer.AsSpan(offset, count));

        public override int ReadByte() => position < Length ? content.Span[(int)position++] : -1;

        public override long Seek(long offset, SeekOrigin origin)
        {
            long from = origin == SeekOrigin.Begin ? 0 : origin == SeekOrigin.Current ? position : Length;
            if (from + offset < 0)
                throw new IOException("A stream can't be positioned before its start.");
            return position = from + offset;
        }

        public override void Flush()
        {
        }

        public override void SetLength(long value) => throw new NotSupportedException("The content can only be read.");

        public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException("The content can only be read.");
    }
}
