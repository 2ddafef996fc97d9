using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using AnatomyCarve.Headless.Tests.Layout;
using AnatomyCarve.Headless.Tests.Rules;
using Microsoft.CodeAnalysis;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.Manual
{
    /// <summary>
    /// The manual and the README: their code compiles against the package, their links lead somewhere, their JSON is JSON. A block of C# is a whole file
    /// if it declares a class; otherwise it stands in an async method of a MonoBehaviour that has the fields below.
    /// </summary>
    public partial class ManualCodeTests
    {
        /// <summary>What "getting started" tells readers to use, and no more.</summary>
        const string Usings = """
            using System;
            using System.Collections.Generic;
            using AnatomyCarve;
            using AnatomyCarve.Desktop;
            using AnatomyCarve.Picking;
            using AnatomyCarve.Volumes;
            using UnityEngine;

            """;

        const string Start = """
            sealed class Snippet : MonoBehaviour
            {
                string ctPath, labelsPath, carvingPath;
                byte[] ctBytes, labelsBytes;
                VolumeAsset asset;
                VolumeLoader loader;
                ClipSphereStack carving;
                CarvedVolumeRenderer volumeRenderer;
                SegmentPointer pointer;
                Camera viewer;
                System.Threading.CancellationToken cancellation;

                async System.Threading.Tasks.Task Run()
                {
                    await System.Threading.Tasks.Task.Yield();

            """;

        const string End = """

                }
            }
            """;

        static readonly PackageTree Tree = PackageTree.OfRepository();

        [Test]
        public void Usings_OfTheCode_AreThoseThatReadersAreTold()
        {
            string page = Tree.Read("Documentation~/getting-started.md");
            string told = page.Substring(page.IndexOf("What this manual's code uses", System.StringComparison.Ordinal)).Split(". Code with")[0];
            Assert.That(Regex.Matches(told, "`([A-Z][A-Za-z.]+)`").Select(m => m.Groups[1].Value),
                Is.EqualTo(Regex.Matches(Usings, "using ([A-Za-z.]+);").Select(m => m.Groups[1].Value)));
        }

        [Test]
        public void Code_OfEachPage_Compiles([ValueSource(nameof(Pages))] string page)
        {
            var problems = new List<string>();
            foreach ((string code, int line) in Blocks(page, "csharp"))
            {
                string text = code.Contains("class ") ? Usings + code : Usings + Start + code + End;
                problems.AddRange(PackageCompilation.OfText(text, PackageCompilation.ReferencesWithPackage).GetDiagnostics()
                    .Where(d => d.Severity == DiagnosticSeverity.Error).Select(d => $"{page}, block at line {line}: {d.GetMessage()}"));
            }
            Assert.That(problems, Is.Empty);
        }

        [Test]
        public void Json_OfEachPage_IsJson([ValueSource(nameof(Pages))] string page)
        {
            foreach ((string text, int line) in Blocks(page, "json"))
                Assert.That(() => Newtonsoft.Json.Linq.JToken.Parse(text), Throws.Nothing, $"{page}, block at line {line}");
        }

        [Test]
        public void Links_OfEachPage_LeadSomewhere([ValueSource(nameof(Pages))] string page)
        {
            string folder = Path.GetDirectoryName(Tree.Full(page));
            IEnumerable<string> broken = Link().Matches(Tree.Read(page)).Select(m => m.Groups[1].Value)
                .Where(target => !target.Contains("://") && !target.StartsWith('#'))
                .Where(target => !Path.Exists(Path.Combine(folder, System.Uri.UnescapeDataString(target.Split('#')[0]))));
            Assert.That(broken, Is.Empty);
        }

        /// <summary>In the first columns of its tables the page quotes messages; dots stand for what differs.</summary>
        [Test]
        public void Troubleshooting_QuotesMessagesThatThereAre()
        {
            string[] quotes = TableRow().Matches(Tree.Read("Documentation~/troubleshooting.md")).SelectMany(row => Quote().Matches(row.Groups[1].Value))
                .SelectMany(quote => quote.Groups[1].Value.Split("...")).Select(part => part.Trim(' ', ';')).Where(part => part.Length > 2).ToArray();
            string sources = string.Concat(Tree.Files.Where(f => f.StartsWith("Runtime/") && f.EndsWith(".cs")).Select(Tree.Read));
            Assert.That(quotes, Has.Length.GreaterThan(10));
            Assert.That(quotes.Where(quote => !sources.Contains(quote, System.StringComparison.Ordinal)), Is.Empty);
        }

        [Test]
        public void Manual_HasCode() => Assert.That(Pages().Sum(p => Blocks(p, "csharp").Count()), Is.GreaterThan(10));

        static IEnumerable<string> Pages() => Directory.GetFiles(Tree.Full("Documentation~"), "*.md")
            .Select(f => "Documentation~/" + Path.GetFileName(f)).Append("README.md").Append("Samples~/DemoHead/README.md");

        static IEnumerable<(string text, int line)> Blocks(string page, string language)
        {
            string text = Tree.Read(page);
            foreach (Match match in Block().Matches(text))
                if (match.Groups[1].Value == language)
                    yield return (match.Groups[2].Value, text[..match.Index].Count(c => c == '\n') + 1);
        }

        [GeneratedRegex(@"^```(\w+)\n(.*?)^```", RegexOptions.Multiline | RegexOptions.Singleline)]
        private static partial Regex Block();

        [GeneratedRegex(@"^\| ([^|]*) \|", RegexOptions.Multiline)]
        private static partial Regex TableRow();

        [GeneratedRegex("`([^`]+)`")]
        private static partial Regex Quote();

        [GeneratedRegex(@"\]\(([^)\s]+)\)")]
        private static partial Regex Link();
    }
}
