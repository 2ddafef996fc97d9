using NUnit.Framework;
using UnityEngine.InputSystem;

namespace AnatomyCarve.Headless.Tests.Input
{
    /// <summary>What people are told to press, with and without such a device.</summary>
    public sealed class DisplayStringTests : InputTests
    {
        [TestCase("<Mouse>/rightButton", "RMB", true)]
        [TestCase("<Mouse>/rightButton", "RMB", false)]
        [TestCase("<Mouse>/scroll/y", "Wheel", true)]
        [TestCase("<Keyboard>/leftBracket", "[", true)]
        [TestCase("<Keyboard>/leftBracket", "[", false)]
        [TestCase("<Keyboard>/pageUp", "Page Up", false)]
        [TestCase("<XRController>{LeftHand}/{PrimaryButton}", "PrimaryButton", false)]
        public void Binding_ToAControl_IsCalledAsPeopleDo(string path, string expected, bool isThere)
        {
            if (isThere)
            {
                InputSystem.AddDevice<Mouse>();
                InputSystem.AddDevice<Keyboard>();
            }

            var action = new InputAction("action", InputActionType.Button, path);
            Assert.That(action.GetBindingDisplayString(), Is.EqualTo(expected));
        }

        [Test]
        public void Binding_WithItsLongNameAndDevice_IsToldInFull()
        {
            var action = new InputAction("action", InputActionType.Button, "<Mouse>/rightButton");
            const InputBinding.DisplayStringOptions Full =
                InputBinding.DisplayStringOptions.DontUseShortDisplayNames | InputBinding.DisplayStringOptions.DontOmitDevice;
            Assert.That(action.GetBindingDisplayString(Full), Is.EqualTo("Right Button [Mouse]"));
            InputSystem.AddDevice<Mouse>();
            Assert.That(action.GetBindingDisplayString(Full), Is.EqualTo("Right Button [Mouse]"));
        }

        [Test]
        public void Composites_AndSeveralBindings_AreJoined()
        {
            InputSystem.AddDevice<Keyboard>();
            var action = new InputAction("undo", InputActionType.Button);
            action.AddCompositeBinding("OneModifier").With("modifier", "<Keyboard>/ctrl").With("binding", "<Keyboard>/z");
            action.AddBinding("<Keyboard>/backspace");
            Assert.That(action.GetBindingDisplayString(), Is.EqualTo("Control+Z | Backspace"));
            Assert.That(action.GetBindingDisplayString(0, out string device, out string path), Is.EqualTo("Control+Z"));
            Assert.That((device, path), Is.EqualTo(((string)null, (string)null)));
            action.GetBindingDisplayString(3, out device, out path);
            Assert.That((device, path), Is.EqualTo(("Keyboard", "backspace")));
        }

        [Test]
        public void Vector_OfFourKeys_ReadsWasd()
        {
            var action = new InputAction("move", InputActionType.Value);
            action.AddCompositeBinding("2DVector").With("Up", "<Keyboard>/w").With("Down", "<Keyboard>/s").With("Left", "<Keyboard>/a").With("Right", "<Keyboard>/d");
            Assert.That(action.GetBindingDisplayString(), Is.EqualTo("W/A/S/D"));
        }
    }
}
