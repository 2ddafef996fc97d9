using System;

namespace UnityEngine.InputSystem
{
    /// <summary>Changes a value on its way from a control or a binding. Its public fields are its parameters.</summary>
    public abstract unsafe class InputProcessor
    {
        protected InputProcessor()
        {
        }

        public abstract object ProcessAsObject(object value, InputControl control);

        public abstract void Process(void* buffer, int bufferSize, InputControl control);
    }

    /// <summary>A processor for one type of values; others it leaves alone.</summary>
    public abstract unsafe class InputProcessor<TValue> : InputProcessor where TValue : struct
    {
        protected InputProcessor()
        {
        }

        public abstract TValue Process(TValue value, InputControl control);

        public override object ProcessAsObject(object value, InputControl control)
        {
            if (value == null)
                throw new ArgumentNullException(nameof(value));
            return value is TValue typed
                ? Process(typed, control)
                : throw new ArgumentException($"Expecting value of type '{typeof(TValue).Name}' but got value '{value}' of type '{value.GetType().Name}'",
                    nameof(value));
        }

        public override void Process(void* buffer, int bufferSize, InputControl control)
        {
            if (bufferSize < Values.SizeOf<TValue>())
                throw new ArgumentException($"Expected buffer of at least {Values.SizeOf<TValue>()} bytes but got buffer with just {bufferSize} bytes",
                    nameof(bufferSize));
            Values.Write(Process(Values.Read<TValue>(buffer, bufferSize), control), buffer, bufferSize);
        }
    }
}
