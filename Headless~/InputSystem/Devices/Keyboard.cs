using System;
using System.Linq;
using UnityEngine.InputSystem.Controls;
using UnityEngine.InputSystem.Layouts;
using UnityEngine.InputSystem.LowLevel;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem
{
    /// <summary>A keyboard.</summary>
    [InputControlLayout(stateType = typeof(KeyboardState), isGenericTypeOfDevice = true)]
    public partial class Keyboard : InputDevice
    {
        public const int KeyCount = (int)Key.OEM5;

        KeyControl[] m_Keys;

        /// <summary>The one that was used last or added last; null if there is none.</summary>
        public static Keyboard current { get; private set; }

        public AnyKeyControl anyKey { get; protected set; }

        /// <summary>Either Shift key.</summary>
        public ButtonControl shiftKey { get; protected set; }

        /// <summary>Either Control key.</summary>
        public ButtonControl ctrlKey { get; protected set; }

        /// <summary>Either Alt key.</summary>
        public ButtonControl altKey { get; protected set; }

        public ButtonControl imeSelected { get; protected set; }

        public ReadOnlyArray<KeyControl> allKeys => m_Keys;

        /// <exception cref="ArgumentOutOfRangeException">There is no such key.</exception>
        public KeyControl this[Key key] =>
            key >= Key.Space && (int)key <= KeyCount ? m_Keys[(int)key - 1] : throw new ArgumentOutOfRangeException(nameof(key), key, "There is no such key.");

        public override void MakeCurrent()
        {
            base.MakeCurrent();
            current = this;
        }

        protected override void OnRemoved()
        {
            base.OnRemoved();
            if (current == this)
                current = null;
        }

        protected override void FinishSetup()
        {
            m_Keys = KeyControls.All.Select(k => GetChildControl<KeyControl>(KeyControls.NameOf(k))).ToArray();
            for (var i = 0; i < m_Keys.Length; i++)
                m_Keys[i].keyCode = (Key)(i + 1);
            anyKey = GetChildControl<AnyKeyControl>("anyKey");
            shiftKey = GetChildControl<ButtonControl>("shift");
            ctrlKey = GetChildControl<ButtonControl>("ctrl");
            altKey = GetChildControl<ButtonControl>("alt");
            imeSelected = GetChildControl<ButtonControl>("IMESelected");
            base.FinishSetup();
        }
    }
}
