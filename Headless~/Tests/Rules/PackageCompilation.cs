using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using AnatomyCarve.Headless.Tests.Layout;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace AnatomyCarve.Headless.Tests.Rules
{
    /// <summary>The package's sources as one compilation, against the assemblies that these tests run with: for asking what a name means.</summary>
    static class PackageCompilation
    {
        /// <summary>The package's projects are built as C# 9 against .NET Standard; against today's framework some of it needs a newer compiler.</summary>
        static readonly CSharpParseOptions Options = new(LanguageVersion.Latest, preprocessorSymbols: ["UNITY_6000_0_OR_NEWER"]);

        /// <summary>All assemblies of the framework, the engine and the package's dependencies, without the package's own.</summary>
        public static IReadOnlyList<MetadataReference> References { get; } = Assemblies()
            .Where(path => !Path.GetFileName(path).StartsWith("AnatomyCarve", StringComparison.Ordinal))
            .Select(path => (MetadataReference)MetadataReference.CreateFromFile(path)).ToArray();

        /// <summary>The same with the package's assemblies.</summary>
        public static IReadOnlyList<MetadataReference> ReferencesWithPackage { get; } = Assemblies()
            .Where(path => !Path.GetFileName(path).StartsWith("AnatomyCarve.Headless", StringComparison.Ordinal))
            .Select(path => (MetadataReference)MetadataReference.CreateFromFile(path)).ToArray();

        /// <summary>Runtime/ and the scripts of the samples.</summary>
        public static CSharpCompilation OfRuntime()
        {
            PackageTree tree = PackageTree.OfRepository();
            IEnumerable<SyntaxTree> sources = tree.AllFiles
                .Where(f => f.EndsWith(".cs", StringComparison.Ordinal) && (f.StartsWith("Runtime/", StringComparison.Ordinal) || f.StartsWith("Samples~/", StringComparison.Ordinal)))
                .Select(f => CSharpSyntaxTree.ParseText(tree.Read(f), Options, f));
            return Of(sources, References);
        }

        /// <summary>A text as Unity's compiler would read it.</summary>
        public static CSharpCompilation OfText(string text, IReadOnlyList<MetadataReference> references) =>
            Of([CSharpSyntaxTree.ParseText(text, Options.WithLanguageVersion(LanguageVersion.CSharp9), "text.cs")], references);

        static CSharpCompilation Of(IEnumerable<SyntaxTree> sources, IEnumerable<MetadataReference> references) =>
            CSharpCompilation.Create("Sources", sources, references, new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary));

        static IEnumerable<string> Assemblies()
        {
            IEnumerable<string> framework = ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")).Split(Path.PathSeparator);
            return framework.Concat(Directory.GetFiles(AppContext.BaseDirectory, "*.dll").Where(IsManaged)).GroupBy(Path.GetFileName).Select(g => g.First());
        }

        static bool IsManaged(string path)
        {
            try
            {
                System.Reflection.AssemblyName.GetAssemblyName(path);
                return true;
            }
            catch (BadImageFormatException)
            {
                return false;
            }
        }
    }
}
