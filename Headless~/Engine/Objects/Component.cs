using System;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>A part of a GameObject. Only AddComponent makes living ones.</summary>
    public partial class Component : Object
    {
        readonly GameObject m_GameObject;

        public Component()
        {
            m_GameObject = ComponentFactory.TakeOwner(this);
            if (m_GameObject is not null)
                return;
            Debug.LogWarning($"You are trying to create a MonoBehaviour using the 'new' keyword.  This is not allowed.  MonoBehaviours can only be added "
                + "using AddComponent(). " +
                $"Alternatively, your script can inherit from ScriptableObject or no base class at all ({GetType().FullName})");
            Kill();
        }

        public GameObject gameObject
        {
            get { Use("get_gameObject"); return m_GameObject; }
        }

        public Transform transform
        {
            get { Use("get_transform"); return m_GameObject.OwnTransform; }
        }

        public string tag
        {
            get => gameObject.tag;
            set => gameObject.tag = value;
        }

        internal override string NativeName
        {
            get => m_GameObject is null ? "" : m_GameObject.NameForMessages;
            set { if (m_GameObject is not null) m_GameObject.name = value; }
        }

        /// <summary>The GameObject, also of a destroyed component.</summary>
        internal GameObject Owner => m_GameObject;

        public bool CompareTag(string tag) => gameObject.CompareTag(tag);

        public int GetComponentIndex() => gameObject.GetComponentIndex(this);

        public Component GetComponent(Type type) => gameObject.GetComponent(type);

        public T GetComponent<T>() => gameObject.GetComponent<T>();

        public bool TryGetComponent(Type type, out Component component) => gameObject.TryGetComponent(type, out component);

        public bool TryGetComponent<T>(out T component) => gameObject.TryGetComponent(out component);

        public Component[] GetComponents(Type type) => gameObject.GetComponents(type);

        public void GetComponents(Type type, List<Component> results) => gameObject.GetComponents(type, results);

        public T[] GetComponents<T>() => gameObject.GetComponents<T>();

        public void GetComponents<T>(List<T> results) => gameObject.GetComponents(results);

        public Component GetComponentInChildren(Type t) => gameObject.GetComponentInChildren(t);

        public Component GetComponentInChildren(Type t, bool includeInactive) => gameObject.GetComponentInChildren(t, includeInactive);

        public T GetComponentInChildren<T>() => gameObject.GetComponentInChildren<T>();

        public T GetComponentInChildren<T>(bool includeInactive) => gameObject.GetComponentInChildren<T>(includeInactive);

        public Component GetComponentInParent(Type t) => gameObject.GetComponentInParent(t);

        public Component GetComponentInParent(Type t, bool includeInactive) => gameObject.GetComponentInParent(t, includeInactive);

        public T GetComponentInParent<T>() => gameObject.GetComponentInParent<T>();

        public T GetComponentInParent<T>(bool includeInactive) => gameObject.GetComponentInParent<T>(includeInactive);

        public Component[] GetComponentsInChildren(Type t) => gameObject.GetComponentsInChildren(t);

        public Component[] GetComponentsInChildren(Type t, bool includeInactive) => gameObject.GetComponentsInChildren(t, includeInactive);

        public T[] GetComponentsInChildren<T>() => gameObject.GetComponentsInChildren<T>();

        public T[] GetComponentsInChildren<T>(bool includeInactive) => gameObject.GetComponentsInChildren<T>(includeInactive);

        public void GetComponentsInChildren<T>(List<T> results) => gameObject.GetComponentsInChildren(results);

        public void GetComponentsInChildren<T>(bool includeInactive, List<T> result) => gameObject.GetComponentsInChildren(includeInactive, result);

        public T[] GetComponentsInParent<T>() => gameObject.GetComponentsInParent<T>();

        public T[] GetComponentsInParent<T>(bool includeInactive) => gameObject.GetComponentsInParent<T>(includeInactive);

        /// <summary>Copies what the engine itself keeps of a component (not script fields) in Instantiate.</summary>
        internal virtual void CopyNativeState(Component source, Func<Object, Object> remap)
        {
        }
    }
}
