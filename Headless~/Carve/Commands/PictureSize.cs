using System.CommandLine.Parsing;
using System.Globalization;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>A picture's size in pixels.</summary>
    readonly record struct PictureSize(int Width, int Height)
    {
        /// <summary>The longest side; larger pictures are beyond what the graphics APIs guarantee for a texture.</summary>
        public const int Longest = 16384;

        public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{Width}x{Height}");

        /// <summary>Parses "WIDTHxHEIGHT".</summary>
        public static PictureSize Parse(ArgumentResult result)
        {
            var text = result.Tokens[0].Value;
            var sides = text.Split('x');
            if (sides.Length == 2 && TryParseSide(sides[0], out var width) && TryParseSide(sides[1], out var height))
            {
                return new PictureSize(width, height);
            }

            result.AddError($"--size \"{text}\": expected WIDTHxHEIGHT with sides from 1 to {Longest}, for example 512x512.");
            return default;
        }

        static bool TryParseSide(string text, out int side) =>
            int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out side) && side is >= 1 and <= Longest;
    }
}
