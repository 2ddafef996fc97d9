using System;
using System.Collections.Generic;
using System.Reflection;
using System.Runtime.InteropServices;

namespace UnityEngine.InputSystem
{
    /// <summary>A control whose value is a <typeparamref name="TValue"/>.</summary>
    public abstract unsafe class InputControl<TValue> : InputControl where TValue : struct
    {
        TValue m_Value;

        protected InputControl()
        {
        }

        public override Type valueType => typeof(TValue);

        public override int valueSizeInBytes => Values.SizeOf<TValue>();

        /// <summary>The value after processors.</summary>
        public ref readonly TValue value
        {
            get
            {
                m_Value = ReadValue();
                return ref m_Value;
            }
        }

        public TValue ReadValue() => ReadValueFromState(currentStatePtr);

        /// <summary>What it was at the end of the frame before.</summary>
        public TValue ReadValueFromPreviousFrame() => ReadValueFromState(previousFrameStatePtr);

        public TValue ReadDefaultValue() => ReadValueFromState(defaultStatePtr);

        /// <summary>The value before processors.</summary>
        public TValue ReadUnprocessedValue() => ReadUnprocessedValueFromState(currentStatePtr);

        public TValue ReadValueFromState(void* statePtr) => ProcessValue(ReadUnprocessedValueFromState(statePtr));

        public abstract TValue ReadUnprocessedValueFromState(void* statePtr);

        /// <exception cref="NotSupportedException">The control cannot be written.</exception>
        public virtual void WriteValueIntoState(TValue value, void* statePtr) =>
            throw new NotSupportedException($"Control '{this}' does not support writing");

        public TValue ProcessValue(TValue value)
        {
            foreach (var processor in m_ProcessorStack)
                if (processor is InputProcessor<TValue> typed)
                    value = typed.Process(value, this);
            return value;
        }

        public override bool CompareValue(void* firstStatePtr, void* secondStatePtr) =>
            !EqualityComparer<TValue>.Default.Equals(ReadValueFromState(firstStatePtr), ReadValueFromState(secondStatePtr));

        public override object ReadValueFromBufferAsObject(void* buffer, int bufferSize) => Values.Read<TValue>(buffer, bufferSize);

        public override object ReadValueFromStateAsObject(void* statePtr) => ReadValueFromState(statePtr);

        public override void ReadValueFromStateIntoBuffer(void* statePtr, void* bufferPtr, int bufferSize)
        {
            if (bufferSize < valueSizeInBytes)
                throw new ArgumentException($"bufferSize={bufferSize} < sizeof(TValue)={valueSizeInBytes}", nameof(bufferSize));
            Values.Write(ReadValueFromState(statePtr), bufferPtr, bufferSize);
        }
    }

    /// <summary>Values of unknown type in memory.</summary>
    static unsafe class Values
    {
        internal static int SizeOf<T>() where T : struct
        {
            var value = default(T);
            return MemoryMarshal.AsBytes(MemoryMarshal.CreateReadOnlySpan(ref value, 1)).Length;
        }

        internal static int SizeOf(Type type) =>
            (int)typeof(Values).GetMethod(nameof(SizeOf), BindingFlags.Static | BindingFlags.NonPublic, null, Type.EmptyTypes, null)!
                .MakeGenericMethod(type).Invoke(null, null);

        internal static void Write<T>(T value, void* buffer, int size) where T : struct => MemoryMarshal.Write(new Span<byte>(buffer, size), ref value);

        internal static T Read<T>(void* buffer, int size) where T : struct => MemoryMarshal.Read<T>(new ReadOnlySpan<byte>(buffer, size));
    }
}
