using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using UnityEngine;
using UnityEngine.Shaders;

namespace AnatomyCarve.Headless
{
    /// <summary>A stage of a shader's pass with one choice of keywords, as Unity gives it to Direct3D's compilers.</summary>
    public sealed class ShaderStage
    {
        internal ShaderStage(string name, bool isVertex, string entry, string text, IReadOnlyList<string> keywords, IReadOnlyList<string> defines)
        {
            (Name, IsVertex, Entry, Text, Keywords, Defines) = (name, isVertex, entry, text, keywords, defines);
        }

        /// <summary>The file's name, the numbers of SubShader and pass from 1 on.</summary>
        public string Name { get; }

        /// <summary>Of vertices, or of fragments.</summary>
        public bool IsVertex { get; }

        /// <summary>The function.</summary>
        public string Entry { get; }

        /// <summary>The source with all includes in place, Unity's and URP's too, which are this host's own.</summary>
        public string Text { get; }

        /// <summary>The keywords that are on.</summary>
        public IReadOnlyList<string> Keywords { get; }

        /// <summary>All defines, NAME=VALUE, those of the keywords too.</summary>
        public IReadOnlyList<string> Defines { get; }
    }

    /// <summary>Takes .shader files apart, so that other compilers can be asked about them.</summary>
    public static class ShaderStages
    {
        const string Api = "SHADER_API_D3D11";
        const string Renderer = "d3d11";
        const string Gamma = "UNITY_COLORSPACE_GAMMA";
        const string Version = "17.0.4";

        /// <summary>Every SubShader, pass, keyword variant and stage of a file that Direct3D 11 compiles. URP counts as installed; fragments that depend on the
        /// colour space come for both.</summary>
        /// <param name="packageRoot">The package's folder, for includes of the form "Packages/...".</param>
        /// <param name="path">The .shader file.</param>
        /// <exception cref="FormatException">The file makes no sense; the message says where.</exception>
        public static IReadOnlyList<ShaderStage> Of(string packageRoot, string path)
        {
            ArgumentNullException.ThrowIfNull(packageRoot);
            ArgumentNullException.ThrowIfNull(path);
            var root = GpuOptions.PackageRoot;
            var installed = ShaderEnvironment.HasPackage(ShaderEnvironment.UniversalPackage);
            GpuOptions.PackageRoot = packageRoot;
            try
            {
                if (!installed)
                    Install(Version);
                var file = ShaderLabParser.Parse(Path.GetFullPath(path), File.ReadAllText(path, Encoding.UTF8));
                return file.SubShaders.SelectMany((s, i) => s.Passes.SelectMany((p, j) =>
                    Stages(PassSource.Load(file, p), FormattableString.Invariant($"{Path.GetFileNameWithoutExtension(path)} {i + 1}.{j + 1}")))).ToList();
            }
            catch (ShaderCompileException e)
            {
                throw new FormatException(e.Message, e);
            }
            finally
            {
                GpuOptions.PackageRoot = root;
                if (!installed)
                    Install(null);
            }
        }

        static void Install(string version)
        {
            ShaderEnvironment.Install(ShaderEnvironment.CorePackage, version);
            ShaderEnvironment.Install(ShaderEnvironment.UniversalPackage, version);
        }

        static IEnumerable<ShaderStage> Stages(PassSource source, string name)
        {
            if (!source.RunsOn(Renderer))
                yield break;
            var dependsOnColorSpace = OwnLines(source.Text).Any(l => l.Contains(Gamma, StringComparison.Ordinal));
            // Direct3D 11 has no views.
            foreach (var keywords in source.AllVariants().Where(v => !v.Contains(PassSource.Multiview)))
            {
                yield return Stage(source, name, true, keywords, false);
                yield return Stage(source, name, false, keywords, false);
                // Colours are fragments', and none of instances.
                if (dependsOnColorSpace && !keywords.Contains(PassSource.Instanced) && !keywords.Contains("INSTANCING_ON"))
                    yield return Stage(source, name, false, keywords, true);
            }
        }

        /// <summary>The lines that do not come from Unity's or URP's files.</summary>
        static IEnumerable<string> OwnLines(string text)
        {
            var isOwn = true;
            foreach (var line in text.Split('\n'))
            {
                if (line.StartsWith("#line ", StringComparison.Ordinal))
                    isOwn = !line.Contains('"' + ShaderEnvironment.LibraryPrefix, StringComparison.Ordinal);
                else if (isOwn)
                    yield return line;
            }
        }

        static ShaderStage Stage(PassSource source, string name, bool isVertex, IReadOnlyList<string> keywords, bool gamma)
        {
            var defines = PassVariant.Defines(source, keywords, Api, isVertex ? "SHADER_STAGE_VERTEX" : "SHADER_STAGE_FRAGMENT")
                .Where(d => !d.StartsWith(Gamma, StringComparison.Ordinal)).ToList();
            if (gamma)
                defines.Add(Gamma + "=1");
            return new ShaderStage(name, isVertex, isVertex ? source.VertexEntry : source.FragmentEntry, source.Text,
                gamma ? keywords.Append(Gamma).ToList() : keywords, defines);
        }
    }
}
