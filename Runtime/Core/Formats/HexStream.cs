using System;
using System.IO;

namespace AnatomyCarve.Formats
{
    /// <summary>Reads bytes that are written as pairs of hexadecimal digits; blanks and line ends between digits are skipped.</summary>
    sealed class HexStream : Stream
    {
        readonly Stream text;
        readonly ReadContext context;
        readonly byte[] block = new byte[65536];
        int blockLength;
        int place;

        internal HexStream(Stream text, ReadContext context)
        {
            this.text = text;
            this.context = context;
        }

        /// <inheritdoc/>
        public override bool CanRead => true;

        /// <inheritdoc/>
        public override bool CanSeek => false;

        /// <inheritdoc/>
        public override bool CanWrite => false;

        /// <inheritdoc/>
        public override long Length => throw new NotSupportedException();

        /// <inheritdoc/>
        public override long Position
        {
            get => throw new NotSupportedException();
            set => throw new NotSupportedException();
        }

        /// <inheritdoc/>
        public override int Read(byte[] buffer, int offset, int count)
        {
            int done = 0;
            while (done < count)
            {
                int high = NextDigit();
                int low = high < 0 ? -1 : NextDigit();
                if (low < 0)
                    break;
                buffer[offset + done] = (byte)((high << 4) | low);
                done++;
            }

            return done;
        }

        /// <inheritdoc/>
        public override void Flush()
        {
        }

        /// <inheritdoc/>
        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        /// <inheritdoc/>
        public override void SetLength(long value) => throw new NotSupportedException();

        /// <inheritdoc/>
        public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();

        /// <summary>The next digit's value, or -1 at the end.</summary>
        int NextDigit()
        {
            while (true)
            {
                if (place == blockLength)
                {
                    blockLength = text.Read(block, 0, block.Length);
                    place = 0;
                    if (blockLength == 0)
                        return -1;
                }

                int letter = block[place++];
                if (letter >= '0' && letter <= '9')
                    return letter - '0';
                int lower = letter | 0x20;
                if (lower >= 'a' && lower <= 'f')
                    return lower - 'a' + 10;
                if (letter != ' ' && (letter < '\t' || letter > '\r'))
                    throw context.Refusal("the voxel data", $"the byte {letter} among hexadecimal digits", "0 to 9, a to f, blanks and line ends");
            }
        }
    }
}
