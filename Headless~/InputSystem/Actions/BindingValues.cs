using System;

namespace UnityEngine.InputSystem
{
    /// <summary>Values of bound controls, through composites and processors.</summary>
    static unsafe class BindingValues
    {
        /// <exception cref="InvalidOperationException">The control's or the composite's value is of another type.</exception>
        internal static TValue Read<TValue>(BoundControl driver, InputAction action) where TValue : struct
        {
            var composite = driver.Binding.Composite;
            return composite == null ? ReadControl<TValue>(driver, action) : composite.Process(ReadComposite<TValue>(composite, action), null);
        }

        internal static object ReadAsObject(BoundControl driver)
        {
            var composite = driver.Binding.Composite;
            if (composite == null)
                return ReadControlAsObject(driver);
            var context = new InputBindingCompositeContext(composite);
            return Processed(composite.Instance.ReadValueAsObject(ref context), composite, null);
        }

        /// <summary>The control's own value with its binding's processors.</summary>
        internal static TValue ReadControl<TValue>(BoundControl bound, InputAction action) where TValue : struct
        {
            if (bound.Control is not InputControl<TValue> typed)
                throw new InvalidOperationException($"Cannot read value of type '{typeof(TValue).Name}' from control '{bound.Control.path}' bound to action "
                    + $"'{action}' (control is a '{bound.Control.GetType().Name}' with value type '{bound.Control.valueType.Name}')");
            return bound.Binding.Process(typed.value, typed);
        }

        internal static object ReadControlAsObject(BoundControl bound) =>
            Processed(bound.Control.ReadValueAsObject(), bound.Binding, bound.Control);

        internal static void ReadControl(BoundControl bound, void* buffer, int size)
        {
            bound.Control.ReadValueFromStateIntoBuffer(bound.Control.StateNow, buffer, size);
            foreach (var processor in bound.Binding.Processors)
                processor.Process(buffer, size, bound.Control);
        }

        static TValue ReadComposite<TValue>(BoundBinding composite, InputAction action) where TValue : struct
        {
            var context = new InputBindingCompositeContext(composite);
            if (composite.Instance is InputBindingComposite<TValue> typed)
                return typed.ReadValue(ref context);
            // What a modifier's composite passes on is of the type of the control behind it.
            if (!composite.Instance.valueType?.IsAssignableFrom(typeof(TValue)) ?? true)
                throw new InvalidOperationException($"Cannot read value of type '{typeof(TValue).Name}' from composite '{composite.Instance}' bound to "
                    + $"action '{action}' (its value type is '{composite.Instance.valueType?.Name}')");
            var size = Values.SizeOf<TValue>();
            var buffer = stackalloc byte[size];
            composite.Instance.ReadValue(ref context, buffer, size);
            return Values.Read<TValue>(buffer, size);
        }

        static object Processed(object value, BoundBinding binding, InputControl control)
        {
            foreach (var processor in binding.Processors)
                value = value == null ? null : processor.ProcessAsObject(value, control);
            return value;
        }
    }
}
