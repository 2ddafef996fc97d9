using System;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.Layout
{
    /// <summary>The script for people who have a Unity Editor, with a pretended one that writes down how it was called.</summary>
    public class UnityScriptTests
    {
        static readonly string Script = PackageTree.OfRepository().Full(".ci/unity");

        string folder;

        [SetUp]
        public void MakeEditor()
        {
            folder = Directory.CreateTempSubdirectory("anatomycarve-unity-").FullName;
            Write("Unity", """
                #!/bin/bash
                printf '%s\n' "$*" >> "$(dirname "$0")/calls"
                while (($# > 0)); do
                    [[ "$1" == -projectPath && ! -e "$2/ProjectSettings/ProjectSettings.asset" ]] && printf '  m_ActiveColorSpace: 0\n  activeInputHandler: 0\n' > "$2/ProjectSettings/ProjectSettings.asset"
                    [[ "$1" == -testResults ]] && printf '<test-run id="2" result="Passed" total="5" passed="'"$(cat "$(dirname "$0")/passed")"'" failed="'"$(cat "$(dirname "$0")/failed")"'" skipped="0">\n<test-case id="7" fullname="A.B" result="Failed">\n' > "$2"
                    [[ "$1" == -executeMethod && "$2" == *Screenshots ]] && exit "$(cat "$(dirname "$0")/pictures")"
                    shift
                done
                """);
            ProcessResult.Of("chmod", ["+x", Full("Unity")]);
            Write("pictures", "0");
            Write("passed", "4");
            Write("failed", "1");
        }

        [TearDown]
        public void RemoveEditor() => Directory.Delete(folder, true);

        [Test]
        public void Run_OfAllSteps_CallsTheEditorForEachAndAddsUp()
        {
            ProcessResult result = Run("--editor", Full("Unity"), "--project", Full("Project"), "--output", Full("out"));
            Assert.That(result.Output.TrimEnd().Split('\n').Last(), Is.EqualTo("10 passed, 2 failed"), result.Output);
            Assert.That(result.ExitCode, Is.EqualTo(1));
            string[] calls = File.ReadAllLines(Full("calls"));
            Assert.That(calls, Has.Length.EqualTo(5));
            Assert.That(calls[0], Does.EndWith("-quit"), "makes the project's settings");
            Assert.That(calls[1], Does.Contain("-runTests -testPlatform EditMode"));
            Assert.That(calls[2], Does.Contain("-runTests -testPlatform PlayMode"));
            Assert.That(calls[3], Does.Contain("EditorVerification.ImportSample -quit"));
            Assert.That(calls[4], Does.Contain("EditorVerification.Screenshots -anatomycarveOutput").And.Not.Contain("-quit"));
            Assert.That(calls, Has.All.Contain("-batchmode -anatomycarveVerification -projectPath"));
            Assert.That(calls, Has.None.Contain("-nographics"));
            Assert.That(result.Output, Does.Contain("FAILED A.B"));
        }

        [Test]
        public void Run_OfANewProject_RefersToThisPackageAndItsTests()
        {
            Run("--editor", Full("Unity"), "--project", Full("Project"), "--output", Full("out"), "--only", "sample");
            var manifest = Newtonsoft.Json.Linq.JObject.Parse(File.ReadAllText(Full("Project/Packages/manifest.json")));
            Assert.That((string)manifest["dependencies"]["com.anatomycarve.vr"], Is.EqualTo("file:" + PackageTree.OfRepository().Root.TrimEnd('/')));
            Assert.That(manifest["testables"].Select(t => (string)t), Does.Contain("com.anatomycarve.vr"));
        }

        [Test]
        public void Run_OfANewProject_SetsInputSystemAndLinearColours()
        {
            Run("--editor", Full("Unity"), "--project", Full("Project"), "--output", Full("out"), "--only", "sample");
            Assert.That(File.ReadAllText(Full("Project/ProjectSettings/ProjectSettings.asset")), Is.EqualTo("  m_ActiveColorSpace: 1\n  activeInputHandler: 1\n"));
        }

        [Test]
        public void Tests_OfWhichNoneWasRun_AreAFailure()
        {
            Write("passed", "0");
            Write("failed", "0");
            ProcessResult result = Run("--editor", Full("Unity"), "--project", Full("Project"), "--output", Full("out"), "--only", "editmode");
            Assert.That(result.Output.TrimEnd().Split('\n').Last(), Is.EqualTo("0 passed, 1 failed"));
            Assert.That(result.Output, Does.Contain("no test was run").And.Contain("testables"));
        }

        [Test]
        public void Methods_ThatTheScriptCalls_Exist()
        {
            string source = PackageTree.OfRepository().Read("Editor/Verification/EditorVerification.cs");
            Assert.That(source, Does.Contain("namespace AnatomyCarve.Editor").And.Contain("static void ImportSample()").And.Contain("static void Screenshots()"));
        }

        [Test]
        public void Pictures_ThatFail_AreCounted()
        {
            Write("pictures", "1");
            ProcessResult result = Run("--editor", Full("Unity"), "--project", Full("Project"), "--output", Full("out"), "--only", "sample,pictures");
            Assert.That(result.Output.TrimEnd().Split('\n').Last(), Is.EqualTo("1 passed, 1 failed"));
            Assert.That(result.ExitCode, Is.EqualTo(1));
        }

        [TestCase("--editor", "nowhere/Unity")]
        [TestCase("--only", "everything")]
        [TestCase("--fast", "1")]
        public void Arguments_ThatMakeNoSense_AreRefused(string option, string value)
        {
            ProcessResult result = Run(option, value);
            Assert.That(result.ExitCode, Is.EqualTo(2), result.Output);
            Assert.That(result.Output, Does.StartWith("unity: "));
        }

        [Test]
        public void Project_OfOnesOwn_HasToKnowThePackage()
        {
            Directory.CreateDirectory(Full("Project/Packages"));
            Write("Project/Packages/manifest.json", "{ \"dependencies\": {} }");
            ProcessResult result = Run("--editor", Full("Unity"), "--project", Full("Project"), "--output", Full("out"));
            Assert.That(result.ExitCode, Is.EqualTo(2));
            Assert.That(result.Output, Does.Contain("testables"));
        }

        ProcessResult Run(params string[] arguments) => ProcessResult.Of("bash", [Script, .. arguments]);

        string Full(string path) => Path.Combine(folder, path);

        void Write(string path, string text) => File.WriteAllText(Full(path), text + Environment.NewLine);
    }
}
