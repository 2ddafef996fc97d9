using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Scenes
{
    /// <summary>Components of which the host has only the data: of Unity's packages, and engine classes that nothing here needs.</summary>
    public sealed class PackageScriptTests : ProjectTests
    {
        const string XrOrigin = "{fileID: 11500000, guid: e0cb9aa70a22847b5925ee5f067c10a9, type: 3}";
        const string CameraData = "{fileID: 11500000, guid: a79441f348de89743a2939f4d699eac1, type: 3}";
        const string InputModule = "{fileID: 11500000, guid: 01614664b831546d2ae94a42149d80ac, type: 3}";

        Yaml With(string script, string fields) => new Yaml().GameObject(10, "a", components: [12, 13]).Script(12, 10, script, fields)
            .Script(13, 10, Project.Script<SceneFields>(), "anything: {fileID: 12}").Roots(11);

        static DataComponent Data => (DataComponent)Find("a").GetComponent<SceneFields>().anything;

        [Test]
        public void Script_OfADependencysDependency_IsLoadedAsData()
        {
            Load(With(XrOrigin, "m_Camera: {fileID: 0}\nm_CameraYOffset: 1.36"));
            var offset = Data.Document.Scalar(YamlNodes.Child(Data.Document.Body, "m_CameraYOffset"));
            Assert.That((Data.TypeName, offset), Is.EqualTo(("Unity.XR.CoreUtils.XROrigin", "1.36")));
        }

        [Test]
        public void Script_OfAPackageInstalledByTheHost_IsLoadedAsData()
        {
            var scene = With(CameraData, "m_RenderShadows: 1");
            Start(o => o.Packages = ["com.unity.render-pipelines.universal"]);
            Load(scene);
            Assert.That(Data.TypeName, Is.EqualTo("UnityEngine.Rendering.Universal.UniversalAdditionalCameraData"));
        }

        [Test]
        public void References_OfData_AreCheckedToo()
        {
            var path = Project.Write("Test.unity", With(XrOrigin, "m_Camera: {fileID: 4711}").ToString());
            Assert.That(() => Host.LoadScene(path), Throws.TypeOf<AssetFormatException>().With.Message.Contains("4711"));
        }

        [Test]
        public void Reference_ToAnAssetOfAPackage_IsKnown()
        {
            Load(With(InputModule, "m_ActionsAsset: {fileID: -944628639613478452, guid: ca9f5fa95ffab41fb9a615ab714db018, type: 3}\n"
                + "m_PointAction: {fileID: -1654692200621890270, guid: ca9f5fa95ffab41fb9a615ab714db018, type: 3}"));
            Assert.That(Data.TypeName, Is.EqualTo("UnityEngine.InputSystem.UI.InputSystemUIInputModule"));
        }

        [Test]
        public void Reference_ToAnUnknownPartOfAPackagesAsset_IsRefused()
        {
            var path = Project.Write("Test.unity", With(InputModule, "m_PointAction: {fileID: 5, guid: ca9f5fa95ffab41fb9a615ab714db018, type: 3}").ToString());
            Assert.That(() => Host.LoadScene(path), Throws.TypeOf<AssetFormatException>().With.Message.Contains("DefaultInputActions"));
        }

        [Test]
        public void Component_OfTheEngine_ThatTheHostLacks_IsLoadedAsData()
        {
            Load(new Yaml().GameObject(10, "a", components: [12, 13])
                .Add(54, "Rigidbody", 12, "m_GameObject: {fileID: 10}\nserializedVersion: 4\nm_Mass: 2\nm_Drag: 0")
                .Script(13, 10, Project.Script<SceneFields>(), "anything: {fileID: 12}").Roots(11));
            Assert.That(Data.TypeName, Is.EqualTo("UnityEngine.Rigidbody"));
        }

        [Test]
        public void Instantiate_OfData_CopiesIt()
        {
            Load(With(XrOrigin, "m_CameraYOffset: 1.36"));
            var copy = Object.Instantiate(Find("a")).GetComponent<SceneFields>();
            Assert.That(copy.anything, Is.SameAs(copy.GetComponent<DataComponent>()));
            Assert.That(((DataComponent)copy.anything).TypeName, Is.EqualTo("Unity.XR.CoreUtils.XROrigin"));
        }

        [Test]
        public void Reference_ToABuiltinResource_IsKnown()
        {
            Load(With(XrOrigin, "m_Mesh: {fileID: 10202, guid: 0000000000000000e000000000000000, type: 0}"));
            Assert.That(Data, Is.Not.Null);
        }
    }
}
