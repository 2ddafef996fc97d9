using System.Linq;
using Microsoft.CodeAnalysis;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.Rules
{
    /// <summary>The package's run-time sources keep the rules, and the rules find what breaks them.</summary>
    public class SourceRulesTests
    {
        /// <summary>Set by the Editor's own assembly in each domain, and null in players.</summary>
        static readonly string[] Exceptions = ["Runtime/Properties/EditorLink.cs"];

        [Test]
        public void Sources_OfThePackage_Compile() => Assert.That(
            PackageCompilation.OfRuntime().GetDiagnostics().Where(d => d.Severity == DiagnosticSeverity.Error).Take(10), Is.Empty,
            "names are looked up in this compilation");

        [Test]
        public void Sources_OfThePackage_KeepTheRules() =>
            Assert.That(SourceRules.Breaches(PackageCompilation.OfRuntime()).Where(b => !Exceptions.Any(b.StartsWith)), Is.Empty);

        [TestCase("UnityEngine.Shader.Find(\"X\");", "Shader.Find")]
        [TestCase("var c = UnityEngine.Camera.main;", "Camera.main")]
        [TestCase("UnityEngine.GameObject.Find(\"X\");", "GameObject.Find")]
        [TestCase("UnityEngine.Object.FindAnyObjectByType<UnityEngine.Camera>();", "FindAnyObjectByType")]
        [TestCase("UnityEditor.AssetDatabase.Refresh();", "UnityEditor outside")]
        [TestCase("System.Reflection.Emit.DynamicMethod m = null;", "emit")]
        [TestCase("System.Linq.Expressions.Expression<System.Func<int>> e = () => 1; e.Compile();", "Compile")]
        [TestCase("dynamic d = 1;", "dynamic")]
        [TestCase("System.IO.File.ReadAllText(UnityEngine.Application.streamingAssetsPath + \"/x\");", "StreamingAssets")]
        [TestCase("System.Activator.CreateInstance(typeof(int));", "Activator")]
        public void Statement_ThatBreaksARule_IsFound(string statement, string expected) =>
            Assert.That(Breaches("class C { void M() { " + statement + " } }"), Has.Some.Contains(expected));

        [TestCase("static int count;", "static field")]
        [TestCase("static int Count { get; set; }", "static property")]
        [TestCase("static event System.Action Changed;", "static event")]
        public void Member_ThatBreaksARule_IsFound(string member, string expected) =>
            Assert.That(Breaches("class C { " + member + " }"), Has.Some.Contains(expected));

        [Test]
        public void Condition_OfTheEditor_IsFound() => Assert.That(Breaches("#if UNITY_EDITOR\n#endif\nclass C {}"), Has.Some.Contains("UNITY_EDITOR"));

        [TestCase("static readonly int[] Table = { 1 }; const int N = 2; static int Twice(int n) => 2 * n;")]
        [TestCase("void M(UnityEngine.Camera camera) { System.IO.File.Exists(\"x\"); }")]
        public void Code_WithinTheRules_IsNotFound(string members) => Assert.That(Breaches("class C { " + members + " }"), Is.Empty);

        static string[] Breaches(string text) => SourceRules.Breaches(PackageCompilation.OfText(text, PackageCompilation.References)).ToArray();
    }
}
