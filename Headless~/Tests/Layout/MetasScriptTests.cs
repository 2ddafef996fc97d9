using System;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.Layout
{
    /// <summary>The script that makes .meta files, on a package made for the test.</summary>
    public class MetasScriptTests
    {
        string root;

        [SetUp]
        public void MakePackage()
        {
            root = Directory.CreateTempSubdirectory("anatomycarve-metas-").FullName;
            Directory.CreateDirectory(Path.Combine(root, "Headless~"));
            File.Copy(PackageTree.OfRepository().Full("Headless~/metas"), Path.Combine(root, "Headless~/metas"));
            Write("package.json", "{}");
            Write("Runtime/Thing.cs", "class Thing {}");
            Write("Samples~/Demo/data.nrrd", "NRRD0004");
            Write("Documentation~/manual.md", "hidden");
            Write(".hidden/file.txt", "hidden");
            Write("Runtime/Cache~/file.txt", "hidden");
        }

        [TearDown]
        public void RemovePackage() => Directory.Delete(root, true);

        [Test]
        public void Metas_OfANewPackage_AreMadeForWhatUnityImports()
        {
            Assert.That(Run().ExitCode, Is.Zero);
            Assert.That(Metas(),
                Is.EquivalentTo(new[] { "package.json.meta", "Runtime.meta", "Runtime/Thing.cs.meta", "Samples~/Demo.meta", "Samples~/Demo/data.nrrd.meta" }));
        }

        [Test]
        public void Guid_OfANewAsset_IsTheHashOfItsPath()
        {
            Run();
            Assert.That(Read("Runtime/Thing.cs.meta"), Does.Contain("\nguid: " + Md5("com.anatomycarve.vr:Runtime/Thing.cs") + "\n"));
        }

        [Test]
        public void Guid_OfAMovedAsset_IsKept()
        {
            Run();
            string before = Read("Runtime/Thing.cs.meta");
            File.Move(Path.Combine(root, "Runtime/Thing.cs"), Path.Combine(root, "Runtime/Other.cs"));
            File.Move(Path.Combine(root, "Runtime/Thing.cs.meta"), Path.Combine(root, "Runtime/Other.cs.meta"));
            Write("Runtime/Thing.cs", "class Thing {}");
            Assert.That(Run().ExitCode, Is.Zero, "the old path's GUID is taken, so the new asset there gets another");
            Assert.That(Read("Runtime/Other.cs.meta"), Is.EqualTo(before));
            Assert.That(Read("Runtime/Thing.cs.meta"), Is.Not.EqualTo(before));
        }

        [Test]
        public void Check_MissingMeta_IsReportedAndNotMade()
        {
            ProcessResult result = Run("--check");
            Assert.That(result.ExitCode, Is.EqualTo(1));
            Assert.That(result.Output, Does.Contain("missing: Runtime/Thing.cs.meta"));
            Assert.That(Metas(), Is.Empty);
        }

        [Test]
        public void Check_CompletePackage_Passes()
        {
            Run();
            Assert.That(Run("--check").ExitCode, Is.Zero);
        }

        [Test]
        public void Check_OrphanAndDuplicate_AreReported()
        {
            Run();
            File.Copy(Path.Combine(root, "package.json.meta"), Path.Combine(root, "Runtime/Gone.cs.meta"));
            ProcessResult result = Run("--check");
            Assert.That(result.ExitCode, Is.EqualTo(1));
            Assert.That(result.Output,
                Does.Contain("orphan: Runtime/Gone.cs.meta").And.Contain("duplicate: package.json.meta has the GUID of Runtime/Gone.cs.meta"));
        }

        [Test]
        public void Arguments_Unknown_AreRefused() => Assert.That(Run("--fix").ExitCode, Is.EqualTo(2));

        ProcessResult Run(params string[] arguments) => ProcessResult.Of("bash", [Path.Combine(root, "Headless~/metas"), .. arguments]);

        string[] Metas() =>
            Directory.GetFiles(root, "*.meta", SearchOption.AllDirectories).Select(f => Path.GetRelativePath(root, f).Replace('\\', '/')).ToArray();

        void Write(string path, string text)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(Path.Combine(root, path)));
            File.WriteAllText(Path.Combine(root, path), text);
        }

        string Read(string path) => File.ReadAllText(Path.Combine(root, path));

        static string Md5(string text) => Convert.ToHexStringLower(System.Security.Cryptography.MD5.HashData(System.Text.Encoding.UTF8.GetBytes(text)));
    }
}
