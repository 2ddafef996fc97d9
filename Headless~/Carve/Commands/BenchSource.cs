using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.IO;
using System.Linq;
using AnatomyCarve.Headless.Cli.Bench;
using AnatomyCarve.Headless.Cli.Files;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>The arguments that say which volume a bench takes: files, or a phantom of a size.</summary>
    sealed class BenchSource
    {
        const int LongestSide = 2048;

        readonly record struct PhantomSize(int I, int J, int K);

        readonly string name;

        readonly Argument<string> volume = new("VOLUME")
        {
            Description = "The intensities, CT or MRI: .nii, .nii.gz or .nrrd. Or --phantom.",
            Arity = ArgumentArity.ZeroOrOne,
        };

        readonly Option<string> labels = new("--labels") { HelpName = "FILE", Description = "The segmentation on the same grid." };

        readonly Option<PhantomSize?> phantom = new("--phantom")
        {
            HelpName = "IxJxK",
            CustomParser = ParseSizes,
            Description = "Instead of files: a made-up CT of this size with noise and 40 segments, as gzipped NRRD; 441x321x215, for example.",
        };

        /// <param name="name">the bench's name, for messages</param>
        public BenchSource(string name) => this.name = name;

        public void AddTo(Command command)
        {
            command.Arguments.Add(volume);
            command.Options.Add(labels);
            command.Options.Add(phantom);
            command.Validators.Add(result =>
            {
                var isPhantom = result.GetResult(phantom) != null;
                if (result.GetValue(volume) == null == !isPhantom) result.AddError($"bench {name}: expected either a VOLUME or --phantom.");
                if (isPhantom && result.GetValue(labels) != null) result.AddError("--labels: the phantom has its own.");
            });
        }

        /// <summary>Reads the files, or makes the phantom. Labels may be null.</summary>
        public (NamedContent Scan, NamedContent Labels) Read(ParseResult parsed)
        {
            if (parsed.GetValue(phantom) is not { } size)
            {
                return (ReadContent(parsed.GetValue(volume)), parsed.GetValue(labels) is { } path ? ReadContent(path) : null);
            }

            var (scan, segmentation) = CtPhantom.Make(size.I, size.J, size.K);
            return (new NamedContent("phantom.nrrd", scan), new NamedContent("phantom labels.nrrd", segmentation));
        }

        static NamedContent ReadContent(string path)
        {
            InputFile.Check(path);
            return new NamedContent(path, File.ReadAllBytes(path));
        }

        static PhantomSize? ParseSizes(ArgumentResult result)
        {
            var text = result.Tokens[0].Value;
            var sizes = text.Split('x').Select(side => int.TryParse(side, NumberStyles.None, CultureInfo.InvariantCulture, out var number) ? number : 0).ToArray();
            if (sizes.Length == 3 && sizes.All(side => side is >= 1 and <= LongestSide) && (long)sizes[0] * sizes[1] * sizes[2] <= 1 << 28)
            {
                return new PhantomSize(sizes[0], sizes[1], sizes[2]);
            }

            result.AddError($"--phantom \"{text}\": expected IxJxK with sides from 1 to {LongestSide} and at most 2^28 voxels, for example 441x321x215.");
            return null;
        }
    }
}
