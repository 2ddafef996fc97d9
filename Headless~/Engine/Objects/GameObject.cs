using System;
using System.Collections.Generic;
using UnityEngine.SceneManagement;

namespace UnityEngine
{
    /// <summary>A thing in the scene: a transform and other components.</summary>
    public sealed partial class GameObject : Object
    {
        readonly List<Component> m_Components = new();
        Transform m_Transform;
        string m_Tag = "Untagged";
        int m_Layer;
        bool m_ActiveSelf = true;
        bool m_ActiveInHierarchy = true;

        public GameObject() : this("New Game Object")
        {
        }

        public GameObject(string name) : this(name, typeof(Transform)) => m_Transform.MoveTo(LoadedScenes.Active);

        public GameObject(string name, params Type[] components) : this(name)
        {
            foreach (var type in components ?? Array.Empty<Type>())
                AddComponent(type);
        }

        GameObject(string name, Type transform)
        {
            MainThread.Check("Internal_CreateGameObject");
            NativeName = name ?? "";
            m_Transform = (Transform)ComponentFactory.Construct(transform, this);
        }

        public GameObject gameObject => this;

        public Transform transform
        {
            get { Use("get_transform"); return m_Transform; }
        }

        public int layer
        {
            get { Use("get_layer"); return m_Layer; }
            set
            {
                Use("set_layer");
                if (value is < 0 or > 31)
                {
                    Debug.LogError("A game object can only be in one layer. The layer needs to be in the range [0...31]");
                    return;
                }

                m_Layer = value;
            }
        }

        public string tag
        {
            get { Use("get_tag"); return m_Tag; }
            set { Use("set_tag"); m_Tag = Tags.Checked(value); }
        }

        /// <summary>The object's own switch.</summary>
        public bool activeSelf
        {
            get { Use("get_activeSelf"); return m_ActiveSelf; }
        }

        /// <summary>True if the object's switch and those of all above it are on.</summary>
        public bool activeInHierarchy
        {
            get { Use("get_activeInHierarchy"); return m_ActiveInHierarchy; }
        }

        public bool isStatic { get; set; }

        /// <summary>The scene that it lives in; an invalid one for a prefab.</summary>
        public Scene scene
        {
            get { Use("get_scene"); return new Scene(m_Transform.Scene); }
        }

        internal Transform OwnTransform => m_Transform;

        internal IReadOnlyList<Component> Components => m_Components;

        internal bool IsActive => m_ActiveInHierarchy;

        internal bool ActiveSelfFlag => m_ActiveSelf;

        public bool CompareTag(string tag)
        {
            Use("CompareTag");
            return m_Tag == Tags.Checked(tag);
        }

        /// <summary>Switches the object; callbacks of it and its children have run on return.</summary>
        public void SetActive(bool value)
        {
            Use("SetActive");
            if (m_ActiveSelf == value)
                return;
            m_ActiveSelf = value;
            Activation.Refresh(this);
        }

        public Component AddComponent(Type componentType)
        {
            Use("AddComponent");
            return ComponentFactory.Add(this, componentType);
        }

        public T AddComponent<T>() where T : Component => (T)AddComponent(typeof(T));

        /// <summary>The first active object of that name; a name with slashes is a path from a root (leading slash) or from anywhere.</summary>
        public static GameObject Find(string name)
        {
            MainThread.Check("Find");
            if (string.IsNullOrEmpty(name))
                return null;
            var path = name.TrimStart('/');
            foreach (var o in ObjectRegistry.Snapshot())
            {
                if (o is not GameObject { m_ActiveInHierarchy: true } candidate || candidate.IsAsset)
                    continue;
                var full = candidate.m_Transform.PathFromRoot();
                if (name[0] == '/' ? full == path : full == path || full.EndsWith("/" + path, StringComparison.Ordinal))
                    return candidate;
            }

            return null;
        }

        /// <exception cref="UnityException">The tag is not defined.</exception>
        public static GameObject FindWithTag(string tag)
        {
            var all = FindGameObjectsWithTag(tag);
            return all.Length > 0 ? all[0] : null;
        }

        public static GameObject FindGameObjectWithTag(string tag) => FindWithTag(tag);

        public static GameObject[] FindGameObjectsWithTag(string tag)
        {
            MainThread.Check("FindGameObjectsWithTag");
            tag = Tags.Checked(tag);
            return ObjectRegistry.Snapshot().FindAll(o => o is GameObject g && g.m_ActiveInHierarchy && !g.IsAsset && g.m_Tag == tag)
                .ConvertAll(o => (GameObject)o).ToArray();
        }

        /// <summary>Makes an object that is in no scene, asleep: what a file holds.</summary>
        internal static GameObject Construct(string name, Type transform) => new(name, transform) { m_ActiveInHierarchy = false };

        /// <summary>Turns the Transform into a RectTransform, as adding one does.</summary>
        internal RectTransform MakeRectTransform()
        {
            var old = m_Transform;
            var rect = (RectTransform)ComponentFactory.Construct(typeof(RectTransform), this);
            rect.Replace(old);
            m_Components.Remove(rect);
            m_Components[m_Components.IndexOf(old)] = rect;
            m_Transform = rect;
            old.Kill();
            return rect;
        }

        internal void Attach(Component component) => m_Components.Add(component);

        internal void Detach(Component component) => m_Components.Remove(component);

        internal void SetActiveSelfSilently(bool value)
        {
            m_ActiveSelf = value;
            m_ActiveInHierarchy = value;
        }

        /// <summary>Sets the switch of an object that hangs below an inactive one, where it changes nothing yet.</summary>
        internal void SetSelfFlag(bool value) => m_ActiveSelf = value;

        internal void SetActiveInHierarchy(bool value) => m_ActiveInHierarchy = value;
    }
}
