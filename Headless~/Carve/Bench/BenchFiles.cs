using System;
using System.IO;
using AnatomyCarve.Headless.Cli.Commands;

namespace AnatomyCarve.Headless.Cli.Bench
{
    /// <summary>The benchmark's own files in the checkout: scenes, kernels, scripts, figures.</summary>
    static class BenchFiles
    {
        static readonly Lazy<string> Checkout = new(FindCheckout);

        /// <summary>The folder of package.json.</summary>
        /// <exception cref="CommandException">The program lies outside of a checkout.</exception>
        public static string Root => Checkout.Value ?? throw new CommandException("the benchmark needs the package's checkout around the program; there is no package.json above it.");

        /// <summary>A file of the benchmark's folder; its path relative to that folder.</summary>
        public static string Find(params string[] path) => Path.Combine([Root, "Headless~", "Carve", "Bench", .. path]);

        static string FindCheckout()
        {
            for (var folder = new DirectoryInfo(AppContext.BaseDirectory); folder != null; folder = folder.Parent)
            {
                if (File.Exists(Path.Combine(folder.FullName, "package.json"))) return folder.FullName;
            }

            return null;
        }
    }
}
