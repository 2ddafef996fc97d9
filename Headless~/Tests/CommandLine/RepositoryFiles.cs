using System;
using System.IO;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>Files of the checkout, and of the folder beside it that holds test data where this is developed.</summary>
    static class RepositoryFiles
    {
        public static string Root { get; } = FindRoot();

        /// <summary>A file of the demo sample.</summary>
        public static string Demo(string name) => Path.Combine(Root, "Samples~", "DemoHead", name);

        /// <summary>A file beside the checkout, under shared/; null where that is absent.</summary>
        public static string Shared(params string[] names)
        {
            var path = Path.Combine([Root, "..", "shared", .. names]);
            return File.Exists(path) ? Path.GetFullPath(path) : null;
        }

        static string FindRoot()
        {
            for (var folder = new DirectoryInfo(TestContext.CurrentContext.TestDirectory); folder != null; folder = folder.Parent)
                if (File.Exists(Path.Combine(folder.FullName, "package.json"))) return folder.FullName;
            throw new InvalidOperationException("The package's folder is not above the tests.");
        }
    }
}
