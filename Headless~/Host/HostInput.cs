using System;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.LowLevel;

namespace AnatomyCarve.Headless
{
    /// <summary>
    /// A mouse and a keyboard for a machine that has none. What is done with them is in the state of the devices from the next frame on, as if a person did
    /// it between the frames.
    /// </summary>
    public sealed class HostInput : IDisposable
    {
        MouseState m_Mouse;
        KeyboardState m_Keyboard;

        /// <summary>Plugs them in. A host must be running.</summary>
        public HostInput()
        {
            Mouse = InputSystem.AddDevice<Mouse>();
            Keyboard = InputSystem.AddDevice<Keyboard>();
        }

        /// <summary>The mouse that is moved.</summary>
        public Mouse Mouse { get; }

        /// <summary>The keyboard that is used.</summary>
        public Keyboard Keyboard { get; }

        /// <summary>Where the mouse is, in pixels from the lower left corner.</summary>
        public Vector2 Position => m_Mouse.position;

        /// <summary>Moves the mouse to a place.</summary>
        /// <param name="x">Pixels from the left edge.</param>
        /// <param name="y">Pixels from the lower edge.</param>
        public void MoveTo(float x, float y)
        {
            m_Mouse.delta = new Vector2(x, y) - m_Mouse.position;
            m_Mouse.position = new Vector2(x, y);
            SendMouse();
        }

        /// <summary>Turns the wheel; up is positive.</summary>
        public void Scroll(float notches)
        {
            m_Mouse.scroll = new Vector2(0f, notches);
            SendMouse();
        }

        /// <summary>Presses a mouse button and holds it.</summary>
        public void Press(MouseButton button) => Set(button, true);

        /// <summary>Lets a mouse button go.</summary>
        public void Release(MouseButton button) => Set(button, false);

        /// <summary>Presses a key and holds it.</summary>
        public void Press(Key key) => Set(key, true);

        /// <summary>Lets a key go.</summary>
        public void Release(Key key) => Set(key, false);

        /// <summary>Unplugs both.</summary>
        public void Dispose()
        {
            InputSystem.RemoveDevice(Mouse);
            InputSystem.RemoveDevice(Keyboard);
        }

        void Set(MouseButton button, bool down)
        {
            m_Mouse = m_Mouse.WithButton(button, down);
            SendMouse();
        }

        void Set(Key key, bool down)
        {
            m_Keyboard.Set(key, down);
            InputSystem.QueueStateEvent(Keyboard, m_Keyboard);
        }

        void SendMouse()
        {
            InputSystem.QueueStateEvent(Mouse, m_Mouse);
            m_Mouse.delta = m_Mouse.scroll = Vector2.zero;
        }
    }
}
