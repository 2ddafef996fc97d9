using System.Collections;
using System.Collections.Generic;
using UnityEngine.SceneManagement;

namespace UnityEngine
{
    /// <summary>Position, rotation and scale, relative to a parent.</summary>
    public partial class Transform : Component, IEnumerable
    {
        readonly List<Transform> m_Children = new();
        Transform m_Parent;
        SceneData m_Scene;

        protected Transform()
        {
        }

        public Transform parent
        {
            get { Use("get_parent"); return m_Parent; }
            set => SetParent(value, true);
        }

        public Transform root
        {
            get
            {
                Use("get_root");
                var t = this;
                while (t.m_Parent is not null)
                    t = t.m_Parent;
                return t;
            }
        }

        public int childCount
        {
            get { Use("get_childCount"); return m_Children.Count; }
        }

        /// <summary>True after any change of this transform or of one above it, until it is set to false.</summary>
        public bool hasChanged { get; set; } = true;

        internal Transform ParentOrNull => m_Parent;

        internal List<Transform> Children => m_Children;

        public void SetParent(Transform p) => SetParent(p, true);

        /// <summary>Hangs the object below another, as its last child; null makes it a root.</summary>
        public void SetParent(Transform parent, bool worldPositionStays)
        {
            Use("SetParent");
            var target = IsAlive(parent) ? parent : null;
            if (ReferenceEquals(target, m_Parent))
                return;
            if (target is not null && target.IsChildOf(this))
            {
                Debug.LogError("Cannot set the parent of the GameObject to one of its children or itself.");
                return;
            }

            var world = worldPositionStays ? WorldPose() : default;
            var scene = Scene;
            Unhook();
            m_Parent = target;
            m_Scene = target is null ? scene : null;
            Siblings.Add(this);
            if (worldPositionStays)
                SetWorldPose(world);
            MarkChanged();
            Activation.Refresh(Owner);
            NotifyHierarchy();
        }

        public Transform GetChild(int index)
        {
            Use("GetChild");
            if (index < 0 || index >= m_Children.Count)
                throw new UnityException("Transform child out of bounds");
            return m_Children[index];
        }

        /// <summary>The child of that name, or the descendant of that path (slashes); null if there is none.</summary>
        public Transform Find(string n)
        {
            Use("Find");
            if (n == null)
                throw new System.ArgumentNullException(nameof(n), "Name cannot be null");
            var current = this;
            foreach (var part in n.Split('/'))
            {
                current = part == ".." ? current.m_Parent : current.m_Children.Find(c => c.NameForMessages == part);
                if (current is null)
                    return null;
            }

            return current;
        }

        /// <summary>True for the transform itself too.</summary>
        public bool IsChildOf(Transform parent)
        {
            Use("IsChildOf");
            for (var t = this; t is not null; t = t.m_Parent)
                if (ReferenceEquals(t, parent))
                    return true;
            return false;
        }

        public void DetachChildren()
        {
            Use("DetachChildren");
            while (m_Children.Count > 0)
                m_Children[0].SetParent(null, true);
        }

        public int GetSiblingIndex()
        {
            Use("GetSiblingIndex");
            return Siblings.FindIndex(t => ReferenceEquals(t, this));
        }

        public void SetSiblingIndex(int index)
        {
            Use("SetSiblingIndex");
            var siblings = Siblings;
            siblings.RemoveAt(GetSiblingIndex());
            siblings.Insert(Mathf.Clamp(index, 0, siblings.Count), this);
        }

        public void SetAsFirstSibling() => SetSiblingIndex(0);

        public void SetAsLastSibling() => SetSiblingIndex(int.MaxValue);

        /// <summary>Walks the children by index, so reparenting on the way skips some, as in Unity.</summary>
        public IEnumerator GetEnumerator()
        {
            for (var i = 0; i < m_Children.Count; i++)
                yield return m_Children[i];
        }

        internal string PathFromRoot() => m_Parent is null ? NameForMessages : m_Parent.PathFromRoot() + "/" + NameForMessages;

        /// <summary>This object and those below, in hierarchy order.</summary>
        internal IEnumerable<GameObject> Subtree(bool includeInactive)
        {
            if (!includeInactive && !Owner.IsActive)
                yield break;
            yield return Owner;
            foreach (var child in m_Children)
                foreach (var g in child.Subtree(includeInactive))
                    yield return g;
        }

        /// <summary>This object and those above.</summary>
        internal IEnumerable<GameObject> Ancestry(bool includeInactive)
        {
            for (var t = this; t is not null; t = t.m_Parent)
                if (includeInactive || t.Owner.IsActive)
                    yield return t.Owner;
        }

        /// <summary>The scene of the hierarchy; null for a prefab.</summary>
        internal SceneData Scene
        {
            get
            {
                var t = this;
                while (t.m_Parent is not null)
                    t = t.m_Parent;
                return t.m_Scene;
            }
        }

        /// <summary>Leaves parent or scene, for reparenting and destruction.</summary>
        internal void Unhook() => Siblings.RemoveAll(t => ReferenceEquals(t, this));

        /// <summary>Moves a root into a scene, as its last root.</summary>
        internal void MoveTo(SceneData scene)
        {
            Unhook();
            m_Scene = scene;
            scene.Roots.Add(this);
        }

        /// <summary>Makes a transform that has neither parent nor scene another's last child; nobody is told.</summary>
        internal void HangBelow(Transform parent)
        {
            m_Parent = parent;
            parent.m_Children.Add(this);
        }

        /// <summary>Takes the place of another transform of the same object: pose, parent, children.</summary>
        internal void Replace(Transform old)
        {
            CopyNativeState(old, o => o);
            (m_Parent, m_Scene) = (old.m_Parent, old.m_Scene);
            var siblings = old.Siblings;
            siblings[siblings.FindIndex(t => ReferenceEquals(t, old))] = this;
            foreach (var child in old.m_Children)
                child.m_Parent = this;
            m_Children.AddRange(old.m_Children);
        }

        /// <summary>A prefab's root has none.</summary>
        List<Transform> Siblings => m_Parent is not null ? m_Parent.m_Children : m_Scene is not null ? m_Scene.Roots : new List<Transform>();

        void NotifyHierarchy()
        {
            foreach (var script in Owner.GetComponentsInChildren<MonoBehaviour>())
                script.Messages.OnTransformParentChanged.Send(script);
            if (m_Parent is not null)
                foreach (var script in m_Parent.Owner.GetComponents<MonoBehaviour>())
                    script.Messages.OnTransformChildrenChanged.Send(script);
        }
    }
}
