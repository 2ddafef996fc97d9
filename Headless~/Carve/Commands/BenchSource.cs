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
        readonly string name;

        readonly Argument<string> volume = new("VOLUME")
        {
            Description = "The intensities, CT or MRI: .nii, .nii.gz or .nrrd. Or --phantom.",
            Arity = ArgumentArity.ZeroOrOne,
        };

        readonly Option<string> labels = new("--labels") { HelpName = "FILE", Description = "The segmentation on the same grid." };

        readonly Option<PhantomSize?> phantom = PhantomSize.Option();

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

            return size.Make();
        }

        static NamedContent ReadContent(string path)
        {
            InputFile.Check(path);
            return new NamedContent(path, File.ReadAllBytes(path));
        }
    }
}
