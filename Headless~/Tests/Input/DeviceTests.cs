using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.LowLevel;

namespace AnatomyCarve.Headless.Tests.Input
{
    /// <summary>Devices: their state comes in once a frame, before Update.</summary>
    public sealed class DeviceTests : InputTests
    {
        [Test]
        public void Mouse_QueuedState_ComesInBeforeUpdate()
        {
            var mouse = InputSystem.AddDevice<Mouse>();
            var seen = new GameObject("reader").AddComponent<MouseReader>();
            InputSystem.QueueStateEvent(mouse, new MouseState { position = new Vector2(12, 34) });
            Assert.That(mouse.position.ReadValue(), Is.EqualTo(Vector2.zero), "not yet");
            Frame();
            UnityEngine.Object.DestroyImmediate(seen.gameObject);
            Assert.That(seen.InUpdate, Is.EqualTo(new Vector2(12, 34)));
        }

        [Test]
        public void MouseDelta_OfSeveralEvents_AddsUpAndGoesBackToZero()
        {
            var mouse = InputSystem.AddDevice<Mouse>();
            InputSystem.QueueStateEvent(mouse, new MouseState { delta = new Vector2(1, 2), scroll = new Vector2(0, 1) });
            Send(mouse, new MouseState { delta = new Vector2(10, 20), scroll = new Vector2(0, 1) });
            Assert.That((mouse.delta.ReadValue(), mouse.scroll.ReadValue()), Is.EqualTo((new Vector2(11, 22), new Vector2(0, 2))));
            Frame();
            Assert.That((mouse.delta.ReadValue(), mouse.scroll.ReadValue()), Is.EqualTo((Vector2.zero, Vector2.zero)));
        }

        [Test]
        public void DeltaControl_Directions_AreNeverNegative()
        {
            var mouse = InputSystem.AddDevice<Mouse>();
            Send(mouse, new MouseState { delta = new Vector2(-3, 4) });
            Assert.That(
                (mouse.delta.left.ReadValue(), mouse.delta.right.ReadValue(), mouse.delta.up.ReadValue(), mouse.delta.down.ReadValue()),
                Is.EqualTo((3f, 0f, 4f, 0f)));
        }

        [Test]
        public void Button_PressedAndReleased_SaysSoForOneFrame()
        {
            var mouse = InputSystem.AddDevice<Mouse>();
            Send(mouse, new MouseState().WithButton(MouseButton.Right));
            Assert.That((mouse.rightButton.isPressed, mouse.rightButton.wasPressedThisFrame, mouse.leftButton.isPressed), Is.EqualTo((true, true, false)));
            Frame();
            Assert.That((mouse.rightButton.isPressed, mouse.rightButton.wasPressedThisFrame), Is.EqualTo((true, false)));
            Send(mouse, new MouseState());
            Assert.That((mouse.rightButton.isPressed, mouse.rightButton.wasReleasedThisFrame), Is.EqualTo((false, true)));
            Frame();
            Assert.That(mouse.rightButton.wasReleasedThisFrame, Is.False);
        }

        [Test]
        public void Button_PressedAndReleasedWithinAFrame_WasPressed()
        {
            var mouse = InputSystem.AddDevice<Mouse>();
            Assert.That(mouse.leftButton.wasPressedThisFrame, Is.False, "from now on presses are counted");
            InputSystem.QueueStateEvent(mouse, new MouseState().WithButton(MouseButton.Left));
            Send(mouse, new MouseState());
            Assert.That(
                (mouse.leftButton.isPressed, mouse.leftButton.wasPressedThisFrame, mouse.leftButton.wasReleasedThisFrame), Is.EqualTo((false, true, true)));
        }

        [TestCase(Key.LeftShift)]
        [TestCase(Key.RightShift)]
        public void Keyboard_EitherShift_IsShift(Key key)
        {
            var keyboard = InputSystem.AddDevice<Keyboard>();
            Press(keyboard, key);
            Assert.That((keyboard.shiftKey.isPressed, keyboard.ctrlKey.isPressed, keyboard[key].isPressed), Is.EqualTo((true, false, true)));
        }

        [TestCase(Key.LeftCtrl)]
        [TestCase(Key.RightCtrl)]
        public void Keyboard_EitherControl_IsControl(Key key)
        {
            var keyboard = InputSystem.AddDevice<Keyboard>();
            Press(keyboard, key);
            Assert.That((keyboard.ctrlKey.isPressed, keyboard.altKey.isPressed), Is.EqualTo((true, false)), "the two bits lie in two bytes");
        }

        [Test]
        public void Keyboard_EachKey_HasItsOwnControl()
        {
            var keyboard = InputSystem.AddDevice<Keyboard>();
            foreach (var key in keyboard.allKeys)
            {
                Press(keyboard, key.keyCode);
                foreach (var other in keyboard.allKeys)
                    Assert.That(other.isPressed, Is.EqualTo(other == key), $"{other.name} while {key.name} is down");
                Assert.That(keyboard.anyKey.isPressed, Is.True, key.name);
            }

            Press(keyboard);
            Assert.That(keyboard.anyKey.isPressed, Is.False);
            Assert.That(keyboard.allKeys.Count, Is.EqualTo(110));
        }

        [TestCase(Key.Digit1, "1", "1")]
        [TestCase(Key.LeftCtrl, "leftCtrl", "Left Control")]
        [TestCase(Key.LeftBracket, "leftBracket", "[")]
        [TestCase(Key.UpArrow, "upArrow", "Up Arrow")]
        [TestCase(Key.Numpad7, "numpad7", "Numpad 7")]
        [TestCase(Key.PageDown, "pageDown", "Page Down")]
        [TestCase(Key.F12, "f12", "F12")]
        [TestCase(Key.RightAlt, "rightAlt", "Right Alt")]
        [TestCase(Key.LeftMeta, "leftMeta", "Left System")]
        public void Key_Names_AreUnitys(Key key, string name, string displayName)
        {
            var control = InputSystem.AddDevice<Keyboard>()[key];
            Assert.That((control.name, control.displayName), Is.EqualTo((name, displayName)));
        }

        [Test]
        public void QueueDeltaStateEvent_OfOneControl_LeavesTheOthers()
        {
            var mouse = InputSystem.AddDevice<Mouse>();
            Send(mouse, new MouseState { position = new Vector2(5, 6) }.WithButton(MouseButton.Left));
            InputSystem.QueueDeltaStateEvent(mouse.position, new Vector2(7, 8));
            Frame();
            Assert.That((mouse.position.ReadValue(), mouse.leftButton.isPressed), Is.EqualTo((new Vector2(7, 8), true)));
        }

        [Test]
        public void QueueDeltaStateEvent_OfABit_IsRefused()
        {
            var mouse = InputSystem.AddDevice<Mouse>();
            Assert.That(() => InputSystem.QueueDeltaStateEvent(mouse.rightButton, (byte)1), Throws.InvalidOperationException.With.Message.Contains("rightButton"));
        }

        [Test]
        public void QueueStateEvent_OfAnotherKindOfDevice_IsRefused()
        {
            var mouse = InputSystem.AddDevice<Mouse>();
            Assert.That(() => InputSystem.QueueStateEvent(mouse, new KeyboardState()), Throws.ArgumentException.With.Message.Contains("MOUS"));
        }

        [Test]
        public void RemovedDevice_IsNotCurrentAnyMore_AndTakesNoEvents()
        {
            var mouse = InputSystem.AddDevice<Mouse>();
            Assert.That((Mouse.current, Pointer.current), Is.EqualTo((mouse, mouse)));
            InputSystem.RemoveDevice(mouse);
            Assert.That((Mouse.current, Pointer.current, mouse.added), Is.EqualTo(((Mouse)null, (Pointer)null, false)));
            Assert.That(() => InputSystem.QueueStateEvent(mouse, new MouseState()), Throws.InvalidOperationException);
        }

        [Test]
        public void CurrentDevice_IsTheOneUsedLast()
        {
            var first = InputSystem.AddDevice<Mouse>();
            var second = InputSystem.AddDevice<Mouse>();
            Assert.That((Mouse.current, second.name), Is.EqualTo((second, "Mouse1")));
            Send(first, new MouseState { position = Vector2.one });
            Assert.That(Mouse.current, Is.SameAs(first));
        }

        [Test]
        public void State_ItsSize_IsThatOfItsStruct()
        {
            Assert.That(InputSystem.AddDevice<Mouse>().stateBlock.sizeInBits, Is.GreaterThanOrEqualTo(30 * 8u));
            Assert.That(InputSystem.AddDevice<Keyboard>().stateBlock.sizeInBits, Is.EqualTo(14 * 8u));
        }

        [Test]
        public void AddDevice_OfAnUnknownLayout_IsRefused() =>
            Assert.That(() => InputSystem.AddDevice("Trackball"), Throws.TypeOf<ArgumentException>().With.Message.Contains("Trackball"));

        /// <summary>Reads the mouse in Update.</summary>
        public sealed class MouseReader : MonoBehaviour
        {
            internal Vector2 InUpdate { get; private set; }

            void Update() => InUpdate = Mouse.current.position.ReadValue();
        }
    }
}
