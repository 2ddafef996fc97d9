using System;
using UnityEngine.InputSystem.Controls;
using UnityEngine.InputSystem.Layouts;
using UnityEngine.InputSystem.LowLevel;

namespace UnityEngine.InputSystem
{
    /// <summary>A mouse.</summary>
    [InputControlLayout(stateType = typeof(MouseState), isGenericTypeOfDevice = true)]
    public class Mouse : Pointer
    {
        /// <summary>The one that moved last or was added last; null if there is none.</summary>
        public new static Mouse current { get; private set; }

        /// <summary>What the wheel turned in this frame: 1 per notch, up is positive.</summary>
        public DeltaControl scroll { get; protected set; }

        public ButtonControl leftButton { get; protected set; }

        public ButtonControl middleButton { get; protected set; }

        public ButtonControl rightButton { get; protected set; }

        public ButtonControl backButton { get; protected set; }

        public ButtonControl forwardButton { get; protected set; }

        public IntegerControl clickCount { get; protected set; }

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
            scroll = GetChildControl<DeltaControl>("scroll");
            leftButton = GetChildControl<ButtonControl>("leftButton");
            middleButton = GetChildControl<ButtonControl>("middleButton");
            rightButton = GetChildControl<ButtonControl>("rightButton");
            forwardButton = GetChildControl<ButtonControl>("forwardButton");
            backButton = GetChildControl<ButtonControl>("backButton");
            clickCount = GetChildControl<IntegerControl>("clickCount");
            base.FinishSetup();
        }

        internal override void BeginUpdate()
        {
            base.BeginUpdate();
            Zero(scroll);
        }

        internal override void Prepare(Span<byte> bytes, uint byteOffset)
        {
            base.Prepare(bytes, byteOffset);
            Accumulate(scroll, bytes, byteOffset);
        }
    }
}
