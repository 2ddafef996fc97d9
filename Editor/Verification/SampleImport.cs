using System.IO;
using AnatomyCarve.Volumes;
using UnityEditor;
using PackageInfo = UnityEditor.PackageManager.PackageInfo;

namespace AnatomyCarve.Editor
{
    /// <summary>Copies the package's sample into the project, as the Package Manager does.</summary>
    static class SampleImport
    {
        const string SourceFolder = "Samples~/DemoHead", Name = "Demo Head";

        /// <summary>Imports it; one that was imported before is replaced file by file.</summary>
        /// <returns>The folder in the project.</returns>
        /// <exception cref="AnatomyCarveException">The package or the sample cannot be found.</exception>
        public static string Run()
        {
            PackageInfo package = PackageInfo.FindForAssembly(typeof(CarvedVolumeRenderer).Assembly);
            if (package == null)
                throw new AnatomyCarveException("AnatomyCarve is not installed as a package, so its sample cannot be found.");
            string source = Path.Combine(package.resolvedPath, SourceFolder);
            if (!Directory.Exists(source))
                throw new AnatomyCarveException($"{source}: the sample's folder is not there; expected it in the package {package.name} {package.version}.");
            string target = $"Assets/Samples/{package.displayName}/{package.version}/{Name}";
            Copy(source, target);
            AssetDatabase.Refresh(ImportAssetOptions.ForceSynchronousImport);
            return target;
        }

        static void Copy(string source, string target)
        {
            Directory.CreateDirectory(target);
            foreach (string file in Directory.GetFiles(source))
                File.Copy(file, Path.Combine(target, Path.GetFileName(file)), true);
            foreach (string folder in Directory.GetDirectories(source))
                Copy(folder, Path.Combine(target, Path.GetFileName(folder)));
        }
    }
}
