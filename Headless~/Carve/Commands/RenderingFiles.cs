using System.IO;
using System.Text.Json;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Files;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>The files of one rendering; null where there is none.</summary>
    sealed record RenderingFiles(string Picture, string Depth, string Segments)
    {
        /// <summary>
        /// Finds them from one of them: a .png, .pfm or .pgm with the others beside it under the same name, or the report (.json),
        /// which names them.
        /// </summary>
        /// <exception cref="CommandException">There is no such file, or it is none of these.</exception>
        public static RenderingFiles Find(string path)
        {
            InputFile.Check(path);
            return Path.GetExtension(path).ToLowerInvariant() switch
            {
                ".png" or ".pfm" or ".pgm" => new RenderingFiles(Beside(path, ".png"), Beside(path, ".pfm"), Beside(path, ".pgm")),
                ".json" => FromReport(path),
                _ => throw new CommandException($"{path}: expected a rendering's .png, .pfm, .pgm or its report, .json."),
            };
        }

        static string Beside(string path, string extension)
        {
            if (Path.GetExtension(path).ToLowerInvariant() == extension) return path;
            var other = Path.ChangeExtension(path, extension);
            return File.Exists(other) ? other : null;
        }

        static RenderingFiles FromReport(string path)
        {
            JsonNode report;
            try
            {
                report = JsonNode.Parse(File.ReadAllText(path));
            }
            catch (JsonException exception)
            {
                throw new CommandException($"{path}: not a report in JSON: {exception.Message}");
            }

            var outputs = (report as JsonObject)?["outputs"] as JsonObject ?? throw new CommandException($"{path}: a report has \"outputs\", this does not.");
            string Output(string name) => outputs[name] is JsonValue value && value.TryGetValue<string>(out var file)
                ? Path.Combine(Path.GetDirectoryName(Path.GetFullPath(path))!, file)
                : null;
            return new RenderingFiles(Output("picture"), Output("depth"), Output("segments"));
        }
    }
}
