using System;
using System.Runtime.InteropServices;
using UnityEngine.InputSystem.Controls;
using UnityEngine.InputSystem.Layouts;
using UnityEngine.InputSystem.LowLevel;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem
{
    /// <summary>Something that points at a place of the screen, in pixels from the lower left corner.</summary>
    [InputControlLayout(stateType = typeof(PointerState), isGenericTypeOfDevice = true)]
    public class Pointer : InputDevice
    {
        public static Pointer current { get; internal set; }

        public Vector2Control position { get; protected set; }

        public DeltaControl delta { get; protected set; }

        public Vector2Control radius { get; protected set; }

        public AxisControl pressure { get; protected set; }

        public ButtonControl press { get; protected set; }

        public IntegerControl displayIndex { get; protected set; }

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
            position = GetChildControl<Vector2Control>("position");
            delta = GetChildControl<DeltaControl>("delta");
            radius = GetChildControl<Vector2Control>("radius");
            pressure = GetChildControl<AxisControl>("pressure");
            press = GetChildControl<ButtonControl>("press");
            displayIndex = GetChildControl<IntegerControl>("displayIndex");
            base.FinishSetup();
        }

        internal override void BeginUpdate() => Zero(delta);

        internal override void Prepare(Span<byte> bytes, uint byteOffset) => Accumulate(delta, bytes, byteOffset);

        /// <summary>Back to rest, which is a change of state like any other, unless it is there.</summary>
        private protected void Zero(DeltaControl control)
        {
            if (!control.IsAtDefault)
                Change(stackalloc byte[8], control.m_StateBlock.byteOffset, InputState.currentTime, 0);
        }

        /// <summary>Adds what moved in this update so far to an event's own movement. Events of parts of the state add up only if they hold it all.</summary>
        private protected void Accumulate(DeltaControl control, Span<byte> bytes, uint byteOffset)
        {
            long at = (long)control.m_StateBlock.byteOffset - byteOffset;
            if (at < 0 || at + 8 > bytes.Length)
                return;
            var part = MemoryMarshal.Cast<byte, Vector2>(bytes.Slice((int)at, 8));
            part[0] += control.ReadUnprocessedValue();
        }

        [StructLayout(LayoutKind.Sequential)]
        struct PointerState : IInputStateTypeInfo
        {
            public uint pointerId;

            [InputControl(layout = "Vector2", displayName = "Position", usage = "Point", dontReset = true)]
            public Vector2 position;

            [InputControl(layout = "Delta", displayName = "Delta", usage = "Secondary2DMotion")]
            public Vector2 delta;

            [InputControl(layout = "Analog", displayName = "Pressure", usage = "Pressure", defaultState = 1f)]
            public float pressure;

            [InputControl(layout = "Vector2", displayName = "Radius", usage = "Radius")]
            public Vector2 radius;

            [InputControl(name = "press", displayName = "Press", layout = "Button", format = "BIT", bit = 0)]
            public ushort buttons;

            [InputControl(name = "displayIndex", layout = "Integer", displayName = "Display Index")]
            public ushort displayIndex;

            public FourCC format => new('P', 'T', 'R');
        }
    }
}
