using System.Collections.Generic;
using System.IO;
using System.Linq;
using YamlDotNet.Core;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>What the host needs of a package.json. JSON is YAML too.</summary>
    sealed class PackageManifest
    {
        PackageManifest(string name, string[] dependencies)
        {
            Name = name;
            Dependencies = dependencies;
        }

        internal string Name { get; }

        /// <summary>The names of the packages that it declares as dependencies.</summary>
        internal IReadOnlyList<string> Dependencies { get; }

        /// <summary>Null if the folder holds no package.json.</summary>
        /// <exception cref="AssetFormatException">It cannot be read.</exception>
        internal static PackageManifest Read(string folder)
        {
            var path = Path.Combine(folder, "package.json");
            if (!File.Exists(path))
                return null;
            try
            {
                var stream = new YamlStream();
                using var reader = new StreamReader(path);
                stream.Load(reader);
                var root = stream.Documents.FirstOrDefault()?.RootNode as YamlMappingNode ?? new YamlMappingNode();
                var dependencies = YamlNodes.Child(root, "dependencies") as YamlMappingNode ?? new YamlMappingNode();
                var name = (YamlNodes.Child(root, "name") as YamlScalarNode)?.Value ?? "";
                return new PackageManifest(name, dependencies.Children.Select(YamlNodes.Key).ToArray());
            }
            catch (YamlException e)
            {
                throw new AssetFormatException(path, e.Message, e);
            }
        }
    }
}
