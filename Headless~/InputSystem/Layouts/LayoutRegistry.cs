using System;
using System.Collections.Generic;
using UnityEngine.InputSystem.Controls;

namespace UnityEngine.InputSystem
{
    /// <summary>Names of classes: of devices and controls, of processors and of composites. Case does not matter.</summary>
    sealed class LayoutRegistry
    {
        readonly Dictionary<string, Type> m_Layouts = new(StringComparer.OrdinalIgnoreCase);
        readonly Dictionary<string, ControlLayout> m_Read = new(StringComparer.OrdinalIgnoreCase);
        readonly Dictionary<string, Type> m_Processors = new(StringComparer.OrdinalIgnoreCase);
        readonly Dictionary<string, Type> m_Composites = new(StringComparer.OrdinalIgnoreCase);

        internal IEnumerable<string> Layouts => m_Layouts.Keys;

        internal IEnumerable<string> Processors => m_Processors.Keys;

        internal void AddLayout(Type type, string name)
        {
            if (type == null)
                throw new ArgumentNullException(nameof(type));
            if (!typeof(InputControl).IsAssignableFrom(type))
                throw new ArgumentException($"'{type.Name}' is no InputControl", nameof(type));
            name = string.IsNullOrEmpty(name) ? type.Name : name;
            m_Layouts[name] = type;
            m_Read.Remove(name);
        }

        internal void RemoveLayout(string name)
        {
            m_Layouts.Remove(name);
            m_Read.Remove(name);
        }

        internal void AddProcessor(Type type, string name) => m_Processors[Trimmed(type, name, "Processor")] = type;

        internal void AddComposite(Type type, string name) => m_Composites[Trimmed(type, name, "Composite")] = type;

        internal Type Processor(string name) => m_Processors.TryGetValue(name, out var type) ? type : null;

        internal Type Composite(string name) => m_Composites.TryGetValue(name, out var type) ? type : null;

        internal bool Has(string layout) => m_Layouts.ContainsKey(layout);

        /// <exception cref="ArgumentException">There is no layout of that name.</exception>
        internal ControlLayout Layout(string name)
        {
            if (m_Read.TryGetValue(name, out var layout))
                return layout;
            if (!m_Layouts.TryGetValue(name, out var type))
                throw new ArgumentException($"Cannot find layout '{name}'");
            layout = ControlLayout.Of(name, type);
            m_Read.Add(name, layout);
            return layout;
        }

        /// <summary>The name under which a class was registered first.</summary>
        internal string RegisteredName(Type type)
        {
            foreach (var (name, registered) in m_Layouts)
                if (registered == type)
                    return name;
            return null;
        }

        /// <summary>Whether something of the first layout is something of the second, which is the same or one it is based on.</summary>
        internal bool IsBasedOn(string layout, string ancestor)
        {
            if (string.Equals(layout, ancestor, StringComparison.OrdinalIgnoreCase))
                return true;
            return m_Layouts.TryGetValue(layout, out var type) && m_Layouts.TryGetValue(ancestor, out var wanted) && type != wanted
                && wanted.IsAssignableFrom(type);
        }

        internal InputProcessor MakeProcessor(NameWithParameters text, string mentionedIn)
        {
            var type = Processor(text.Name)
                ?? throw new InvalidOperationException($"No InputProcessor with name '{text.Name}' (mentioned in '{mentionedIn}') has been registered");
            var processor = (InputProcessor)Activator.CreateInstance(type);
            NameWithParameters.Apply(text.Parameters, processor);
            return processor;
        }

        /// <summary>The layout of a control class of the system's own: ButtonControl is "Button".</summary>
        internal static string NameOf(Type type) =>
            InputManager.Instance.Layouts.RegisteredName(type)
                ?? throw new ArgumentException($"The control class {type.Name} is not registered; call InputSystem.RegisterLayout<{type.Name}>() first");

        static string Trimmed(Type type, string name, string ending)
        {
            if (type == null)
                throw new ArgumentNullException(nameof(type));
            if (!string.IsNullOrEmpty(name))
                return name;
            return type.Name.EndsWith(ending, StringComparison.Ordinal) ? type.Name.Substring(0, type.Name.Length - ending.Length) : type.Name;
        }
    }

    /// <summary>What is there from the beginning.</summary>
    static class BuiltinLayouts
    {
        internal static void Register(LayoutRegistry registry)
        {
            registry.AddLayout(typeof(AxisControl), "Axis");
            registry.AddLayout(typeof(AxisControl), "Analog");
            registry.AddLayout(typeof(ButtonControl), "Button");
            registry.AddLayout(typeof(DiscreteButtonControl), "DiscreteButton");
            registry.AddLayout(typeof(KeyControl), "Key");
            registry.AddLayout(typeof(AnyKeyControl), "AnyKey");
            registry.AddLayout(typeof(IntegerControl), "Integer");
            registry.AddLayout(typeof(IntegerControl), "Digital");
            registry.AddLayout(typeof(Vector2Control), "Vector2");
            registry.AddLayout(typeof(Vector3Control), "Vector3");
            registry.AddLayout(typeof(QuaternionControl), "Quaternion");
            registry.AddLayout(typeof(DeltaControl), "Delta");
            registry.AddLayout(typeof(StickControl), "Stick");
            registry.AddLayout(typeof(Pointer), null);
            registry.AddLayout(typeof(Mouse), null);
            registry.AddLayout(typeof(Keyboard), null);
            registry.AddLayout(typeof(TrackedDevice), null);
            registry.AddLayout(typeof(XR.XRController), null);

            registry.AddProcessor(typeof(Processors.ScaleProcessor), null);
            registry.AddProcessor(typeof(Processors.InvertProcessor), null);
            registry.AddProcessor(typeof(Processors.ClampProcessor), null);
            registry.AddProcessor(typeof(Processors.NormalizeProcessor), null);
            registry.AddProcessor(typeof(Processors.AxisDeadzoneProcessor), null);
            registry.AddProcessor(typeof(Processors.ScaleVector2Processor), null);
            registry.AddProcessor(typeof(Processors.InvertVector2Processor), null);
            registry.AddProcessor(typeof(Processors.NormalizeVector2Processor), null);
            registry.AddProcessor(typeof(Processors.StickDeadzoneProcessor), null);

            registry.AddComposite(typeof(Composites.AxisComposite), "1DAxis");
            registry.AddComposite(typeof(Composites.AxisComposite), "Axis");
            registry.AddComposite(typeof(Composites.Vector2Composite), "2DVector");
            registry.AddComposite(typeof(Composites.Vector2Composite), "Dpad");
            registry.AddComposite(typeof(Composites.ButtonWithOneModifier), null);
            registry.AddComposite(typeof(Composites.ButtonWithTwoModifiers), null);
            registry.AddComposite(typeof(Composites.OneModifierComposite), "OneModifier");
            registry.AddComposite(typeof(Composites.TwoModifiersComposite), "TwoModifiers");
        }
    }
}
