using System;
using System.Collections.Generic;

namespace UnityEngine
{
    public sealed partial class GameObject
    {
        public int GetComponentCount()
        {
            Use("GetComponentCount");
            return m_Components.Count;
        }

        public Component GetComponentAtIndex(int index)
        {
            Use("GetComponentAtIndex");
            return m_Components[index];
        }

        public T GetComponentAtIndex<T>(int index) where T : Component => (T)GetComponentAtIndex(index);

        public int GetComponentIndex(Component component)
        {
            Use("GetComponentIndex");
            return m_Components.IndexOf(component);
        }

        /// <summary>The first component of that type; null, as in players, if there is none.</summary>
        public Component GetComponent(Type type)
        {
            Use("GetComponent");
            foreach (var c in m_Components)
                if (type.IsInstanceOfType(c))
                    return c;
            return null;
        }

        public T GetComponent<T>()
        {
            Use("GetComponent");
            foreach (var c in m_Components)
                if (c is T t)
                    return t;
            return default;
        }

        public bool TryGetComponent(Type type, out Component component)
        {
            component = GetComponent(type);
            return component is not null;
        }

        public bool TryGetComponent<T>(out T component)
        {
            component = GetComponent<T>();
            return component is not null;
        }

        public Component[] GetComponents(Type type)
        {
            Use("GetComponents");
            var results = new List<Component>();
            foreach (var c in m_Components)
                if (type.IsInstanceOfType(c))
                    results.Add(c);
            return ToTypedArray(type, results);
        }

        public void GetComponents(Type type, List<Component> results)
        {
            results.Clear();
            results.AddRange(GetComponents(type));
        }

        public T[] GetComponents<T>()
        {
            var results = new List<T>();
            GetComponents(results);
            return results.ToArray();
        }

        public void GetComponents<T>(List<T> results)
        {
            Use("GetComponents");
            results.Clear();
            Collect(this, results);
        }

        public Component GetComponentInChildren(Type type) => GetComponentInChildren(type, false);

        public Component GetComponentInChildren(Type type, bool includeInactive)
        {
            Use("GetComponentInChildren");
            foreach (var g in m_Transform.Subtree(includeInactive))
                if (g.GetComponent(type) is { } found)
                    return found;
            return null;
        }

        public T GetComponentInChildren<T>() => GetComponentInChildren<T>(false);

        public T GetComponentInChildren<T>(bool includeInactive)
        {
            Use("GetComponentInChildren");
            foreach (var g in m_Transform.Subtree(includeInactive))
                if (g.GetComponent<T>() is { } found)
                    return found;
            return default;
        }

        public Component[] GetComponentsInChildren(Type type) => GetComponentsInChildren(type, false);

        public Component[] GetComponentsInChildren(Type type, bool includeInactive)
        {
            Use("GetComponentsInChildren");
            var results = new List<Component>();
            foreach (var g in m_Transform.Subtree(includeInactive))
                results.AddRange(g.GetComponents(type));
            return ToTypedArray(type, results);
        }

        public T[] GetComponentsInChildren<T>() => GetComponentsInChildren<T>(false);

        public T[] GetComponentsInChildren<T>(bool includeInactive)
        {
            var results = new List<T>();
            GetComponentsInChildren(includeInactive, results);
            return results.ToArray();
        }

        public void GetComponentsInChildren<T>(List<T> results) => GetComponentsInChildren(false, results);

        public void GetComponentsInChildren<T>(bool includeInactive, List<T> results)
        {
            Use("GetComponentsInChildren");
            results.Clear();
            foreach (var g in m_Transform.Subtree(includeInactive))
                Collect(g, results);
        }

        public Component GetComponentInParent(Type type) => GetComponentInParent(type, false);

        public Component GetComponentInParent(Type type, bool includeInactive)
        {
            Use("GetComponentInParent");
            foreach (var g in m_Transform.Ancestry(includeInactive))
                if (g.GetComponent(type) is { } found)
                    return found;
            return null;
        }

        public T GetComponentInParent<T>() => GetComponentInParent<T>(false);

        public T GetComponentInParent<T>(bool includeInactive)
        {
            Use("GetComponentInParent");
            foreach (var g in m_Transform.Ancestry(includeInactive))
                if (g.GetComponent<T>() is { } found)
                    return found;
            return default;
        }

        public T[] GetComponentsInParent<T>() => GetComponentsInParent<T>(false);

        public T[] GetComponentsInParent<T>(bool includeInactive)
        {
            Use("GetComponentsInParent");
            var results = new List<T>();
            foreach (var g in m_Transform.Ancestry(includeInactive))
                Collect(g, results);
            return results.ToArray();
        }

        static void Collect<T>(GameObject from, List<T> results)
        {
            foreach (var c in from.m_Components)
                if (c is T t)
                    results.Add(t);
        }

        static Component[] ToTypedArray(Type type, List<Component> results)
        {
            var array = (Component[])Array.CreateInstance(typeof(Component).IsAssignableFrom(type) ? type : typeof(Component), results.Count);
            results.CopyTo(array);
            return array;
        }
    }
}
