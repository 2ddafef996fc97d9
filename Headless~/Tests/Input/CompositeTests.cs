using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.LowLevel;

namespace AnatomyCarve.Headless.Tests.Input
{
    /// <summary>Values made of several controls, and what processors make of values.</summary>
    public sealed class CompositeTests : InputTests
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
        public void Vector_OfFourKeys_IsNeverLongerThanOne()
        {
            var action = Wasd("2DVector");
            Press(m_Keyboard, Key.D);
            Assert.That(action.ReadValue<Vector2>(), Is.EqualTo(Vector2.right));
            Press(m_Keyboard, Key.D, Key.W);
            Assert.That(Vector2.Distance(action.ReadValue<Vector2>(), new Vector2(0.7071f, 0.7071f)), Is.LessThan(1e-3f));
            Press(m_Keyboard, Key.D, Key.A);
            Assert.That((action.ReadValue<Vector2>(), action.phase), Is.EqualTo((Vector2.zero, InputActionPhase.Waiting)));
        }

        [Test]
        public void Vector_InDigitalMode_IsLongerOnDiagonals()
        {
            var action = Wasd("2DVector(mode=1)");
            Press(m_Keyboard, Key.A, Key.S);
            Assert.That(action.ReadValue<Vector2>(), Is.EqualTo(new Vector2(-1, -1)));
        }

        [Test]
        public void Axis_OfTwoKeys_GoesBothWays()
        {
            var action = Enabled(InputActionType.Value, a => a.AddCompositeBinding("1DAxis").With("Negative", "<Keyboard>/minus").With("Positive", "<Keyboard>/equals"));
            Press(m_Keyboard, Key.Equals);
            Assert.That(action.ReadValue<float>(), Is.EqualTo(1f));
            Press(m_Keyboard, Key.Minus);
            Assert.That(action.ReadValue<float>(), Is.EqualTo(-1f));
            Press(m_Keyboard, Key.Minus, Key.Equals);
            Assert.That(action.ReadValue<float>(), Is.EqualTo(0f));
        }

        [TestCase("OneModifier", "modifier", "binding")]
        [TestCase("ButtonWithOneModifier", "modifier", "button")]
        public void Modifier_HeldFirst_LetsTheKeyThrough(string composite, string modifier, string button)
        {
            var action = Enabled(InputActionType.Button, a => a.AddCompositeBinding(composite).With(modifier, "<Keyboard>/ctrl").With(button, "<Keyboard>/z"));
            Press(m_Keyboard, Key.Z);
            Assert.That(action.IsPressed(), Is.False);
            Press(m_Keyboard);
            Press(m_Keyboard, Key.RightCtrl);
            Assert.That(action.IsPressed(), Is.False);
            Press(m_Keyboard, Key.RightCtrl, Key.Z);
            Assert.That(action.WasPerformedThisFrame(), Is.True);
            Press(m_Keyboard, Key.RightCtrl);
            Assert.That(action.WasReleasedThisFrame(), Is.True);
        }

        [Test]
        public void ModifierAndKey_InOneEvent_PerformOnce()
        {
            var action = Enabled(InputActionType.Button, a => a.AddCompositeBinding("OneModifier").With("modifier", "<Keyboard>/ctrl").With("binding", "<Keyboard>/z"));
            var performed = 0;
            action.performed += _ => performed++;
            Press(m_Keyboard, Key.LeftCtrl, Key.Z);
            Assert.That(performed, Is.EqualTo(1));
        }

        [Test]
        public void TwoModifiers_BothHeld_LetTheKeyThrough()
        {
            var action = Enabled(InputActionType.Button, a => a.AddCompositeBinding("TwoModifiers")
                .With("modifier1", "<Keyboard>/ctrl").With("modifier2", "<Keyboard>/shift").With("binding", "<Keyboard>/z"));
            Press(m_Keyboard, Key.LeftCtrl);
            Press(m_Keyboard, Key.LeftCtrl, Key.Z);
            Assert.That(action.IsPressed(), Is.False);
            Press(m_Keyboard, Key.LeftCtrl);
            Press(m_Keyboard, Key.LeftCtrl, Key.LeftShift);
            Press(m_Keyboard, Key.LeftCtrl, Key.LeftShift, Key.Z);
            Assert.That((action.IsPressed(), action.WasPerformedThisFrame()), Is.EqualTo((true, true)));
        }

        [Test]
        public void TwoModifiers_OneOfThemInTheKeysOwnEvent_DoNotPerform()
        {
            // As in Unity the action then counts as pressed, which is why one asks a shortcut whether it was performed.
            var action = Enabled(InputActionType.Button, a => a.AddCompositeBinding("TwoModifiers")
                .With("modifier1", "<Keyboard>/ctrl").With("modifier2", "<Keyboard>/shift").With("binding", "<Keyboard>/z"));
            Press(m_Keyboard, Key.LeftCtrl, Key.Z);
            Assert.That((action.WasPerformedThisFrame(), action.IsPressed()), Is.EqualTo((false, true)));
        }

        [Test]
        public void Modifier_OfAMovement_PassesItsTypeOn()
        {
            var action = Enabled(InputActionType.Value, a => a.AddCompositeBinding("OneModifier").With("modifier", "<Keyboard>/alt").With("binding", "<Mouse>/position"));
            Send(m_Mouse, new MouseState { position = new Vector2(3, 4) });
            Assert.That(action.ReadValue<Vector2>(), Is.EqualTo(Vector2.zero));
            Press(m_Keyboard, Key.LeftAlt);
            Assert.That(action.ReadValue<Vector2>(), Is.EqualTo(new Vector2(3, 4)));
        }

        [TestCase("scale(factor=2.5)", 5f)]
        [TestCase("invert", -2f)]
        [TestCase("invert,scale(factor=3)", -6f)]
        [TestCase("clamp(min=-1,max=1)", 1f)]
        [TestCase("normalize(min=0,max=4,zero=0)", 0.5f)]
        public void Processors_OfABinding_ChangeItsValue(string processors, float expected)
        {
            var action = Enabled(InputActionType.Value, a => a.AddBinding("<Mouse>/scroll/y", processors: processors));
            Send(m_Mouse, new MouseState { scroll = new Vector2(0, 2) });
            Assert.That(action.ReadValue<float>(), Is.EqualTo(expected).Within(1e-6f));
        }

        [TestCase(0.1f, 0f)]
        [TestCase(0.525f, 0.5f)]
        [TestCase(0.95f, 1f)]
        public void StickDeadzone_NearTheMiddleAndTheRim_Snaps(float length, float expected)
        {
            var action = Enabled(InputActionType.Value, a => a.AddBinding("<Mouse>/position", processors: "StickDeadzone"));
            Send(m_Mouse, new MouseState { position = new Vector2(0, length) });
            Assert.That(action.ReadValue<Vector2>().y, Is.EqualTo(expected).Within(1e-5f));
        }

        [Test]
        public void Processor_ThatNobodyRegistered_IsAnError()
        {
            UnityEngine.TestTools.LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex("while resolving binding"));
            UnityEngine.TestTools.LogAssert.Expect(LogType.Exception, new System.Text.RegularExpressions.Regex("No InputProcessor with name 'twist'"));
            Enabled(InputActionType.Value, a => a.AddBinding("<Mouse>/scroll/y", processors: "twist"));
        }

        InputAction Wasd(string composite) => Enabled(InputActionType.Value, a => a.AddCompositeBinding(composite)
            .With("Up", "<Keyboard>/w").With("Down", "<Keyboard>/s").With("Left", "<Keyboard>/a").With("Right", "<Keyboard>/d"));

        static InputAction Enabled(InputActionType type, System.Action<InputAction> bind)
        {
            var action = new InputAction("action", type);
            bind(action);
            action.Enable();
            return action;
        }
    }
}
