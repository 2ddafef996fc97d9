using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Linq;

namespace AnatomyCarve.Headless.Cli.Bench
{
    /// <summary>Voxels of a <see cref="CtPhantom"/> along its axes.</summary>
    readonly record struct PhantomSize(int I, int J, int K)
    {
        const int LongestSide = 2048;
        const long MostVoxels = 1 << 28;

        public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{I}x{J}x{K}");

        /// <summary>Makes the phantom.</summary>
        public (NamedContent Scan, NamedContent Labels) Make()
        {
            var (scan, labels) = CtPhantom.Make(I, J, K);
            return (new NamedContent("phantom.nrrd", scan), new NamedContent("phantom labels.nrrd", labels));
        }

        /// <summary>--phantom.</summary>
        public static Option<PhantomSize?> Option() => new("--phantom")
        {
            HelpName = "IxJxK",
            CustomParser = Parse,
            Description = "Instead of files: a made-up CT of this size with noise and 40 segments, as gzipped NRRD; 441x321x215, for example.",
        };

        static PhantomSize? Parse(ArgumentResult result)
        {
            var text = result.Tokens[0].Value;
            var sizes = text.Split('x').Select(side => int.TryParse(side, NumberStyles.None, CultureInfo.InvariantCulture, out var number) ? number : 0).ToArray();
            if (sizes.Length == 3 && sizes.All(side => side is >= 1 and <= LongestSide) && (long)sizes[0] * sizes[1] * sizes[2] <= MostVoxels)
            {
                return new PhantomSize(sizes[0], sizes[1], sizes[2]);
            }

            result.AddError($"--phantom \"{text}\": expected IxJxK with sides from 1 to {LongestSide} and at most 2^28 voxels, for example 441x321x215.");
            return null;
        }
    }
}
