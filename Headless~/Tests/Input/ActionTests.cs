using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.LowLevel;
using UnityEngine.TestTools;

namespace AnatomyCarve.Headless.Tests.Input
{
    /// <summary>Actions of each type: phases, callbacks, presses and values.</summary>
    public sealed class ActionTests : InputTests
    {
        Mouse m_Mouse;
        Keyboard m_Keyboard;

        [SetUp]
        public void AddDevices()
        {
            m_Mouse = InputSystem.AddDevice<Mouse>();
            m_Keyboard = InputSystem.AddDevice<Keyboard>();
        }

        [Test]
        public void ButtonAction_PressedAndReleased_GoesThroughItsPhases()
        {
            var action = new InputAction("fix", InputActionType.Button, "<Keyboard>/f");
            List<string> log = Logged(action);
            action.Enable();
            Press(m_Keyboard, Key.F);
            Assert.That((action.WasPressedThisFrame(), action.WasPerformedThisFrame(), action.IsPressed(), action.phase),
                Is.EqualTo((true, true, true, InputActionPhase.Performed)));
            Frame();
            Assert.That((action.WasPressedThisFrame(), action.IsPressed()), Is.EqualTo((false, true)));
            Press(m_Keyboard);
            Assert.That((action.WasReleasedThisFrame(), action.WasCompletedThisFrame(), action.IsPressed(), action.phase),
                Is.EqualTo((true, true, false, InputActionPhase.Waiting)));
            Assert.That(log, Is.EqualTo(new[] { "started", "performed", "canceled" }));
        }

        [Test]
        public void ButtonAction_EnabledWhileDown_WaitsForTheNextPress()
        {
            var action = new InputAction("fix", InputActionType.Button, "<Keyboard>/f");
            Press(m_Keyboard, Key.F);
            action.Enable();
            Frame();
            Assert.That(action.IsPressed(), Is.False);
            Press(m_Keyboard);
            Press(m_Keyboard, Key.F);
            Assert.That(action.WasPressedThisFrame(), Is.True);
        }

        [Test]
        public void ValueAction_EnabledWhileItsControlIsAway_TakesItsValue()
        {
            var action = new InputAction("point", InputActionType.Value, "<Mouse>/position");
            Send(m_Mouse, new MouseState { position = new Vector2(3, 4) });
            action.Enable();
            Assert.That(action.ReadValue<Vector2>(), Is.EqualTo(Vector2.zero), "not before the next update");
            Frame();
            Assert.That(action.ReadValue<Vector2>(), Is.EqualTo(new Vector2(3, 4)));
        }

        [Test]
        public void ValueAction_EachChange_Performs()
        {
            var action = new InputAction("point", InputActionType.Value, "<Mouse>/position");
            List<string> log = Logged(action);
            action.Enable();
            Send(m_Mouse, new MouseState { position = new Vector2(3, 4) });
            Send(m_Mouse, new MouseState { position = new Vector2(5, 4) });
            Send(m_Mouse, new MouseState());
            Assert.That(log, Is.EqualTo(new[] { "started", "performed", "performed", "canceled" }));
            Assert.That((action.phase, action.ReadValue<Vector2>()), Is.EqualTo((InputActionPhase.Waiting, Vector2.zero)));
        }

        [Test]
        public void PassThroughAction_EachChangeOfAnyControl_Performs()
        {
            var action = new InputAction("drag", InputActionType.PassThrough, "<Mouse>/delta");
            List<string> log = Logged(action);
            action.Enable();
            Send(m_Mouse, new MouseState { delta = new Vector2(3, 4) });
            Assert.That(action.ReadValue<Vector2>(), Is.EqualTo(new Vector2(3, 4)));
            Frame();
            Assert.That(action.ReadValue<Vector2>(), Is.EqualTo(Vector2.zero), "a movement ends by itself");
            Assert.That(log, Is.EqualTo(new[] { "performed", "performed" }));
        }

        [Test]
        public void Action_Disabled_IsCanceledAndSilent()
        {
            var action = new InputAction("fix", InputActionType.Button, "<Keyboard>/f");
            List<string> log = Logged(action);
            action.Enable();
            Press(m_Keyboard, Key.F);
            action.Disable();
            Assert.That((action.enabled, action.IsPressed(), log.Last()), Is.EqualTo((false, false, "canceled")));
            Press(m_Keyboard);
            Press(m_Keyboard, Key.F);
            Assert.That((log.Count, action.WasPressedThisFrame()), Is.EqualTo((3, false)));
        }

        [Test]
        public void ConflictingControls_TheMostActuated_Drives()
        {
            var action = new InputAction("move", InputActionType.Value, expectedControlType: "Vector2");
            action.AddBinding("<Mouse>/position");
            action.AddBinding("<Mouse>/scroll");
            action.Enable();
            Send(m_Mouse, new MouseState { position = new Vector2(1, 0), scroll = new Vector2(0, 5) });
            Assert.That(action.ReadValue<Vector2>(), Is.EqualTo(new Vector2(0, 5)));
            Frame();
            Assert.That((action.ReadValue<Vector2>(), action.activeControl), Is.EqualTo((new Vector2(1, 0), m_Mouse.position)), "the wheel has stopped");
        }

        [Test]
        public void TwoKeys_OnOneButton_AreReleasedWithTheSecond()
        {
            var action = new InputAction("fix", InputActionType.Button, "<Keyboard>/f");
            action.AddBinding("<Keyboard>/enter");
            action.Enable();
            Press(m_Keyboard, Key.F);
            Press(m_Keyboard, Key.F, Key.Enter);
            Assert.That((action.IsPressed(), action.WasPressedThisFrame()), Is.EqualTo((true, false)));
            Press(m_Keyboard, Key.Enter);
            Assert.That((action.IsPressed(), action.WasReleasedThisFrame()), Is.EqualTo((true, false)));
            Press(m_Keyboard);
            Assert.That((action.IsPressed(), action.WasReleasedThisFrame()), Is.EqualTo((false, true)));
        }

        [Test]
        public void Device_AddedLater_IsUsed()
        {
            var action = new InputAction("fix", InputActionType.Button, "<Keyboard>/f");
            InputSystem.RemoveDevice(m_Keyboard);
            action.Enable();
            Assert.That(action.controls.Count, Is.Zero);
            var keyboard = InputSystem.AddDevice<Keyboard>();
            Press(keyboard, Key.F);
            Assert.That((action.controls.Count, action.WasPressedThisFrame()), Is.EqualTo((1, true)));
        }

        [Test]
        public void Device_RemovedWhileItDrives_CancelsTheAction()
        {
            var action = new InputAction("fix", InputActionType.Button, "<Keyboard>/f");
            List<string> log = Logged(action);
            action.Enable();
            Press(m_Keyboard, Key.F);
            InputSystem.RemoveDevice(m_Keyboard);
            Assert.That((log.Last(), action.phase, action.IsPressed()), Is.EqualTo(("canceled", InputActionPhase.Waiting, false)));
        }

        [Test]
        public void Device_AddedWhileAnotherDrives_LeavesTheAction()
        {
            var action = new InputAction("fix", InputActionType.Button, "<Keyboard>/f");
            List<string> log = Logged(action);
            action.Enable();
            Press(m_Keyboard, Key.F);
            InputSystem.AddDevice<Mouse>();
            Frame();
            Assert.That((action.IsPressed(), log.Count), Is.EqualTo((true, 2)));
            Press(m_Keyboard);
            Assert.That(action.WasReleasedThisFrame(), Is.True);
        }

        [Test]
        public void ReadValue_OfAnotherType_IsRefused()
        {
            var action = new InputAction("point", InputActionType.Value, "<Mouse>/position");
            action.Enable();
            Send(m_Mouse, new MouseState { position = new Vector2(3, 4) });
            Assert.That(() => action.ReadValue<float>(), Throws.InvalidOperationException.With.Message.Contains("/Mouse/position"));
        }

        [Test]
        public void Callback_ThatThrows_IsLoggedAndTheOthersRun()
        {
            var action = new InputAction("fix", InputActionType.Button, "<Keyboard>/f");
            var performed = 0;
            action.performed += _ => throw new InvalidOperationException("no");
            action.performed += context => performed += context.ReadValueAsButton() ? 1 : 0;
            action.Enable();
            LogAssert.Expect(LogType.Error, new Regex("InvalidOperationException while executing 'performed' callbacks of 'fix"));
            LogAssert.Expect(LogType.Exception, "InvalidOperationException: no");
            Press(m_Keyboard, Key.F);
            Assert.That(performed, Is.EqualTo(1));
        }

        [Test]
        public void Callback_ThatDisablesItsAction_EndsIt()
        {
            var action = new InputAction("fix", InputActionType.Button, "<Keyboard>/f");
            action.performed += _ => action.Disable();
            action.Enable();
            Press(m_Keyboard, Key.F);
            Assert.That((action.enabled, action.IsPressed()), Is.EqualTo((false, false)));
            Press(m_Keyboard);
            Assert.That(action.phase, Is.EqualTo(InputActionPhase.Disabled));
        }

        [Test]
        public void Binding_ThatIsMalformed_IsLoggedAndTheOthersWork()
        {
            var action = new InputAction("fix", InputActionType.Button);
            action.AddBinding("<Keyboard/f");
            action.AddBinding("<Keyboard>/enter");
            LogAssert.Expect(LogType.Error, new Regex("FormatException while resolving binding .*<Keyboard/f"));
            LogAssert.Expect(LogType.Exception, new Regex("FormatException"));
            action.Enable();
            Press(m_Keyboard, Key.Enter);
            Assert.That(action.WasPressedThisFrame(), Is.True);
        }

        [Test]
        public void Interaction_WhichTheHostLacks_IsAnError()
        {
            var action = new InputAction("fix", InputActionType.Button, "<Keyboard>/f", interactions: "hold");
            LogAssert.Expect(LogType.Error, new Regex("while resolving binding"));
            LogAssert.Expect(LogType.Exception, new Regex("No IInputInteraction with name 'hold'"));
            action.Enable();
            Assert.That(action.controls.Count, Is.Zero);
        }

        [Test]
        public void Frames_InWhichNothingHappens_LeaveNoGarbage()
        {
            var action = new InputAction("move", InputActionType.Value);
            action.AddCompositeBinding("2DVector").With("Up", "<Keyboard>/w").With("Down", "<Keyboard>/s").With("Left", "<Keyboard>/a").With("Right", "<Keyboard>/d");
            action.Enable();
            Press(m_Keyboard, Key.W);
            var sum = Vector2.zero;
            void Read()
            {
                InputSystem.QueueStateEvent(m_Mouse, new MouseState { delta = Vector2.one });
                InputSystem.Update();
                for (var i = 0; i < 100; i++)
                    sum += action.ReadValue<Vector2>();
            }

            for (var i = 0; i < 50; i++)
                Read();
            var before = GC.GetAllocatedBytesForCurrentThread();
            for (var i = 0; i < 50; i++)
                Read();
            Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
            Assert.That(sum.y, Is.EqualTo(10000f));
        }

        static List<string> Logged(InputAction action)
        {
            var log = new List<string>();
            action.started += _ => log.Add("started");
            action.performed += _ => log.Add("performed");
            action.canceled += _ => log.Add("canceled");
            return log;
        }
    }
}
