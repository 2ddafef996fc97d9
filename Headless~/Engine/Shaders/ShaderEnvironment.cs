using System;
using System.Collections.Generic;
using System.IO;
using System.Text;

namespace UnityEngine.Shaders
{
    /// <summary>What the project that the host pretends to be offers to shaders: packages, and the include files that come with Unity and with them.</summary>
    static class ShaderEnvironment
    {
        internal const string UniversalPackage = "com.unity.render-pipelines.universal";
        internal const string CorePackage = "com.unity.render-pipelines.core";

        /// <summary>How the path of a file begins that is part of this assembly.</summary>
        internal const string LibraryPrefix = "ShaderLibrary/";

        const string PackageFolder = "Packages/";

        static readonly Dictionary<string, string> s_Packages = new(StringComparer.Ordinal);

        /// <summary>Rises when packages come or go.</summary>
        internal static int Revision { get; private set; }

        /// <param name="package">Its name.</param>
        /// <param name="version">Null takes it away.</param>
        internal static void Install(string package, string version)
        {
            if (version == null)
                s_Packages.Remove(package);
            else
                s_Packages[package] = version;
            Revision++;
        }

        internal static bool HasPackage(string package) => s_Packages.ContainsKey(package);

        /// <summary>The library's path of an include file that Unity or an installed package brings; null if there is none.</summary>
        internal static string Resolve(string include)
        {
            if (include.StartsWith(PackageFolder, StringComparison.Ordinal))
            {
                var end = include.IndexOf('/', PackageFolder.Length);
                if (end < 0 || !HasPackage(include.Substring(PackageFolder.Length, end - PackageFolder.Length)))
                    return null;
            }
            var path = LibraryPrefix + include;
            return typeof(ShaderEnvironment).Assembly.GetManifestResourceInfo(path) != null ? path : null;
        }

        internal static string ReadLibrary(string path)
        {
            using var stream = typeof(ShaderEnvironment).Assembly.GetManifestResourceStream(path)
                ?? throw new FileNotFoundException("There is no such file in the shader library", path);
            using var reader = new StreamReader(stream, Encoding.UTF8);
            return reader.ReadToEnd();
        }

        /// <summary>Whether all requirements of a SubShader are met.</summary>
        internal static bool Meets(ShaderLabSubShader subShader)
        {
            foreach (var requirement in subShader.Requirements)
            {
                var installed = requirement.Package == "unity" ? Application.unityVersion
                    : s_Packages.TryGetValue(requirement.Package, out var version) ? version : null;
                if (installed == null || !VersionRange.Contains(requirement.Version, installed))
                    return false;
            }
            return true;
        }
    }
}
