using UnityEngine.InputSystem.Layouts;
using UnityEngine.InputSystem.LowLevel;

namespace UnityEngine.InputSystem.Controls
{
    /// <summary>Two numbers.</summary>
    public unsafe class Vector2Control : InputControl<Vector2>
    {
        public Vector2Control() => m_StateBlock.format = InputStateBlock.FormatVector2;

        [InputControl(offset = 0, displayName = "X")]
        public AxisControl x { get; set; }

        [InputControl(offset = 4, displayName = "Y")]
        public AxisControl y { get; set; }

        public override Vector2 ReadUnprocessedValueFromState(void* statePtr) =>
            new(x.ReadUnprocessedValueFromState(statePtr), y.ReadUnprocessedValueFromState(statePtr));

        public override void WriteValueIntoState(Vector2 value, void* statePtr)
        {
            x.WriteValueIntoState(value.x, statePtr);
            y.WriteValueIntoState(value.y, statePtr);
        }

        public override float EvaluateMagnitude(void* statePtr) => ReadValueFromState(statePtr).magnitude;

        protected override void FinishSetup()
        {
            x = GetChildControl<AxisControl>("x");
            y = GetChildControl<AxisControl>("y");
            base.FinishSetup();
        }
    }

    /// <summary>Three numbers.</summary>
    public unsafe class Vector3Control : InputControl<Vector3>
    {
        public Vector3Control() => m_StateBlock.format = InputStateBlock.FormatVector3;

        [InputControl(offset = 0, displayName = "X")]
        public AxisControl x { get; set; }

        [InputControl(offset = 4, displayName = "Y")]
        public AxisControl y { get; set; }

        [InputControl(offset = 8, displayName = "Z")]
        public AxisControl z { get; set; }

        public override Vector3 ReadUnprocessedValueFromState(void* statePtr) => new(
            x.ReadUnprocessedValueFromState(statePtr), y.ReadUnprocessedValueFromState(statePtr), z.ReadUnprocessedValueFromState(statePtr));

        public override void WriteValueIntoState(Vector3 value, void* statePtr)
        {
            x.WriteValueIntoState(value.x, statePtr);
            y.WriteValueIntoState(value.y, statePtr);
            z.WriteValueIntoState(value.z, statePtr);
        }

        public override float EvaluateMagnitude(void* statePtr) => ReadValueFromState(statePtr).magnitude;

        protected override void FinishSetup()
        {
            x = GetChildControl<AxisControl>("x");
            y = GetChildControl<AxisControl>("y");
            z = GetChildControl<AxisControl>("z");
            base.FinishSetup();
        }
    }

    /// <summary>A rotation.</summary>
    public unsafe class QuaternionControl : InputControl<Quaternion>
    {
        public QuaternionControl() => m_StateBlock.format = InputStateBlock.FormatQuaternion;

        [InputControl(displayName = "X")]
        public AxisControl x { get; set; }

        [InputControl(displayName = "Y")]
        public AxisControl y { get; set; }

        [InputControl(displayName = "Z")]
        public AxisControl z { get; set; }

        [InputControl(displayName = "W", defaultState = "1")]
        public AxisControl w { get; set; }

        public override Quaternion ReadUnprocessedValueFromState(void* statePtr) => new(
            x.ReadUnprocessedValueFromState(statePtr), y.ReadUnprocessedValueFromState(statePtr),
            z.ReadUnprocessedValueFromState(statePtr), w.ReadUnprocessedValueFromState(statePtr));

        public override void WriteValueIntoState(Quaternion value, void* statePtr)
        {
            x.WriteValueIntoState(value.x, statePtr);
            y.WriteValueIntoState(value.y, statePtr);
            z.WriteValueIntoState(value.z, statePtr);
            w.WriteValueIntoState(value.w, statePtr);
        }

        protected override void FinishSetup()
        {
            x = GetChildControl<AxisControl>("x");
            y = GetChildControl<AxisControl>("y");
            z = GetChildControl<AxisControl>("z");
            w = GetChildControl<AxisControl>("w");
            base.FinishSetup();
        }
    }
}
