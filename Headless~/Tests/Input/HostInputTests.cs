using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.LowLevel;

namespace AnatomyCarve.Headless.Tests.Input
{
    /// <summary>The host's own mouse and keyboard.</summary>
    public sealed class HostInputTests : InputTests
    {
        [Test]
        public void Mouse_MovedPressedAndScrolled_ReportsIt()
        {
            using var input = new HostInput();
            input.MoveTo(10, 20);
            input.MoveTo(13, 24);
            input.Press(MouseButton.Right);
            input.Scroll(-2);
            Frame();
            Assert.That((Mouse.current.position.ReadValue(), Mouse.current.delta.ReadValue(), Mouse.current.scroll.ReadValue().y),
                Is.EqualTo((new Vector2(13, 24), new Vector2(13, 24), -2f)));
            Assert.That(Mouse.current.rightButton.isPressed, Is.True);
            input.Release(MouseButton.Right);
            Frame();
            Assert.That((Mouse.current.rightButton.isPressed, Mouse.current.delta.ReadValue()), Is.EqualTo((false, Vector2.zero)));
        }

        [Test]
        public void Keys_Held_StayDownUntilReleased()
        {
            using var input = new HostInput();
            input.Press(Key.LeftShift);
            input.Press(Key.A);
            Frame();
            input.Release(Key.A);
            Frame();
            Assert.That((Keyboard.current.shiftKey.isPressed, Keyboard.current.aKey.isPressed), Is.EqualTo((true, false)));
        }

        [Test]
        public void Dispose_UnplugsBoth()
        {
            new HostInput().Dispose();
            Assert.That((Mouse.current, Keyboard.current, InputSystem.devices.Count), Is.EqualTo(((Mouse)null, (Keyboard)null, 0)));
        }
    }
}
