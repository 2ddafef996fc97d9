using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>Brings objects to life and to rest: Awake, OnEnable, OnDisable over a hierarchy.</summary>
    static class Activation
    {
        /// <summary>Follows a change of an object's switch or of its parent.</summary>
        internal static void Refresh(GameObject root)
        {
            var parent = root.OwnTransform.ParentOrNull;
            var active = root.ActiveSelfFlag && (parent is null || parent.Owner.IsActive);
            if (active == root.IsActive)
                return;
            var changed = new List<GameObject>();
            SetFlags(root, active, changed);
            if (active)
                Activate(changed);
            else
                Deactivate(changed);
        }

        /// <summary>Wakes a scene that was just loaded: everything is switched on before the first script hears of it.</summary>
        internal static void Begin(List<GameObject> roots)
        {
            var changed = new List<GameObject>();
            foreach (var root in roots.Where(r => r.ActiveSelfFlag))
                SetFlags(root, true, changed);
            Activate(changed);
        }

        /// <summary>Awake and OnEnable back to back per component, by execution order, then in hierarchy order.</summary>
        internal static void Activate(List<GameObject> objects)
        {
            foreach (var behaviour in Behaviours(objects).OrderBy(b => b.ExecutionOrder).ToList())
                behaviour.ActivateIfNeeded();
        }

        static void Deactivate(List<GameObject> objects)
        {
            foreach (var behaviour in Behaviours(objects))
            {
                behaviour.DeactivateIfNeeded();
                if (behaviour is MonoBehaviour script)
                    Coroutines.StopAll(script);
            }
        }

        static List<Behaviour> Behaviours(List<GameObject> objects) => objects.SelectMany(g => g.Components).OfType<Behaviour>().ToList();

        static void SetFlags(GameObject root, bool active, List<GameObject> changed)
        {
            if (root.IsActive == active)
                return;
            root.SetActiveInHierarchy(active);
            changed.Add(root);
            foreach (var child in root.OwnTransform.Children)
                if (child.Owner.ActiveSelfFlag)
                    SetFlags(child.Owner, active, changed);
        }
    }
}
