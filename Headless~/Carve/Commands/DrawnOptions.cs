using System.CommandLine;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>Options of what a camera draws.</summary>
    sealed class DrawnOptions
    {
        readonly ProjectOptions project = new();

        public Option<string> Picture { get; } = RenderCommand.FileOption("--drawn",
            "Also write what a camera draws there, by the eye shader, as Unity would show it: PNG, the top row first.", ".png");

        public Option<string> Depth { get; } = RenderCommand.FileOption("--drawn-depth",
            "Also write the depth that it leaves for other objects of the scene: PFM as --depth; veils that are no visible segment have a depth too.", ".pfm");

        public void AddTo(Command command)
        {
            command.Options.Add(Picture);
            command.Options.Add(Depth);
            project.AddTo(command);
            command.Options.Add(project.Layout);
        }

        public RenderProject Project(ParseResult parsed, PictureSize size) => project.Read(parsed, size);
    }
}
