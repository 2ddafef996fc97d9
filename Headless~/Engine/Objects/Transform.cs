using System.Collections;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>Position, rotation and scale, relative to a parent.</summary>
    public partial class Transform : Component, IEnumerable
    {
        readonly List<Transform> m_Children = new();
        Transform m_Parent;

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
            Unhook();
            m_Parent = target;
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

        /// <summary>Leaves parent or scene, for reparenting and destruction.</summary>
        internal void Unhook() => Siblings.RemoveAll(t => ReferenceEquals(t, this));

        List<Transform> Siblings => m_Parent is null ? SceneRoots.Transforms : m_Parent.m_Children;

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
