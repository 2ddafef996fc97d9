using NUnit.Framework;
using UnityEngine;
using UnityEngine.EventSystems;
using UnityEngine.UI;

namespace AnatomyCarve.Headless.Tests.Objects
{
    /// <summary>uGUI's components as data.</summary>
    public sealed class UiTests : SceneTests
    {
        [Test]
        public void Text_Added_HasUguisValues_AndACanvasRenderer()
        {
            var canvas = Make<Canvas>("canvas");
            var text = Make<Text>("text");
            text.transform.SetParent(canvas.transform);
            Assert.That((text.text, text.fontSize, text.color, text.raycastTarget, text.supportRichText), Is.EqualTo(("", 14, Color.white, true, true)));
            Assert.That((text.canvas, text.canvas.isRootCanvas), Is.EqualTo((canvas, true)));
            Assert.That(text.canvasRenderer != null, Is.True);
        }

        [Test]
        public void Text_Copied_KeepsItsFields()
        {
            var text = Make<Text>("text");
            text.text = "hint";
            text.fontSize = 22;
            text.color = Color.red;
            text.alignment = TextAnchor.LowerRight;
            text.text = null;
            Assert.That(text.text, Is.Empty, "null is no text");
            text.text = "hint";
            var copy = Object.Instantiate(text);
            Assert.That((copy.text, copy.fontSize, copy.color, copy.alignment), Is.EqualTo(("hint", 22, Color.red, TextAnchor.LowerRight)));
        }

        [Test]
        public void EventSystem_EnabledFirst_IsCurrent()
        {
            var first = Make<EventSystem>("first");
            var second = Make<EventSystem>("second");
            Assert.That(EventSystem.current, Is.SameAs(first));
            first.enabled = false;
            Assert.That(EventSystem.current, Is.SameAs(second));
            second.SetSelectedGameObject(first.gameObject);
            Assert.That((second.currentSelectedGameObject, second.IsPointerOverGameObject()), Is.EqualTo((first.gameObject, false)));
            Object.DestroyImmediate(second.gameObject);
            Assert.That(EventSystem.current, Is.Null);
        }

        [Test]
        public void EventSystem_OfWhichTheDriverSays_ThatThePointerIsOverUi_SaysSo()
        {
            var system = Make<EventSystem>("events");
            system.IsPointerOver = true;
            Assert.That(EventSystem.current.IsPointerOverGameObject(), Is.True);
        }

        [Test]
        public void CanvasGroup_Copied_KeepsItsValues()
        {
            var group = Make<CanvasGroup>("group");
            group.alpha = 0.25f;
            group.blocksRaycasts = false;
            var copy = Object.Instantiate(group);
            Assert.That((copy.alpha, copy.blocksRaycasts, copy.interactable), Is.EqualTo((0.25f, false, true)));
        }
    }
}
