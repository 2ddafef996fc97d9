using UnityEngine.InputSystem.LowLevel;

namespace UnityEngine.InputSystem.Controls
{
    /// <summary>An axis that counts as pressed from a point on.</summary>
    public unsafe class ButtonControl : AxisControl
    {
        /// <summary>Above 0: from where on it is pressed; else the settings' default counts.</summary>
        public float pressPoint = -1;

        bool m_Counts;
        bool m_WasPressed;
        uint m_PressedIn = uint.MaxValue;
        uint m_ReleasedIn = uint.MaxValue;

        public ButtonControl() => m_StateBlock.format = InputStateBlock.FormatBit;

        public float pressPointOrDefault => pressPoint > 0 ? pressPoint : DefaultPressPoint;

        public bool isPressed => IsValueConsideredPressed(value);

        /// <summary>Whether it went down since the update before, even if it is up again.</summary>
        public bool wasPressedThisFrame
        {
            get
            {
                Count();
                return m_PressedIn == InputManager.Instance.UpdateStep;
            }
        }

        public bool wasReleasedThisFrame
        {
            get
            {
                Count();
                return m_ReleasedIn == InputManager.Instance.UpdateStep;
            }
        }

        internal static float DefaultPressPoint => InputManager.Instance.Settings.defaultButtonPressPoint;

        internal static float ReleaseThreshold => InputManager.Instance.Settings.buttonReleaseThreshold;

        public bool IsValueConsideredPressed(float value) => value >= pressPointOrDefault;

        /// <summary>After each change of the device's state, once somebody asked for presses.</summary>
        internal void UpdatePresses()
        {
            var pressed = isPressed;
            if (pressed == m_WasPressed)
                return;
            m_WasPressed = pressed;
            if (pressed)
                m_PressedIn = InputManager.Instance.UpdateStep;
            else
                m_ReleasedIn = InputManager.Instance.UpdateStep;
        }

        /// <summary>From the first question on, every change counts; the first answer compares with the frame before.</summary>
        void Count()
        {
            if (m_Counts)
                return;
            m_Counts = true;
            m_Device.CountedButtons.Add(this);
            m_WasPressed = isPressed;
            var before = IsValueConsideredPressed(ReadValueFromPreviousFrame());
            if (!m_Device.wasUpdatedThisFrame || before == m_WasPressed)
                return;
            if (m_WasPressed)
                m_PressedIn = InputManager.Instance.UpdateStep;
            else
                m_ReleasedIn = InputManager.Instance.UpdateStep;
        }
    }
}
