using System.Text;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Import
{
    /// <summary>The numbers of imported objects, against those that Unity itself wrote into public scenes.</summary>
    public sealed class ImportedFileIdsTests
    {
        [TestCase("<root>", -944628639613478452)]
        [TestCase("33754c03-48ec-46ef-9bc6-22ed6bfdd8e8", -6131295136447488360)]
        // The user interface's actions of the Input System's DefaultInputActions.
        [TestCase("c95b2375-e6d9-4b88-9c4c-c5e76515df4b", -8784545083839296357)]
        [TestCase("32b35790-4ed0-4e9a-aa41-69ac6d629449", -1654692200621890270)]
        public void Id_OfAnInputAction_IsUnitys(string identifier, long expected) =>
            Assert.That(ImportedFileIds.Of("MonoBehaviour", identifier), Is.EqualTo(expected));

        [Test]
        public void Id_OfAScript_IsThatOfMonoBehaviour()
        {
            using var host = UnityHost.Start(new HostOptions { Log = (_, _, _) => { } });
            var asset = ScriptableObject.CreateInstance<Plain>();
            Assert.That(ImportedFileIds.Of(asset, "<root>"), Is.EqualTo(-944628639613478452));
            Object.DestroyImmediate(asset);
        }

        // Values of the reference implementation, as its documentation and test data give them.
        [TestCase("", 0xEF46DB3751D8E999)]
        [TestCase("a", 0xD24EC4F1A98C6E5B)]
        [TestCase("abc", 0x44BC2CF5AD770999ul)]
        [TestCase("Nobody inspects the spammish repetition", 0xFBCEA83C8A378BF1)]
        public void Hash_OfAKnownText_IsTheReferences(string text, ulong expected) =>
            Assert.That(XxHash64.Of(Encoding.UTF8.GetBytes(text)), Is.EqualTo(expected));

        sealed class Plain : ScriptableObject
        {
        }
    }
}
