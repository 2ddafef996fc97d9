using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace AnatomyCarve.Tests.TestSupport
{
    /// <summary>Finds the test data that lie beside the checkout (../shared/data). Tests that need them are skipped where they are absent.</summary>
    public static class SharedData
    {
        /// <summary>Stands in for a file's name where the data are absent, so that a skipped test can say why.</summary>
        const string Absent = "(no shared data)";

        static readonly Dictionary<string, JObject> Parsed = new Dictionary<string, JObject>();

        /// <summary>The folder of the data, or null when it is absent.</summary>
        public static string Folder { get; } = Find();

        /// <summary>The path of a file of the data; skips the test when the data are absent.</summary>
        public static string PathOf(string relative)
        {
            if (Folder == null || relative.EndsWith(Absent))
                Assert.Ignore("The folder ../shared/data is not beside this checkout.");
            return Path.Combine(Folder, relative);
        }

        /// <summary>The files that an expected.json lists, for TestCaseSource.</summary>
        /// <param name="folder">The folder of expected.json, such as "readers".</param>
        /// <param name="list">The list in it, such as "files".</param>
        public static IEnumerable<string> FilesIn(string folder, string list) =>
            Folder == null ? new[] { Absent } : Json(folder)[list].Select(item => (string)item["file"]);

        /// <summary>What an expected.json says about a file; skips the test when the data are absent.</summary>
        public static JObject Expected(string folder, string list, string file)
        {
            PathOf(file);
            return (JObject)Json(folder)[list].Single(item => (string)item["file"] == file);
        }

        static JObject Json(string folder)
        {
            if (!Parsed.TryGetValue(folder, out JObject json))
            {
                json = JObject.Parse(File.ReadAllText(Path.Combine(Folder, folder, "expected.json")));
                Parsed.Add(folder, json);
            }

            return json;
        }

        static string Find([CallerFilePath] string thisFile = "")
        {
            DirectoryInfo folder = new FileInfo(thisFile).Directory;
            while (folder != null && !File.Exists(Path.Combine(folder.FullName, "package.json")))
                folder = folder.Parent;
            string data = folder?.Parent == null ? null : Path.Combine(folder.Parent.FullName, "shared", "data");
            return data != null && Directory.Exists(data) ? data : null;
        }
    }
}
