using System;
using System.Reflection;

namespace UnityEngine.Events
{
    /// <summary>What a listener wired in the Inspector is called with.</summary>
    public enum PersistentListenerMode
    {
        EventDefined = 0,
        Void = 1,
        Object = 2,
        Int = 3,
        Float = 4,
        String = 5,
        Bool = 6,
    }

    /// <summary>When a listener wired in the Inspector is called.</summary>
    public enum UnityEventCallState
    {
        Off = 0,
        EditorAndRuntime = 1,
        RuntimeOnly = 2,
    }

    /// <summary>A listener wired in the Inspector.</summary>
    sealed class PersistentCall
    {
        readonly MethodInfo m_Method;
        readonly PersistentListenerMode m_Mode;
        readonly object m_Argument;

        /// <param name="target">Whom to call; null calls nobody.</param>
        /// <param name="methodName">The method's name.</param>
        /// <param name="method">The method; null for a target of which the host has only the data.</param>
        /// <param name="mode">What it is called with.</param>
        /// <param name="argument">The argument, if it is fixed.</param>
        /// <param name="state">When it is called.</param>
        internal PersistentCall(
            Object target, string methodName, MethodInfo method, PersistentListenerMode mode, object argument, UnityEventCallState state)
        {
            Target = target;
            MethodName = methodName;
            State = state;
            m_Method = method;
            m_Mode = mode;
            m_Argument = argument;
        }

        internal Object Target { get; }

        internal string MethodName { get; }

        internal UnityEventCallState State { get; set; }

        /// <summary>What the method's parameters have to be.</summary>
        internal static Type[] ArgumentTypes(UnityEventBase owner, PersistentListenerMode mode, object argument)
        {
            switch (mode)
            {
                case PersistentListenerMode.EventDefined:
                    var type = owner.GetType();
                    while (type.BaseType != typeof(UnityEventBase))
                        type = type.BaseType;
                    return type.GetGenericArguments();
                case PersistentListenerMode.Void:
                    return Type.EmptyTypes;
                case PersistentListenerMode.Object:
                    return new[] { argument?.GetType() ?? typeof(Object) };
                default:
                    return new[] { argument.GetType() };
            }
        }

        internal PersistentCall For(Func<Object, Object> remap) =>
            new(Target is null ? null : remap(Target), MethodName, m_Method, m_Mode, m_Argument is Object o ? remap(o) : m_Argument, State);

        internal void Invoke(object[] arguments)
        {
            if (State == UnityEventCallState.Off || (State == UnityEventCallState.RuntimeOnly && !Application.isPlaying) || !Object.IsAlive(Target))
                return;
            if (m_Method == null)
            {
                Debug.LogWarning($"'{MethodName}' of '{Target.NameForMessages}' is not called: the host has only the data of that component");
                return;
            }

            var passed = m_Mode switch
            {
                PersistentListenerMode.EventDefined => arguments,
                PersistentListenerMode.Void => Array.Empty<object>(),
                _ => new[] { m_Argument },
            };
            m_Method.Invoke(Target, BindingFlags.DoNotWrapExceptions, null, passed, null);
        }
    }
}
