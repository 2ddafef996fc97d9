using System.IO;

namespace AnatomyCarve.Headless.Cli.Files
{
    /// <summary>A file that a command reads.</summary>
    static class InputFile
    {
        /// <summary>Fails early where there is nothing to read.</summary>
        /// <exception cref="CommandException">There is no such file, or it is a folder.</exception>
        public static void Check(string path)
        {
            if (Directory.Exists(path)) throw new CommandException($"{path}: this is a folder, not a file to read.");
            if (!File.Exists(path)) throw new CommandException($"{path}: there is no such file.");
        }
    }
}
