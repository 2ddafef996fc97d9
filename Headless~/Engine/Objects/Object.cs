using System;
using System.Threading;

namespace UnityEngine
{
    /// <summary>Base of everything that has a native counterpart in Unity. Destroyed objects compare equal to null, and only they.</summary>
    public partial class Object
    {
        static int s_NextId;

        readonly int m_InstanceId;
        string m_Name = "";
        HideFlags m_HideFlags;
        bool m_Alive;

        /// <summary>Makes an object with a fresh instance ID (negative, as run-time objects have in Unity).</summary>
        public Object()
        {
            m_InstanceId = Interlocked.Add(ref s_NextId, -2);
            m_Alive = GetType() != typeof(Object);
            if (m_Alive)
                ObjectRegistry.Add(this);
        }

        /// <summary>The object's name. Components answer with their GameObject's.</summary>
        /// <exception cref="NullReferenceException">The object is destroyed.</exception>
        public string name
        {
            get { Use("get_name"); return NativeName; }
            set { Use("set_name"); NativeName = value ?? ""; }
        }

        public HideFlags hideFlags
        {
            get { Use("get_hideFlags"); return m_HideFlags; }
            set { Use("set_hideFlags"); m_HideFlags = value; }
        }

        /// <summary>The ID, which survives destruction.</summary>
        public int GetInstanceID()
        {
            if (!MainThread.IsCurrent)
                throw new InvalidOperationException("EnsureRunningOnMainThread can only be called from the main thread");
            return m_InstanceId;
        }

        public override int GetHashCode() => m_InstanceId;

        public override bool Equals(object other)
        {
            // As in Unity: something that is no Object at all differs, unless it is null and this is destroyed.
            var o = other as Object;
            if (o is null && other is not null)
                return false;
            return Same(this, o);
        }

        public override string ToString() => m_Alive ? $"{NativeName} ({GetType().FullName})" : "null";

        public static implicit operator bool(Object exists) => IsAlive(exists);

        public static bool operator ==(Object x, Object y) => Same(x, y);

        public static bool operator !=(Object x, Object y) => !Same(x, y);

        /// <summary>Where the name is kept; a component's is its GameObject's.</summary>
        internal virtual string NativeName { get => m_Name; set => m_Name = value; }

        /// <summary>The name, if it is asked for in a message: works on destroyed objects and on any thread.</summary>
        internal string NameForMessages => NativeName;

        internal int InstanceIdOnAnyThread => m_InstanceId;

        /// <summary>True for an object that came from a file of the package: those are not destroyed by accident.</summary>
        internal bool IsAsset { get; set; }

        internal static bool IsAlive(Object o) => o is not null && o.m_Alive;

        /// <summary>Called once when the object dies, on the main thread: frees what it holds outside the managed heap.</summary>
        internal virtual void OnNativeDestroy()
        {
        }

        /// <summary>Throws if the object is destroyed or the thread is not the main one.</summary>
        internal void Use(string api)
        {
            MainThread.Check(api);
            EnsureAlive();
        }

        internal void EnsureAlive()
        {
            if (!m_Alive)
                throw new NullReferenceException($"The object of type '{GetType().FullName}' has been destroyed but you are still trying to access it.");
        }

        /// <summary>Ends the native life: from here on the object equals null.</summary>
        internal void Kill()
        {
            if (!m_Alive)
                return;
            m_Alive = false;
            ObjectRegistry.Remove(this);
            OnNativeDestroy();
        }

        static bool Same(Object x, Object y)
        {
            if (x is null)
                return !IsAlive(y);
            if (y is null)
                return !IsAlive(x);
            return x.m_InstanceId == y.m_InstanceId;
        }
    }
}
