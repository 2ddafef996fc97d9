using System;

namespace UnityEngine.InputSystem
{
    /// <summary>Makes one value of several bindings, its parts. Its public int fields are the parts' numbers, other public fields its parameters.</summary>
    public abstract unsafe class InputBindingComposite
    {
        protected InputBindingComposite()
        {
        }

        public abstract Type valueType { get; }

        public abstract int valueSizeInBytes { get; }

        public abstract void ReadValue(ref InputBindingCompositeContext context, void* buffer, int bufferSize);

        public abstract object ReadValueAsObject(ref InputBindingCompositeContext context);

        /// <summary>How far it is from rest; -1 where that means nothing.</summary>
        public virtual float EvaluateMagnitude(ref InputBindingCompositeContext context) => -1f;

        /// <summary>When its parts have their controls.</summary>
        protected virtual void FinishSetup(ref InputBindingCompositeContext context)
        {
        }

        internal void SendFinishSetup(BoundBinding binding)
        {
            var context = new InputBindingCompositeContext(binding);
            FinishSetup(ref context);
        }
    }

    /// <summary>A composite whose value is a <typeparamref name="TValue"/>.</summary>
    public abstract unsafe class InputBindingComposite<TValue> : InputBindingComposite where TValue : struct
    {
        protected InputBindingComposite()
        {
        }

        public override Type valueType => typeof(TValue);

        public override int valueSizeInBytes => Values.SizeOf<TValue>();

        public abstract TValue ReadValue(ref InputBindingCompositeContext context);

        public override void ReadValue(ref InputBindingCompositeContext context, void* buffer, int bufferSize) =>
            Values.Write(ReadValue(ref context), buffer, bufferSize);

        public override object ReadValueAsObject(ref InputBindingCompositeContext context) => ReadValue(ref context);
    }
}
