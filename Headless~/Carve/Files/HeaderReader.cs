using System;
using System.Globalization;
using System.IO;
using System.Text;

namespace AnatomyCarve.Headless.Cli.Files
{
    /// <summary>The words of a portable map's header, comments left out, and the bytes after it.</summary>
    sealed class HeaderReader(string path)
    {
        const int LargestSize = 32768;
        readonly byte[] bytes = File.ReadAllBytes(path);
        int position;

        public string Word()
        {
            var word = new StringBuilder();
            for (; position < bytes.Length && word.Length < 32; position++)
            {
                var letter = (char)bytes[position];
                if (letter == '#')
                {
                    while (position < bytes.Length && bytes[position] != '\n') position++;
                }
                else if (!char.IsWhiteSpace(letter))
                {
                    word.Append(letter);
                }
                else if (word.Length > 0)
                {
                    position++;
                    break;
                }
            }

            return word.ToString();
        }

        public int Size(string name)
        {
            var word = Word();
            return int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out var size) && size is > 0 and <= LargestSize
                ? size
                : throw Refusal($"its {name} is \"{word}\", not a number from 1 to {LargestSize}");
        }

        public ReadOnlySpan<byte> Rest(long expected) => bytes.Length - position == expected
            ? bytes.AsSpan(position)
            : throw Refusal($"{bytes.Length - position} bytes of pixels instead of {expected}");

        public PictureFileException Refusal(string reason) => new(path, reason);
    }
}
