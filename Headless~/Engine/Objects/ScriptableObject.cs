using System;

namespace UnityEngine
{
    /// <summary>A script object without a GameObject: an asset's content.</summary>
    public class ScriptableObject : Object
    {
        [ThreadStatic]
        static bool s_Creating;

        public ScriptableObject()
        {
            if (!s_Creating)
                Debug.LogWarning($"{GetType().Name} must be instantiated using the ScriptableObject.CreateInstance method instead of new {GetType().Name}.");
            s_Creating = false;
        }

        /// <summary>Makes an instance; Awake and OnEnable have run on return.</summary>
        /// <exception cref="ArgumentException">The type is no ScriptableObject.</exception>
        public static ScriptableObject CreateInstance(Type type)
        {
            MainThread.Check("CreateScriptableObjectInstanceFromType");
            var instance = Construct(type);
            instance.SendAwake();
            return instance;
        }

        public static T CreateInstance<T>() where T : ScriptableObject => (T)CreateInstance(typeof(T));

        /// <summary>Constructs without messages.</summary>
        internal static ScriptableObject Construct(Type type)
        {
            if (type == null || !typeof(ScriptableObject).IsAssignableFrom(type))
                throw new ArgumentException("Type must inherit ScriptableObject.", nameof(type));
            s_Creating = true;
            try
            {
                return (ScriptableObject)ComponentFactory.Construct(type);
            }
            finally
            {
                s_Creating = false;
            }
        }

        internal void SendAwake()
        {
            var messages = Messages.Of(GetType());
            messages.Awake.Send(this);
            messages.OnEnable.Send(this);
        }

        internal void SendDestroy()
        {
            var messages = Messages.Of(GetType());
            messages.OnDisable.Send(this);
            messages.OnDestroy.Send(this);
        }
    }
}
