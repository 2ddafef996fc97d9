using NUnit.Framework;
using UnityEngine;
using UnityEngine.EventSystems;
using UnityEngine.InputSystem;
using UnityEngine.UI;

namespace AnatomyCarve.Headless.Tests.Scenes
{
    /// <summary>User interface and input in scenes: where the host has a class for a package's script, that class is used.</summary>
    public sealed class UserInterfaceSceneTests : ProjectTests
    {
        static string PackageScript(string guid) => $"{{fileID: 11500000, guid: {guid}, type: 3}}";

        Yaml Canvas() => new Yaml()
            .Add(1, "GameObject", 10, "m_Component:\n- component: {fileID: 11}\n- component: {fileID: 12}\n- component: {fileID: 13}\n"
                + "- component: {fileID: 14}\nm_Layer: 5\nm_Name: canvas")
            .Add(224, "RectTransform", 11, "m_GameObject: {fileID: 10}\nm_Children:\n- {fileID: 21}\nm_Father: {fileID: 0}\nm_SizeDelta: {x: 800, y: 600}")
            .Add(223, "Canvas", 12, "m_GameObject: {fileID: 10}\nm_Enabled: 1\nserializedVersion: 3\nm_RenderMode: 1\nm_Camera: {fileID: 32}\n"
                + "m_PlaneDistance: 3\nm_SortingOrder: 7")
            .Script(13, 10, PackageScript("0cd44c1031e13a943bb63640046fad76"), "m_UiScaleMode: 1\nm_ReferenceResolution: {x: 800, y: 600}")
            .Add(225, "CanvasGroup", 14, "m_GameObject: {fileID: 10}\nm_Enabled: 1\nm_Alpha: 0.5")
            .Add(1, "GameObject", 20, "m_Component:\n- component: {fileID: 21}\n- component: {fileID: 22}\n- component: {fileID: 23}\nm_Layer: 5\nm_Name: text")
            .Add(224, "RectTransform", 21, "m_GameObject: {fileID: 20}\nm_Children: []\nm_Father: {fileID: 11}")
            .Add(222, "CanvasRenderer", 22, "m_GameObject: {fileID: 20}\nm_CullTransparentMesh: 0")
            .Script(23, 20, PackageScript("5f7201a12d95ffc409449d95f23cf332"), "m_Color: {r: 1, g: 0, b: 0, a: 1}\nm_RaycastTarget: 0\n"
                + "m_Material: {fileID: 0}\nm_FontData:\n"
                + "  m_Font: {fileID: 10102, guid: 0000000000000000e000000000000000, type: 0}\n  m_FontSize: 21\nm_Text: two words")
            .GameObject(30, "camera", components: [32]).Add(20, "Camera", 32, "m_GameObject: {fileID: 30}\nm_Enabled: 1");

        [Test]
        public void Load_Canvas_HasItsSettings()
        {
            Load(Canvas().Roots(11, 31));
            var canvas = Find("canvas").GetComponent<Canvas>();
            var alpha = Find("canvas").GetComponent<CanvasGroup>().alpha;
            Assert.That((canvas.renderMode, canvas.worldCamera.name, canvas.planeDistance, canvas.sortingOrder, alpha),
                Is.EqualTo((RenderMode.ScreenSpaceCamera, "camera", 3f, 7, 0.5f)));
        }

        [Test]
        public void Load_Text_IsTheHostsOwn()
        {
            Load(Canvas().Roots(11, 31));
            var text = Find("text").GetComponent<Text>();
            Assert.That((text.text, text.fontSize, text.color, text.raycastTarget, text.enabled), Is.EqualTo(("two words", 21, Color.red, false, true)));
            Assert.That(Find("text").GetComponent<CanvasRenderer>().cullTransparentMesh, Is.False);
        }

        [Test]
        public void Load_EventSystem_IsTheCurrentOne()
        {
            Load(new Yaml().GameObject(10, "events", components: [12, 13]).Script(12, 10, PackageScript("76c392e42b5098c458856cdf6ecaaaa1"))
                .Script(13, 10, PackageScript("01614664b831546d2ae94a42149d80ac"),
                    "m_ActionsAsset: {fileID: -944628639613478452, guid: ca9f5fa95ffab41fb9a615ab714db018, type: 3}").Roots(11));
            Assert.That(EventSystem.current, Is.SameAs(Find("events").GetComponent<EventSystem>()));
        }

        [Test]
        public void Reference_ToInputActions_LeadsToAssetAndAction()
        {
            const string Guid = "e6895ed7-94fb-4990-b9a5-f4e1a77cbf85";
            Project.Write("Controls.inputactions", "{ \"name\": \"Controls\", \"maps\": [ { \"name\": \"Left\", "
                + "\"id\": \"6b767880-046a-44aa-9540-dc5624a16dfc\", "
                + $"\"actions\": [ {{ \"name\": \"Resize\", \"type\": \"Value\", \"id\": \"{Guid}\", \"expectedControlType\": \"Vector2\" }} ], "
                + "\"bindings\": [] } ], \"controlSchemes\": [] }");
            var asset = Project.Guid("Controls.inputactions");
            Load(new Yaml().GameObject(10, "a", components: [12]).Script(12, 10, Project.Script<SceneFields>(),
                $"asset: {{fileID: {ImportedFileIds.Of("MonoBehaviour", "<root>")}, guid: {asset}, type: 3}}\n"
                    + $"anything: {{fileID: 2354774633713466350, guid: {asset}, type: 3}}").Roots(11));
            var fields = Find("a").GetComponent<SceneFields>();
            Assert.That((((InputActionAsset)fields.asset).FindAction("Left/Resize") != null, ((InputActionReference)fields.anything).action.name),
                Is.EqualTo((true, "Resize")));
        }
    }
}
