using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Layout
{
    /// <summary>
    /// Every scene, prefab and asset of the repository in Unity's text form, read as strictly as the host reads: fields exist, objects list each
    /// other, and every reference leads to an object, its fileID and type too. Nothing wakes up.
    /// </summary>
    public sealed class SerializedAssetTests
    {
        static readonly PackageTree Tree = PackageTree.OfRepository();

        UnityHost m_Host;

        [OneTimeSetUp]
        public void StartHost() => m_Host = UnityHost.Start(new HostOptions
        {
            PlayMode = false,
            ExtraRoots = Directory.GetDirectories(Tree.Full("Samples~")),
            Log = (_, _, _) => { },
        });

        [OneTimeTearDown]
        public void EndHost() => m_Host.Dispose();

        [TestCaseSource(nameof(Assets))]
        public void Asset_IsSound(string path) => Assert.That(m_Host.LoadAsset(path), Is.Not.Null);

        [TestCaseSource(nameof(Scenes))]
        public void Scene_IsSound(string path)
        {
            var roots = SceneFile.Load(Tree.Full(path), out _);
            Assert.That(roots, Is.Not.Empty);
            roots.ForEach(Object.DestroyImmediate);
        }

        static IEnumerable<string> Assets() => Tree.AllFiles.Where(f => Path.GetExtension(f) is ".asset" or ".prefab" or ".mat");

        static IEnumerable<string> Scenes() => Tree.AllFiles.Where(f => Path.GetExtension(f) == ".unity");
    }
}
