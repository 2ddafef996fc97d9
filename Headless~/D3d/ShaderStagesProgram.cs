using System;
using System.Collections.Generic;
using System.IO;

namespace AnatomyCarve.Headless.D3d
{
    /// <summary>
    /// shader-stages PACKAGE FOLDER FILE.shader...: writes the stages of shaders into a folder, as sources without includes, and prints a line for each:
    /// stage (vs or ps), source, name, entry, keywords, defines; with tabs in between, lists with blanks.
    /// </summary>
    static class ShaderStagesProgram
    {
        static int Main(string[] arguments)
        {
            if (arguments.Length < 3)
            {
                Console.Error.WriteLine("usage: shader-stages PACKAGE FOLDER FILE.shader...");
                return 2;
            }
            var (package, folder) = (arguments[0], arguments[1]);
            var failed = false;
            foreach (var file in arguments.AsSpan(2))
            {
                try
                {
                    Write(ShaderStages.Of(package, file), folder);
                }
                catch (Exception e) when (e is FormatException or IOException or UnauthorizedAccessException)
                {
                    Console.Error.WriteLine(e.Message);
                    failed = true;
                }
            }
            return failed ? 1 : 0;
        }

        static void Write(IReadOnlyList<ShaderStage> stages, string folder)
        {
            foreach (var stage in stages)
            {
                // All variants of a pass share one source.
                var source = Path.Combine(folder, stage.Name.Replace(' ', '-') + ".hlsl");
                if (!File.Exists(source))
                    File.WriteAllText(source, stage.Text);
                Console.Out.WriteLine(string.Join('\t', stage.IsVertex ? "vs" : "ps", source, stage.Name, stage.Entry,
                    string.Join(' ', stage.Keywords), string.Join(' ', stage.Defines)));
            }
        }
    }
}
