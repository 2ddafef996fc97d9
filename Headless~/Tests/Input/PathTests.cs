using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.Controls;
using UnityEngine.InputSystem.Layouts;
using UnityEngine.InputSystem.XR;

namespace AnatomyCarve.Headless.Tests.Input
{
    /// <summary>Which controls a path means.</summary>
    public sealed class PathTests : InputTests
    {
        [SetUp]
        public void RegisterController() => InputSystem.RegisterLayout(typeof(TouchController));

        [TestCase("<Mouse>/leftButton", "/Mouse/leftButton")]
        [TestCase("<mouse>/LEFTBUTTON", "/Mouse/leftButton")]
        [TestCase("<Pointer>/press", "/Mouse/press")]
        [TestCase("<Mouse>/{PrimaryAction}", "/Mouse/leftButton")]
        [TestCase("<Mouse>/scroll/y", "/Mouse/scroll/y")]
        [TestCase("<Mouse>/scroll/vertical", "/Mouse/scroll/y")]
        [TestCase("<Mouse>/{ScrollVertical}", "/Mouse/scroll/y")]
        [TestCase("/Mouse/position", "/Mouse/position")]
        [TestCase("<Keyboard>/leftCtrl", "/Keyboard/leftCtrl")]
        [TestCase("<Keyboard>/ctrl", "/Keyboard/ctrl")]
        [TestCase("<Keyboard>/#(A)", "/Keyboard/a")]
        [TestCase("<Keyboard>/LeftWindows", "/Keyboard/leftMeta")]
        [TestCase("*/leftButton", "/Mouse/leftButton")]
        [TestCase("<XRController>{LeftHand}/{PrimaryButton}", "/TouchController/xButton")]
        [TestCase("<XRController>{RightHand}/{PrimaryButton}", "/TouchController1/xButton")]
        [TestCase("<TouchController>{LeftHand}/thumbstick/up", "/TouchController/thumbstick/up")]
        [TestCase("<XRController>{LeftHand}/{Primary2DAxis}", "/TouchController/thumbstick")]
        public void FindControl_ByPath_FindsIt(string path, string expected)
        {
            AddAll();
            Assert.That(InputSystem.FindControl(path)?.path, Is.EqualTo(expected));
        }

        [TestCase("<Mouse>/leftbuttons")]
        [TestCase("<Keyboard>/leftButton")]
        [TestCase("<Gamepad>/leftStick")]
        [TestCase("<XRController>{BothHands}/{PrimaryButton}")]
        [TestCase("<XRController>{LeftHand}/{SecondaryButton}")]
        public void FindControl_ThatIsNotThere_IsNull(string path)
        {
            AddAll();
            Assert.That(InputSystem.FindControl(path), Is.Null);
        }

        [Test]
        public void TryFindControls_WithAWildcard_FindsAll()
        {
            var mouse = InputSystem.AddDevice<Mouse>();
            Assert.That(InputControlPath.TryFindControls(mouse, "<Mouse>/*Button").Select(c => c.name),
                Is.EquivalentTo(new[] { "leftButton", "rightButton", "middleButton", "forwardButton", "backButton" }));
        }

        [TestCase("<Mouse/leftButton")]
        [TestCase("<Mouse>//leftButton")]
        [TestCase("<XRController>{LeftHand/primaryButton")]
        public void FindControl_OfAMalformedPath_SaysSo(string path)
        {
            AddAll();
            Assert.That(() => InputSystem.FindControl(path), Throws.TypeOf<FormatException>().With.Message.Contains(path));
        }

        [Test]
        public void Matches_AControl_TellsWhetherItIsMeant()
        {
            var mouse = InputSystem.AddDevice<Mouse>();
            Assert.That(InputControlPath.Matches("<Pointer>/position", mouse.position), Is.True);
            Assert.That(InputControlPath.Matches("<Pointer>/position", mouse.delta), Is.False);
        }

        [TestCase("<XRController>{LeftHand}/{PrimaryButton}", "XRController", "LeftHand")]
        [TestCase("<Mouse>/leftButton", "Mouse", null)]
        public void Device_OfAPath_IsTold(string path, string layout, string usage)
        {
            Assert.That(InputControlPath.TryGetDeviceLayout(path), Is.EqualTo(layout));
            Assert.That(InputControlPath.TryGetDeviceUsages(path)?.Single(), Is.EqualTo(usage));
        }

        [Test]
        public void Hands_OfControllers_AreFoundByUsage()
        {
            AddAll();
            Assert.That((XRController.leftHand.name, XRController.rightHand.name), Is.EqualTo(("TouchController", "TouchController1")));
            InputSystem.SetDeviceUsage(XRController.leftHand, null);
            Assert.That(XRController.leftHand, Is.Null);
        }

        [Test]
        public void Rotation_OfATrackedDevice_IsAtRestTheIdentity()
        {
            var device = InputSystem.AddDevice<TouchController>();
            Assert.That(device.deviceRotation.ReadValue(), Is.EqualTo(UnityEngine.Quaternion.identity));
            InputSystem.QueueDeltaStateEvent(device.deviceRotation, UnityEngine.Quaternion.Euler(0, 90, 0));
            Frame();
            Assert.That(device.deviceRotation.ReadValue().eulerAngles.y, Is.EqualTo(90f).Within(1e-3f));
        }

        static void AddAll()
        {
            InputSystem.AddDevice<Mouse>();
            InputSystem.AddDevice<Keyboard>();
            InputSystem.SetDeviceUsage(InputSystem.AddDevice<TouchController>(), "LeftHand");
            InputSystem.SetDeviceUsage(InputSystem.AddDevice<TouchController>(), "RightHand");
        }

        /// <summary>A controller such as a headset's package brings.</summary>
        [InputControlLayout(commonUsages = ["LeftHand", "RightHand"])]
        public class TouchController : XRController
        {
            [InputControl(usage = "PrimaryButton")]
            public ButtonControl xButton { get; protected set; }

            [InputControl(usage = "Primary2DAxis", processors = "stickDeadzone")]
            public StickControl thumbstick { get; protected set; }
        }
    }
}
