using System;
using System.Collections;
using System.Collections.Generic;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.LowLevel;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Desktop.Tests
{
    /// <summary>
    /// A desk for play-mode tests: a mouse and a keyboard of their own, controls that listen to these alone, and a scene of their own. In the Editor input
    /// arrives whatever window has the focus.
    /// </summary>
    abstract class DesktopScene
    {
        readonly List<Object> made = new List<Object>();
        InputSettings.BackgroundBehavior backgroundBehavior;
        InputSettings.EditorInputBehaviorInPlayMode editorBehavior;
        MouseState mouseState;
        KeyboardState keyboardState;

        protected Mouse Mouse { get; private set; }

        protected Keyboard Keyboard { get; private set; }

        /// <summary>A copy of the package's controls for the test's own devices.</summary>
        protected InputActionAsset Controls { get; private set; }

        [SetUp]
        public void PlugIn()
        {
            backgroundBehavior = InputSystem.settings.backgroundBehavior;
            editorBehavior = InputSystem.settings.editorInputBehaviorInPlayMode;
            InputSystem.settings.backgroundBehavior = InputSettings.BackgroundBehavior.IgnoreFocus;
            InputSystem.settings.editorInputBehaviorInPlayMode = InputSettings.EditorInputBehaviorInPlayMode.AllDeviceInputAlwaysGoesToGameView;
            Mouse = InputSystem.AddDevice<Mouse>();
            Keyboard = InputSystem.AddDevice<Keyboard>();
            mouseState = default;
            keyboardState = default;
            Controls = Object.Instantiate(AnatomyCarveDesktop.Load().Controls);
            Controls.devices = new InputDevice[] { Mouse, Keyboard };
            made.Add(Controls);
        }

        [UnityTearDown]
        public IEnumerator PutAway()
        {
            for (int n = made.Count - 1; n >= 0; n--)
                if (made[n] != null)
                    Object.Destroy(made[n]);
            made.Clear();
            yield return null; // the objects go
            yield return null; // what they held goes
            InputSystem.RemoveDevice(Mouse);
            InputSystem.RemoveDevice(Keyboard);
            InputSystem.settings.backgroundBehavior = backgroundBehavior;
            InputSystem.settings.editorInputBehaviorInPlayMode = editorBehavior;
        }

        protected GameObject Make(string name, params Type[] components)
        {
            var o = new GameObject(name, components);
            made.Add(o);
            return o;
        }

        protected T Keep<T>(T o) where T : Object
        {
            made.Add(o);
            return o;
        }

        /// <summary>A camera that looks at a point from 20 cm in front of the patient, and renders only when asked.</summary>
        protected Camera MakeCamera(Vector3 lookedAt = default)
        {
            var camera = Make("Camera").AddComponent<Camera>();
            camera.enabled = false;
            camera.fieldOfView = 40f;
            camera.nearClipPlane = 0.001f;
            camera.transform.position = lookedAt + new Vector3(0f, 0f, -0.2f);
            return camera;
        }

        /// <summary>An opaque block with all that carving it needs.</summary>
        protected CarvedVolumeRenderer MakeVolume()
        {
            GameObject o = Make("Volume", typeof(VolumeLoader), typeof(ClipSphereStack), typeof(CarvedVolumeRenderer));
            o.GetComponent<VolumeLoader>().SetVolume(Block.Make());
            var renderer = o.GetComponent<CarvedVolumeRenderer>();
            renderer.TransferFunction = OpacityTransferFunction.Parse("400:0,600:1");
            return renderer;
        }

        /// <summary>Adds a component that listens to the test's own controls, with what else it needs, before it wakes up.</summary>
        protected T Add<T>(GameObject o, Action<T> set) where T : Component
        {
            bool active = o.activeSelf;
            o.SetActive(false);
            T component = o.AddComponent<T>();
            set(component);
            o.SetActive(active);
            return component;
        }

        /// <summary>
        /// What happened at the desk is in this frame's input and has been worked on when this returns: a test goes on between a frame's Update and its
        /// LateUpdate, so that takes two.
        /// </summary>
        protected static IEnumerator Pass(int frames = 1)
        {
            for (int n = 0; n <= frames; n++)
                yield return null;
        }

        protected void MoveTo(Vector2 pixel)
        {
            mouseState.delta = pixel - mouseState.position;
            mouseState.position = pixel;
            SendMouse();
        }

        protected void MoveBy(Vector2 pixels) => MoveTo(mouseState.position + pixels);

        protected void Scroll(float notches)
        {
            mouseState.scroll = new Vector2(0f, notches);
            SendMouse();
        }

        protected void Press(MouseButton button, bool down = true)
        {
            mouseState = mouseState.WithButton(button, down);
            SendMouse();
        }

        protected void Press(Key key, bool down = true)
        {
            keyboardState.Set(key, down);
            InputSystem.QueueStateEvent(Keyboard, keyboardState);
        }

        /// <summary>Keys pressed one after the other, held for a frame and released.</summary>
        protected IEnumerator Type(params Key[] keys)
        {
            foreach (Key key in keys)
                Press(key);
            yield return Pass();
            foreach (Key key in keys)
                Press(key, false);
            yield return Pass();
        }

        void SendMouse()
        {
            InputSystem.QueueStateEvent(Mouse, mouseState);
            mouseState.delta = mouseState.scroll = Vector2.zero;
        }
    }

    /// <summary>A gate that a test opens and closes.</summary>
    sealed class TestGate : InputGate
    {
        public bool Pointer { get; set; }

        public bool Keys { get; set; }

        public override bool BlocksPointer => Pointer;

        public override bool BlocksKeys => Keys;
    }
}
