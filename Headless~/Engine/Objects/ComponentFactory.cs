using System;
using System.Linq;
using System.Reflection;

namespace UnityEngine
{
    /// <summary>Makes components and the rules for having them.</summary>
    static class ComponentFactory
    {
        [ThreadStatic]
        static GameObject s_Owner;

        /// <summary>The GameObject that the component under construction belongs to; null for a plain <c>new</c>.</summary>
        internal static GameObject TakeOwner(Component component)
        {
            var owner = s_Owner;
            s_Owner = null;
            return owner;
        }

        /// <summary>Constructs and attaches, without Awake.</summary>
        internal static Component Construct(Type type, GameObject owner)
        {
            s_Owner = owner;
            try
            {
                var component = (Component)Construct(type);
                owner.Attach(component);
                return component;
            }
            finally
            {
                s_Owner = null;
            }
        }

        /// <summary>Runs the parameterless constructor, of any visibility; what it throws arrives unwrapped.</summary>
        internal static object Construct(Type type) => Activator.CreateInstance(type,
            BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.CreateInstance
                | BindingFlags.DoNotWrapExceptions, null, null, null);

        /// <summary>AddComponent: required ones first, then this; on an active object Awake and OnEnable have run on return.</summary>
        internal static Component Add(GameObject owner, Type type)
        {
            if (type == null)
                throw new ArgumentNullException(nameof(type));
            if (!typeof(Component).IsAssignableFrom(type) || type.IsAbstract || type.ContainsGenericParameters || type == typeof(Component)
                || type == typeof(Behaviour))
            {
                Debug.LogError($"Can't add component '{type.Name}' to {owner.NameForMessages} because it is no component that can be added");
                return null;
            }

            if (type == typeof(RectTransform) && owner.OwnTransform is not RectTransform)
                return owner.MakeRectTransform();
            if (IsRefusedAsSecond(owner, type))
            {
                Debug.LogError($"Can't add component '{type.Name}' to {owner.NameForMessages} because such a component is already added to the game object!");
                return null;
            }

            foreach (var required in Required(type))
                if (owner.GetComponent(required) == null && Add(owner, required) == null)
                    return null;
            var component = Construct(type, owner);
            if (component is MonoBehaviour script)
                Validation.SendAdded(script);
            if (component is Behaviour behaviour)
                behaviour.ActivateIfNeeded();
            return component;
        }

        /// <summary>The component that needs this one and would be left without it; null if there is none.</summary>
        internal static Component Dependent(Component component)
        {
            foreach (var other in component.Owner.Components)
            {
                if (ReferenceEquals(other, component))
                    continue;
                foreach (var required in Required(other.GetType()))
                    if (required.IsInstanceOfType(component) && component.Owner.Components.Count(c => required.IsInstanceOfType(c)) == 1)
                        return other;
            }

            return null;
        }

        static bool IsRefusedAsSecond(GameObject owner, Type type)
        {
            if (type == typeof(Transform) || type == typeof(RectTransform))
                return true;
            // The attribute forbids a second one of the class that bears it and of its subclasses.
            for (var t = type; t != null; t = t.BaseType)
                if (t.IsDefined(typeof(DisallowMultipleComponent), false) && owner.GetComponent(t) != null)
                    return true;
            return false;
        }

        /// <summary>The components that a class cannot be without.</summary>
        internal static Type[] Required(Type type) => type.GetCustomAttributes<RequireComponent>(true)
            .SelectMany(a => new[] { a.m_Type0, a.m_Type1, a.m_Type2 }).Where(t => t != null).Distinct().ToArray();
    }
}
