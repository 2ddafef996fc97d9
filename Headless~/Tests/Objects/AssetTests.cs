using System;
using System.Collections.Generic;
using System.IO;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Serialization;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Headless.Tests.Objects
{
    /// <summary>An asset's script with fields of many kinds.</summary>
    public sealed class SampleAsset : ScriptableObject
    {
        public int number = 1;
        public int untouched = 42;
        public bool flag;
        public string text;
        public Vector3 vector;
        public Color color;
        public int[] packed;
        public List<float> list;
        public Inner inner;
        public SampleAsset other;
        public SampleAsset nothing;
        public DayOfWeek day;

        [FormerlySerializedAs("oldName")]
        public string newName;

        internal int NumberOnEnable { get; private set; }

        void OnEnable() => NumberOnEnable = number;
    }

    public sealed class AssetTests : SceneTests
    {
        const string ScriptGuid = "11111111111111111111111111111111";
        const string OtherGuid = "22222222222222222222222222222222";

        string m_Root;

        [SetUp]
        public void MakePackage()
        {
            m_Root = Path.Combine(TestContext.CurrentContext.WorkDirectory, "assets-" + Guid.NewGuid().ToString("N"));
            Write("Runtime/SampleAsset.cs", "namespace AnatomyCarve.Headless.Tests.Objects { }", ScriptGuid);
            Write("Runtime/Resources/Other.asset", Yaml("  m_Name: Other\n  number: 9"), OtherGuid);
        }

        [TearDown]
        public void RemovePackage()
        {
            AssetLibrary.Unload();
            Directory.Delete(m_Root, true);
            AssetLibrary.AddRoot(ObjectsSetUp.Host.PackageRoot);
        }

        void Write(string path, string content, string guid)
        {
            var full = Path.Combine(m_Root, path);
            Directory.CreateDirectory(Path.GetDirectoryName(full));
            File.WriteAllText(full, content);
            File.WriteAllText(full + ".meta", $"fileFormatVersion: 2\nguid: {guid}\n");
        }

        static string Yaml(string fields) => "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!114 &11400000\nMonoBehaviour:\n" +
            "  m_ObjectHideFlags: 0\n  m_CorrespondingSourceObject: {fileID: 0}\n  m_PrefabInstance: {fileID: 0}\n  m_PrefabAsset: {fileID: 0}\n  "
                + "m_GameObject: {fileID: 0}\n" +
            $"  m_Enabled: 1\n  m_EditorHideFlags: 0\n  m_Script: {{fileID: 11500000, guid: {ScriptGuid}, type: 3}}\n  m_EditorClassIdentifier: \n{fields}\n";

        SampleAsset Load(string fields)
        {
            Write("Runtime/Resources/Folder/Sample.asset", Yaml("  m_Name: Sample\n" + fields), "33333333333333333333333333333333");
            AssetLibrary.AddRoot(m_Root);
            return Resources.Load<SampleAsset>("Folder/Sample");
        }

        [Test]
        public void Load_ReadsNumbersBoolsStringsAndEnums()
        {
            var asset = Load("  number: -5\n  flag: 1\n  text: two words\n  day: 3");
            Assert.That((asset.number, asset.flag, asset.text, asset.day), Is.EqualTo((-5, true, "two words", DayOfWeek.Wednesday)));
        }

        [Test]
        public void Load_ReadsVectorsAndColors()
        {
            var asset = Load("  vector: {x: 1, y: 2.5, z: -3}\n  color: {r: 0.1, g: 0.2, b: 0.3, a: 1}");
            Assert.That((asset.vector, asset.color), Is.EqualTo((new Vector3(1f, 2.5f, -3f), new Color(0.1f, 0.2f, 0.3f, 1f))));
        }

        [Test]
        public void Load_ReadsPackedIntegers() => Assert.That(Load("  packed: 01000000ffffffff").packed, Is.EqualTo(new[] { 1, -1 }));

        [Test]
        public void Load_ReadsLists() => Assert.That(Load("  list:\n  - 1\n  - 2.5").list, Is.EqualTo(new[] { 1f, 2.5f }));

        [Test]
        public void Load_ReadsNestedData() => Assert.That(Load("  inner:\n    number: 4\n    text: deep").inner.text, Is.EqualTo("deep"));

        [Test]
        public void Load_ResolvesReferencesByGuid() =>
            Assert.That(Load($"  other: {{fileID: 11400000, guid: {OtherGuid}, type: 2}}").other.number, Is.EqualTo(9));

        [Test]
        public void Load_OfFileIdZero_IsNull() => Assert.That(Load("  nothing: {fileID: 0}").nothing == null, Is.True);

        [Test]
        public void Load_WithoutAField_KeepsItsInitialValue() => Assert.That(Load("  number: 2").untouched, Is.EqualTo(42));

        [Test]
        public void Load_WithFormerName_FillsTheField() => Assert.That(Load("  oldName: kept").newName, Is.EqualTo("kept"));

        [Test]
        public void Load_SendsOnEnableAfterTheFields() => Assert.That(Load("  number: 6").NumberOnEnable, Is.EqualTo(6));

        [Test]
        public void Load_NamesTheObject() => Assert.That(Load("  number: 6").name, Is.EqualTo("Sample"));

        [Test]
        public void Load_Twice_GivesTheSameObject()
        {
            var first = Load("  number: 6");
            Assert.That(Resources.Load<SampleAsset>("Folder/Sample"), Is.SameAs(first));
        }

        [Test]
        public void Load_OfUnknownField_Throws() =>
            Assert.That(() => Load("  unknown: 1"), Throws.TypeOf<AssetFormatException>().With.Message.Contains("'unknown'"));

        [Test]
        public void Load_OfUnknownGuid_Throws() =>
            Assert.That(() => Load("  other: {fileID: 11400000, guid: 99999999999999999999999999999999, type: 2}"),
                Throws.TypeOf<AssetFormatException>().With.Message.Contains("99999"));

        [Test]
        public void Load_OfReferenceToAnotherType_Throws() =>
            Assert.That(() => Load($"  other: {{fileID: 11500000, guid: {ScriptGuid}, type: 3}}"), Throws.TypeOf<AssetFormatException>());

        [Test]
        public void Load_OfUnknownScript_Throws()
        {
            Write("Runtime/Resources/Lost.asset", Yaml("  m_Name: Lost").Replace(ScriptGuid, "44444444444444444444444444444444", StringComparison.Ordinal),
                "55555555555555555555555555555555");
            AssetLibrary.AddRoot(m_Root);
            Assert.That(() => Resources.Load<Object>("Lost"), Throws.TypeOf<AssetFormatException>().With.Message.Contains("44444"));
        }

        [Test]
        public void Load_OfMissingPath_IsNull()
        {
            AssetLibrary.AddRoot(m_Root);
            Assert.That(Resources.Load<SampleAsset>("Missing"), Is.Null);
        }

        [Test]
        public void FilesInHiddenFolders_AreNoAssets()
        {
            Write("Samples~/Resources/Hidden.asset", Yaml("  m_Name: Hidden"), "66666666666666666666666666666666");
            AssetLibrary.AddRoot(m_Root);
            Assert.That(Resources.Load<SampleAsset>("Hidden"), Is.Null);
        }

        [Test]
        public void SameGuidTwice_Throws()
        {
            Write("Runtime/Copy.asset", Yaml("  m_Name: Copy"), OtherGuid);
            Assert.That(() => AssetLibrary.AddRoot(m_Root), Throws.TypeOf<AssetFormatException>().With.Message.Contains("same GUID"));
        }
    }
}
