using System.CommandLine;
using System.Globalization;
using System.Threading.Tasks;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>carve scene: its options.</summary>
    static class SceneCommand
    {
        const int MostFrames = 100_000;

        public static Command Create()
        {
            var scene = new Argument<string>("SCENE") { Description = "A scene of Unity: .unity, as text, in the package or in a sample." };
            var output = RenderCommand.FileOption("--output", "What the scene's cameras show at the end: PNG, the top row first. No user interface is drawn.", ".png");
            output.Required = true;
            var size = new Option<PictureSize>("--size")
            {
                HelpName = "WIDTHxHEIGHT",
                CustomParser = PictureSize.Parse,
                DefaultValueFactory = _ => new PictureSize(1280, 720),
                Description = "The window's size in pixels, or an eye's.",
            };
            var frames = new Option<int>("--frames")
            {
                HelpName = "N",
                DefaultValueFactory = _ => 3,
                Description = "How many frames are played once all volumes of the scene are loaded.",
            };
            frames.Validators.Add(result =>
            {
                if (result.GetValue(frames) is < 1 or > MostFrames)
                    result.AddError(string.Create(CultureInfo.InvariantCulture, $"--frames: expected a number from 1 to {MostFrames}."));
            });
            var noProgress = new Option<bool>("--no-progress") { Description = "No progress bars." };
            var project = new ProjectOptions();
            var command = new Command("scene", "Plays a scene of Unity, as Play does, and writes what its cameras show. Exit code 1 if it logs an error.")
            {
                scene, output, size, frames, noProgress,
            };
            project.AddTo(command);
            command.SetAction((parsed, cancellation) =>
            {
                var configuration = parsed.InvocationConfiguration;
                var job = new SceneJob(parsed.GetValue(scene), parsed.GetValue(output), parsed.GetValue(frames), project.Read(parsed, parsed.GetValue(size)));
                job.Run(configuration.Output, configuration.Error, !parsed.GetValue(noProgress), cancellation);
                return Task.FromResult(0);
            });
            return command;
        }
    }
}
