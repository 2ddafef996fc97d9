using System;
using System.Collections.Generic;
using System.IO;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using AnatomyCarve.Headless.Tests.Scenes;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Headless.Tests.Import
{
    /// <summary>Importers that scripts bring, as the host runs them.</summary>
    public sealed class ScriptedImporterTests : ProjectTests
    {
        readonly List<string> m_Messages = new();

        [SetUp]
        public void Forget()
        {
            m_Messages.Clear();
            WordsImporter.Imports = 0;
            WordsPostprocessor.Heard.Clear();
        }

        void StartHost() => Start(o => (o.ExtraRoots, o.Log) = ([Project.Root], (type, text, _) => m_Messages.Add($"{type}: {text}")));

        string Asset(string path) => $"Assets/{Path.GetFileName(Project.Root)}/{path}";

        void Write(string path, string text, string settings = "") => Project.Write(path, System.Text.Encoding.UTF8.GetBytes(text), settings);

        string Settings<T>(string fields)
        {
            Project.Write($"Editor/{typeof(T).Name}.cs", $"namespace {typeof(T).Namespace} {{ }}");
            return "ScriptedImporter:\n  internalIDToNameTable: []\n  externalObjects: {}\n  serializedVersion: 2\n  userData: note\n  assetBundleName: \n"
                + $"  assetBundleVariant: \n  script: {{fileID: 11500000, guid: {Project.Guid($"Editor/{typeof(T).Name}.cs")}, type: 3}}\n{fields}";
        }

        Words Load(string path = "a.words") => AssetDatabase.LoadAssetAtPath<Words>(Asset(path));

        [Test]
        public void Import_ByExtension_GivesTheObjects()
        {
            Write("a.words", "one two");
            StartHost();
            var words = Load();
            Assert.That((words.words, words.name, words.text.text, words.text.name), Is.EqualTo((new[] { "one", "two" }, "a", "one two", "text")));
            Assert.That((AssetDatabase.GetAssetPath(words.text), AssetDatabase.IsMainAsset(words), AssetDatabase.IsSubAsset(words.text)),
                Is.EqualTo((Asset("a.words"), true, true)));
            Assert.That(m_Messages, Is.EqualTo(new[] { "Warning: there is no more" }));
        }

        [Test]
        public void Import_Twice_RunsOnce()
        {
            Write("a.words", "one two");
            StartHost();
            Assert.That((Load() == Load(), WordsImporter.Imports), Is.EqualTo((true, 1)));
        }

        [Test]
        public void Import_Settings_ComeFromTheMeta()
        {
            Write("a.words", "one,two", Settings<WordsImporter>("  separator: ','\n"));
            StartHost();
            Assert.That(Load().words, Is.EqualTo(new[] { "one", "two" }));
            Assert.That(AssetImporter.GetAtPath(Asset("a.words")).userData, Is.EqualTo("note"));
        }

        [Test]
        public void Import_UnknownSetting_IsRefused()
        {
            Write("a.words", "one", Settings<WordsImporter>("  seperator: ','\n"));
            StartHost();
            Assert.That(() => Load(), Throws.TypeOf<AssetFormatException>().With.Message.Contains("a.words.meta: line 11").And.Message.Contains("'seperator'"));
        }

        [Test]
        public void Import_ChangedSettings_ApplyWithReimport()
        {
            Write("a.words", "one,two three");
            StartHost();
            Assert.That(Load().words, Has.Length.EqualTo(2));
            var importer = (WordsImporter)AssetImporter.GetAtPath(Asset("a.words"));
            importer.Separator = ",";
            importer.SaveAndReimport();
            Assert.That(Load().words, Is.EqualTo(new[] { "one", "two three" }));
        }

        [Test]
        public void Import_ThatThrows_LeavesNoObjects()
        {
            Write("a.words", "one", Settings<WordsImporter>("  fails: 1\n"));
            StartHost();
            Assert.That((Load() == null, m_Messages[^1]), Is.EqualTo((true, "Exception: InvalidOperationException: the importer fails")));
        }

        [Test]
        public void Reference_ToAnImportedObject_LeadsToIt()
        {
            Write("a.words", "one two");
            var id = ImportedFileIds.Of("MonoBehaviour", "words");
            var textId = ImportedFileIds.Of("TextAsset", "text");
            var reference = $"guid: {Project.Guid("a.words")}, type: 3}}";
            Load(new Yaml().GameObject(10, "a", components: [12]).Script(12, 10, Project.Script<SceneFields>(),
                $"asset: {{fileID: {id}, {reference}\nanything: {{fileID: {textId}, {reference}").Roots(11));
            var fields = Find("a").GetComponent<SceneFields>();
            Assert.That((fields.asset.name, ((TextAsset)fields.anything).dataSize), Is.EqualTo(("a", 7L)));
        }

        [Test]
        public void Refresh_AfterADependencyCame_ImportsAnew()
        {
            Write("a.words", "one two");
            StartHost();
            Load();
            Write("a.more", "three");
            AssetDatabase.Refresh();
            Assert.That((Load().words, WordsImporter.Imports), Is.EqualTo((new[] { "one", "two", "three" }, 2)));
            AssetDatabase.Refresh();
            Load();
            Assert.That(WordsImporter.Imports, Is.EqualTo(2), "nothing changed");
        }

        [Test]
        public void Refresh_NewAndDeletedFiles_AreToldToPostprocessors()
        {
            Write("a.words", "one");
            StartHost();
            Write("b.words", "two");
            File.Delete(Path.Combine(Project.Root, "a.words"));
            File.Delete(Path.Combine(Project.Root, "a.words.meta"));
            AssetDatabase.Refresh();
            Assert.That((WordsPostprocessor.Heard, Load() == null), Is.EqualTo((new List<string> { "+a.words", "+b.words", "-a.words" }, true)));
        }

        [Test]
        public void Override_ByScript_ChoosesTheImporter()
        {
            Write("a.words", "one");
            StartHost();
            Load();
            AssetDatabase.SetImporterOverride<LettersImporter>(Asset("a.words"));
            Assert.That((Load().words, AssetDatabase.GetImporterOverride(Asset("a.words"))), Is.EqualTo((new[] { "o", "n", "e" }, typeof(LettersImporter))));
            AssetDatabase.ClearImporterOverride(Asset("a.words"));
            Assert.That((Load().words, AssetDatabase.GetImporterOverride(Asset("a.words"))), Is.EqualTo((new[] { "one" }, (Type)null)));
        }

        [Test]
        public void Override_InTheMeta_ChoosesTheImporter()
        {
            Write("a.words", "one", Settings<LettersImporter>(""));
            StartHost();
            Assert.That((Load().words, AssetDatabase.GetImporterType(Asset("a.words"))), Is.EqualTo((new[] { "o", "n", "e" }, typeof(LettersImporter))));
        }

        [Test]
        public void Override_WithAnImporterOfOtherFiles_IsRefused()
        {
            Write("a.letters", "one");
            StartHost();
            Assert.That(() => AssetDatabase.SetImporterOverride<WordsImporter>(Asset("a.letters")), Throws.InvalidOperationException);
        }

        [Test]
        public void Extension_ClaimedTwice_IsNobodys()
        {
            StartHost();
            Assert.That(new ImporterTypes([typeof(WordsImporter), typeof(RivalImporter)]).DefaultOf("a.words"), Is.Null);
            Assert.That(m_Messages, Has.Exactly(1).Contains("Multiple scripted importers are targeting the extension"));
        }

        [Test]
        public void Guids_And_Paths_LeadToEachOther()
        {
            Write("a.words", "one");
            StartHost();
            Assert.That(AssetDatabase.GUIDToAssetPath(Project.Guid("a.words")), Is.EqualTo(Asset("a.words")));
            Assert.That(AssetDatabase.AssetPathToGUID(Asset("a.words")), Is.EqualTo(Project.Guid("a.words")));
            Assert.That(AssetDatabase.AssetPathToGUID("Packages/com.anatomycarve.vr/package.json"), Has.Length.EqualTo(32));
            AssetDatabase.TryGetGUIDAndLocalFileIdentifier(Load(), out var guid, out var id);
            Assert.That((guid, id), Is.EqualTo((Project.Guid("a.words"), ImportedFileIds.Of("MonoBehaviour", "words"))));
        }

        [Test]
        public void Log_OfAnImport_IsKept()
        {
            Write("a.words", "one");
            StartHost();
            Assert.That(AssetImporter.GetImportLog(Asset("a.words")).logEntries[0].message, Is.EqualTo("there is no more"));
        }

        [TestCase("a.txt")]
        [TestCase("a.bytes")]
        [TestCase("a.json")]
        [TestCase("a.csv")]
        public void TextFiles_AreTextAssets(string name)
        {
            Write(name, "Grüße");
            StartHost();
            var asset = AssetDatabase.LoadAssetAtPath<TextAsset>(Asset(name));
            Assert.That((asset.text, asset.bytes.Length, asset.GetData<byte>().Length, asset.dataSize), Is.EqualTo(("Grüße", 7, 7, 7L)));
        }

        [Test]
        public void TextAsset_Data_EndsWithIt()
        {
            StartHost();
            var asset = new TextAsset(new byte[] { 1, 2, 3, 4 });
            var data = asset.GetData<ushort>();
            Assert.That((data[0], data[1]), Is.EqualTo((0x0201, 0x0403)));
            Object.DestroyImmediate(asset);
            Assert.That(() => data[0], Throws.TypeOf<ObjectDisposedException>());
        }

        [Test]
        public void TextAsset_Data_OfAnotherSize_IsRefused()
        {
            StartHost();
            var asset = new TextAsset("abc");
            Assert.That(() => asset.GetData<int>(), Throws.ArgumentException);
            Object.DestroyImmediate(asset);
        }
    }
}
