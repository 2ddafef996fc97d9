using System;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine.Events
{
    /// <summary>Listeners in order: those wired in the Inspector, then those added by code.</summary>
    [Serializable]
    public abstract class UnityEventBase : ISerializationCallbackReceiver
    {
        readonly List<PersistentCall> m_Persistent = new();
        List<Delegate> m_Calls = new();

        protected UnityEventBase()
        {
        }

        internal List<PersistentCall> PersistentCalls => m_Persistent;

        public int GetPersistentEventCount() => m_Persistent.Count;

        public Object GetPersistentTarget(int index) => m_Persistent[index].Target;

        public string GetPersistentMethodName(int index) => m_Persistent[index].MethodName;

        public UnityEventCallState GetPersistentListenerState(int index) => m_Persistent[index].State;

        public void SetPersistentListenerState(int index, UnityEventCallState state) => m_Persistent[index].State = state;

        /// <summary>Removes those added by code.</summary>
        public void RemoveAllListeners() => m_Calls = new List<Delegate>();

        public override string ToString() => base.ToString() + " " + GetType().FullName;

        void ISerializationCallbackReceiver.OnBeforeSerialize()
        {
        }

        void ISerializationCallbackReceiver.OnAfterDeserialize()
        {
        }

        protected abstract MethodInfo FindMethod_Impl(string name, Type targetObjType);

        /// <summary>The method of that name and those parameters, of any visibility, up the class hierarchy; null if there is none.</summary>
        public static MethodInfo GetValidMethodInfo(Type objectType, string functionName, Type[] argumentTypes)
        {
            for (; objectType != null && objectType != typeof(object); objectType = objectType.BaseType)
                if (objectType.GetMethod(functionName, BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public
                    | BindingFlags.NonPublic, null, argumentTypes, null) is { } method)
                    return method;
            return null;
        }

        internal void Add(Delegate call)
        {
            if (call == null)
                throw new ArgumentNullException(nameof(call));
            // A running Invoke goes on over the list that it began with.
            m_Calls = new List<Delegate>(m_Calls) { call };
        }

        internal void Remove(Delegate call) => m_Calls = m_Calls.FindAll(c => !Equals(c, call));

        /// <summary>Listeners of destroyed objects are passed over; an exception ends the round and reaches the caller.</summary>
        internal void Call<TCall>(Action<TCall> invoke) where TCall : Delegate
        {
            foreach (var call in m_Calls)
                if (call.Target is not Object target || Object.IsAlive(target))
                    invoke((TCall)call);
        }

        /// <summary>The listeners wired in the Inspector, which come first.</summary>
        internal void CallPersistent(object[] arguments)
        {
            foreach (var call in m_Persistent)
                call.Invoke(arguments);
        }
    }

    [Serializable]
    public class UnityEvent : UnityEventBase
    {
        public UnityEvent()
        {
        }

        public void AddListener(UnityAction call) => Add(call);

        public void RemoveListener(UnityAction call) => Remove(call);

        public void Invoke()
        {
            if (PersistentCalls.Count > 0)
                CallPersistent(Array.Empty<object>());
            Call<UnityAction>(c => c());
        }

        protected override MethodInfo FindMethod_Impl(string name, Type targetObjType) => GetValidMethodInfo(targetObjType, name, Type.EmptyTypes);
    }

    [Serializable]
    public class UnityEvent<T0> : UnityEventBase
    {
        public UnityEvent()
        {
        }

        public void AddListener(UnityAction<T0> call) => Add(call);

        public void RemoveListener(UnityAction<T0> call) => Remove(call);

        public void Invoke(T0 arg0)
        {
            if (PersistentCalls.Count > 0)
                CallPersistent(new object[] { arg0 });
            Call<UnityAction<T0>>(c => c(arg0));
        }

        protected override MethodInfo FindMethod_Impl(string name, Type targetObjType) => GetValidMethodInfo(targetObjType, name, new[] { typeof(T0) });
    }

    [Serializable]
    public class UnityEvent<T0, T1> : UnityEventBase
    {
        public UnityEvent()
        {
        }

        public void AddListener(UnityAction<T0, T1> call) => Add(call);

        public void RemoveListener(UnityAction<T0, T1> call) => Remove(call);

        public void Invoke(T0 arg0, T1 arg1)
        {
            if (PersistentCalls.Count > 0)
                CallPersistent(new object[] { arg0, arg1 });
            Call<UnityAction<T0, T1>>(c => c(arg0, arg1));
        }

        protected override MethodInfo FindMethod_Impl(string name, Type targetObjType) =>
            GetValidMethodInfo(targetObjType, name, new[] { typeof(T0), typeof(T1) });
    }
}
