using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace UnityEngine.InputSystem
{
    /// <summary>Finds the controls that a map's bindings mean, and makes their composites and processors.</summary>
    sealed class BindingResolver
    {
        readonly ActionMapState m_State;
        readonly InputActionMap m_Map;
        readonly IReadOnlyCollection<InputDevice> m_Devices;
        BoundBinding m_Composite;
        int m_Parts;

        internal BindingResolver(ActionMapState state)
        {
            m_State = state;
            m_Map = state.Map;
            m_Devices = m_Map.devices is { } chosen ? chosen.Where(d => d.added).ToArray() : InputManager.Instance.Devices;
        }

        internal BoundBinding[] Resolve()
        {
            var bound = new List<BoundBinding>();
            foreach (var binding in m_Map.m_Bindings)
                try
                {
                    bound.Add(Bind(binding));
                }
                catch (Exception e) when (e is FormatException or ArgumentException or InvalidOperationException)
                {
                    Debug.LogError($"{e.GetType().Name} while resolving binding '{binding}' in action map '{m_Map}'");
                    Debug.LogException(e);
                    bound.Add(new BoundBinding(m_State, binding, null));
                }

            foreach (var composite in bound.Where(b => b.IsComposite))
                composite.Instance.SendFinishSetup(composite);
            return bound.ToArray();
        }

        BoundBinding Bind(InputBinding source)
        {
            var action = source.isPartOfComposite && m_Composite != null
                ? m_Composite.Action
                : Array.Find(m_Map.m_Actions, a => source.Triggers(a)) ?? m_Map.m_SingletonAction;
            var bound = new BoundBinding(m_State, source, action);
            if (!source.isPartOfComposite)
                m_Composite = null;
            if (action == null || string.IsNullOrEmpty(source.effectivePath) || (!source.isComposite && IsMaskedOut(source, action)))
                return bound;
            CheckInteractions(source, action);
            // An action's processors work on the parts of its composites too, as in Unity.
            bound.Processors = Processors(source.effectiveProcessors).Concat(Processors(action.m_Processors)).ToArray();
            if (source.isComposite)
            {
                bound.Instance = MakeComposite(NameWithParameters.Parse(source.effectivePath));
                m_Composite = bound;
                m_Parts = 0;
                return bound;
            }

            bound.Controls.AddRange(InputControlPath.FindIn(m_Devices, source.effectivePath).Distinct().Select(c => new BoundControl(bound, c)));
            if (source.isPartOfComposite && m_Composite != null && bound.Controls.Count > 0)
                JoinComposite(bound);
            return bound;
        }

        /// <summary>The part's name is that of one of the composite's public int fields, which gets the part's number.</summary>
        void JoinComposite(BoundBinding part)
        {
            if (string.IsNullOrEmpty(part.Source.name))
                throw new InvalidOperationException($"Binding '{part.Source}' that is part of composite '{m_Composite.Instance}' is missing a name");
            var field = m_Composite.Instance.GetType().GetField(part.Source.name, BindingFlags.Instance | BindingFlags.Public | BindingFlags.IgnoreCase);
            if (field == null || field.FieldType != typeof(int))
                throw new InvalidOperationException(
                    $"Cannot find public field '{part.Source.name}' used as parameter of binding composite '{m_Composite.Instance}'");
            var number = (int)field.GetValue(m_Composite.Instance);
            if (number == 0)
                field.SetValue(m_Composite.Instance, number = ++m_Parts);
            part.Composite = m_Composite;
            part.PartNumber = number;
            m_Composite.Parts.Add(part);
        }

        bool IsMaskedOut(InputBinding source, InputAction action)
        {
            bool Excludes(InputBinding? mask) => mask is { } given && !given.Matches(source, true);
            return Excludes(m_Map.asset != null ? m_Map.asset.bindingMask : null) || Excludes(m_Map.bindingMask) || Excludes(action.m_BindingMask);
        }

        static InputProcessor[] Processors(string text) => string.IsNullOrEmpty(text)
            ? Array.Empty<InputProcessor>()
            : NameWithParameters.ParseMultiple(text).Select(p => InputManager.Instance.Layouts.MakeProcessor(p, text)).ToArray();

        static InputBindingComposite MakeComposite(NameWithParameters text)
        {
            var type = InputManager.Instance.Layouts.Composite(text.Name)
                ?? throw new InvalidOperationException($"No binding composite with name '{text.Name}' has been registered");
            var composite = (InputBindingComposite)Activator.CreateInstance(type);
            NameWithParameters.Apply(text.Parameters, composite);
            return composite;
        }

        /// <summary>An action with an interaction would behave otherwise without it, so that is said.</summary>
        static void CheckInteractions(InputBinding source, InputAction action)
        {
            var text = string.IsNullOrEmpty(source.effectiveInteractions) ? action.m_Interactions : source.effectiveInteractions;
            if (!string.IsNullOrEmpty(text))
                throw new InvalidOperationException($"No IInputInteraction with name '{text}' has been registered: the host has none");
        }
    }
}
