using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Threading.Tasks;
using AnatomyCarve.Headless.Cli.Files;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>carve expect: holds a rendering's report to a list of segments that must be seen, or must not.</summary>
    static class ExpectCommand
    {
        static readonly JsonSerializerOptions Options = new(JsonSerializerDefaults.Web);

        sealed record Expectation(string Name, long MinimumPixels = 0, long MaximumPixels = long.MaxValue);

        sealed record ExpectationFile(List<Expectation> Segments);

        sealed record ReportedSegment(string Name, long VisiblePixels);

        sealed record ReportFile(List<ReportedSegment> Segments);

        public static Command Create()
        {
            var report = new Argument<string>("REPORT") { Description = "A report that carve render wrote." };
            var expected = new Argument<string>("EXPECTED")
            {
                Description = "{\"segments\": [{\"name\": \"liver\", \"minimumPixels\": 100, \"maximumPixels\": 5000}]}; either limit may be left out.",
            };
            var command =
                new Command("expect", "Checks the visible pixels of segments in a report against limits; exit code 1 if one is not kept.") { report, expected };
            command.SetAction((parsed, _) => Task.FromResult(Check(parsed.InvocationConfiguration.Output, parsed.GetValue(report), parsed.GetValue(expected))));
            return command;
        }

        static int Check(TextWriter output, string reportPath, string expectedPath)
        {
            var visible = Read<ReportFile>(reportPath).Segments.GroupBy(segment => segment.Name)
                .ToDictionary(group => group.Key, group => group.Sum(segment => segment.VisiblePixels));
            var expectations = Read<ExpectationFile>(expectedPath).Segments;
            var failed = 0;
            foreach (var (name, minimum, maximum) in expectations)
            {
                var known = visible.TryGetValue(name, out var pixels);
                var kept = known && pixels >= minimum && pixels <= maximum;
                if (!kept) failed++;
                var limits = string.Join(" and ", new[]
                {
                    minimum > 0 ? string.Create(CultureInfo.InvariantCulture, $"at least {minimum}") : null,
                    maximum < long.MaxValue ? string.Create(CultureInfo.InvariantCulture, $"at most {maximum}") : null,
                }.Where(limit => limit != null));
                output.WriteLine(string.Create(CultureInfo.InvariantCulture,
                    $"{(kept ? "passed" : "FAILED")}  {name}: {(known ? $"{pixels} pixels" : "not in the report")}, expected {limits}"));
            }

            output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{expectations.Count - failed} passed, {failed} failed"));
            return failed == 0 ? 0 : Failure.BadInput;
        }

        static T Read<T>(string path)
            where T : class
        {
            InputFile.Check(path);
            T file;
            try
            {
                file = JsonSerializer.Deserialize<T>(File.ReadAllText(path), Options);
            }
            catch (JsonException exception)
            {
                throw new CommandException($"{path}: not JSON as expected: {exception.Message}");
            }

            var isComplete = file is ReportFile { Segments: not null } or ExpectationFile { Segments: not null };
            return isComplete ? file : throw new CommandException($"{path}: it has no list \"segments\".");
        }
    }
}
