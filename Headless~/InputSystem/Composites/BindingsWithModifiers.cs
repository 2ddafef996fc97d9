using System;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem.Composites
{
    /// <summary>A binding to anything, which counts while a button is held.</summary>
    [DisplayStringFormat("{modifier}+{binding}")]
    public unsafe class OneModifierComposite : InputBindingComposite
    {
        public int modifier;
        public int binding;

        Type m_ValueType;
        int m_ValueSize;

        public override Type valueType => m_ValueType;

        public override int valueSizeInBytes => m_ValueSize;

        public override float EvaluateMagnitude(ref InputBindingCompositeContext context) =>
            context.ReadValueAsButton(modifier) ? context.EvaluateMagnitude(binding) : 0f;

        public override void ReadValue(ref InputBindingCompositeContext context, void* buffer, int bufferSize)
        {
            new Span<byte>(buffer, bufferSize).Clear();
            if (context.ReadValueAsButton(modifier))
                context.ReadValue(binding, buffer, bufferSize);
        }

        public override object ReadValueAsObject(ref InputBindingCompositeContext context) =>
            context.ReadValueAsButton(modifier) ? context.ReadValueAsObject(binding) : null;

        protected override void FinishSetup(ref InputBindingCompositeContext context) =>
            (m_ValueType, m_ValueSize) = ValueTypeOf(ref context, binding);

        internal static (Type Type, int Size) ValueTypeOf(ref InputBindingCompositeContext context, int part)
        {
            Type type = null;
            var size = 0;
            foreach (var control in context.controls)
            {
                if (control.part != part)
                    continue;
                type = type == null || type == control.control.valueType ? control.control.valueType : typeof(object);
                size = Math.Max(size, control.control.valueSizeInBytes);
            }

            return (type, size);
        }
    }

    /// <summary>A binding to anything, which counts while two buttons are held.</summary>
    [DisplayStringFormat("{modifier1}+{modifier2}+{binding}")]
    public unsafe class TwoModifiersComposite : InputBindingComposite
    {
        public int modifier1;
        public int modifier2;
        public int binding;

        Type m_ValueType;
        int m_ValueSize;

        public override Type valueType => m_ValueType;

        public override int valueSizeInBytes => m_ValueSize;

        public override float EvaluateMagnitude(ref InputBindingCompositeContext context) =>
            AreHeld(ref context) ? context.EvaluateMagnitude(binding) : 0f;

        public override void ReadValue(ref InputBindingCompositeContext context, void* buffer, int bufferSize)
        {
            new Span<byte>(buffer, bufferSize).Clear();
            if (AreHeld(ref context))
                context.ReadValue(binding, buffer, bufferSize);
        }

        public override object ReadValueAsObject(ref InputBindingCompositeContext context) =>
            AreHeld(ref context) ? context.ReadValueAsObject(binding) : null;

        protected override void FinishSetup(ref InputBindingCompositeContext context) =>
            (m_ValueType, m_ValueSize) = OneModifierComposite.ValueTypeOf(ref context, binding);

        bool AreHeld(ref InputBindingCompositeContext context) => context.ReadValueAsButton(modifier1) && context.ReadValueAsButton(modifier2);
    }
}
