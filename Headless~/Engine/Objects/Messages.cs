using System;
using System.Collections;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine
{
    /// <summary>The message methods of one script class.</summary>
    sealed class Messages
    {
        static readonly Dictionary<Type, Messages> s_Known = new();

        Messages(Type type)
        {
            Awake = new Message(type, "Awake");
            OnEnable = new Message(type, "OnEnable");
            Start = new Message(type, "Start");
            FixedUpdate = new Message(type, "FixedUpdate");
            Update = new Message(type, "Update");
            LateUpdate = new Message(type, "LateUpdate");
            OnPreCull = new Message(type, "OnPreCull");
            OnPreRender = new Message(type, "OnPreRender");
            OnPostRender = new Message(type, "OnPostRender");
            OnDisable = new Message(type, "OnDisable");
            OnDestroy = new Message(type, "OnDestroy");
            OnApplicationQuit = new Message(type, "OnApplicationQuit");
            OnTransformParentChanged = new Message(type, "OnTransformParentChanged");
            OnTransformChildrenChanged = new Message(type, "OnTransformChildrenChanged");
            OnValidate = new Message(type, "OnValidate");
            Reset = new Message(type, "Reset");
            RunsInEditMode = type.IsDefined(typeof(ExecuteAlways), true) || type.IsDefined(typeof(ExecuteInEditMode), true);
            ExecutionOrder = type.GetCustomAttribute<DefaultExecutionOrder>(true)?.order ?? 0;
        }

        internal Message Awake { get; }
        internal Message OnEnable { get; }
        internal Message Start { get; }
        internal Message FixedUpdate { get; }
        internal Message Update { get; }
        internal Message LateUpdate { get; }
        internal Message OnPreCull { get; }
        internal Message OnPreRender { get; }
        internal Message OnPostRender { get; }
        internal Message OnDisable { get; }
        internal Message OnDestroy { get; }
        internal Message OnApplicationQuit { get; }
        internal Message OnTransformParentChanged { get; }
        internal Message OnTransformChildrenChanged { get; }
        internal Message OnValidate { get; }
        internal Message Reset { get; }
        internal bool RunsInEditMode { get; }
        internal int ExecutionOrder { get; }

        internal static Messages Of(Type type)
        {
            lock (s_Known)
            {
                if (!s_Known.TryGetValue(type, out var messages))
                    s_Known.Add(type, messages = new Messages(type));
                return messages;
            }
        }
    }

    /// <summary>One message method: the most derived one of that name without parameters, of any visibility.</summary>
    sealed class Message
    {
        readonly MethodInfo m_Method;

        internal Message(Type type, string name)
        {
            for (var t = type; t != null && t != typeof(MonoBehaviour) && t != typeof(ScriptableObject) && m_Method == null; t = t.BaseType)
                m_Method = t.GetMethod(name, BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic
                    | BindingFlags.DeclaredOnly, null, Type.EmptyTypes, null);
        }

        internal bool Exists => m_Method != null;

        /// <summary>Calls the method, if there is one, and logs what it throws.</summary>
        /// <returns>False if it threw.</returns>
        internal bool Send(Object target)
        {
            if (m_Method == null)
                return true;
            return LogRouter.Guard(() => Invoke(target));
        }

        /// <summary>As Send, for a message that may be a coroutine: its enumerator, or null.</summary>
        internal IEnumerator SendRoutine(Object target)
        {
            IEnumerator routine = null;
            if (m_Method != null)
                LogRouter.Guard(() => routine = Invoke(target) as IEnumerator);
            return routine;
        }

        object Invoke(Object target) => m_Method.Invoke(target, BindingFlags.DoNotWrapExceptions, null, null, null);
    }
}
