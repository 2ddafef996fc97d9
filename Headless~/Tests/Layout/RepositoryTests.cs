using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.Layout
{
    /// <summary>What no file of the repository may hold.</summary>
    public partial class RepositoryTests
    {
        static readonly string[] TextFiles =
        [
            ".cs", ".hlsl", ".compute", ".shader", ".json", ".asmdef", ".md", ".txt", ".csproj", ".props", ".targets",
            ".asset", ".meta", ".c", ".h", ".py", ".sh", "",
        ];

        [Test]
        public void Files_PathsOfSomebodysMachine_DoNotOccur()
        {
            var found = new List<string>();
            foreach ((string file, string[] lines) in Texts())
                for (int l = 0; l < lines.Length; l++)
                    if (MachinePath().IsMatch(lines[l]))
                        found.Add($"{file}:{l + 1}: {lines[l].Trim()}");
            Assert.That(found, Is.Empty);
        }

        [Test]
        public void Files_LineEndings_AreUnix() => Assert.That(Texts().Where(t => t.lines.Any(l => l.EndsWith('\r'))).Select(t => t.file), Is.Empty);

        static IEnumerable<(string file, string[] lines)> Texts()
        {
            string root = PackageTree.OfRepository().Root;
            return PackageTree.List(root, "", name => name is ".git" or "artifacts" or "out" || name.EndsWith(".swp"))
                .Where(f => TextFiles.Contains(Path.GetExtension(f)))
                .Select(f => (f, File.ReadAllText(Path.Combine(root, f)).Split('\n')));
        }

        /// <summary>Absolute paths into home and work folders; "../shared" is how the repository speaks of what lies beside it.</summary>
        [GeneratedRegex(@"(?<![\w.$}/])/(?:home|root|work|Users)/\w|\b[A-Z]:\\Users")]
        private static partial Regex MachinePath();
    }
}
