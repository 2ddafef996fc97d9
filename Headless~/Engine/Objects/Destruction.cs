using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>How objects end: now, or after this frame's updates.</summary>
    static class Destruction
    {
        static readonly List<(Object Target, double Due)> s_Scheduled = new();

        internal static void Schedule(Object obj, float delay) => s_Scheduled.Add((obj, Time.timeAsDouble + delay));

        /// <summary>Destroys what is due; called once per frame between LateUpdate and rendering.</summary>
        /// <returns>Whether anything was.</returns>
        internal static bool RunScheduled()
        {
            var due = s_Scheduled.FindAll(s => s.Due <= Time.timeAsDouble);
            s_Scheduled.RemoveAll(s => s.Due <= Time.timeAsDouble);
            foreach (var (target, _) in due)
                if (Object.IsAlive(target))
                    Now(target);
            return due.Count > 0;
        }

        internal static void Forget() => s_Scheduled.Clear();

        /// <summary>False, with Unity's error in the log, for what may not be destroyed.</summary>
        internal static bool IsAllowed(Object obj, bool allowDestroyingAssets)
        {
            if (obj.IsAsset && !allowDestroyingAssets)
            {
                Debug.LogError("Destroying assets is not permitted to avoid data loss.\nIf you really want to remove an asset use DestroyImmediate "
                    + "(theObject, true);");
                return false;
            }

            if (obj is Transform)
            {
                Debug.LogError($"Can't destroy Transform component of '{obj.NameForMessages}'. If you want to destroy the game object, please call "
                    + "'Destroy' on the game object instead. " +
                    "Destroying the transform component is not allowed.");
                return false;
            }

            if (obj is Component component && ComponentFactory.Dependent(component) is { } dependent)
            {
                Debug.LogError($"Can't remove {component.GetType().Name} because {dependent.GetType().Name} (Script) depends on it");
                return false;
            }

            return true;
        }

        internal static void Now(Object obj)
        {
            switch (obj)
            {
                case GameObject g:
                    DestroyHierarchy(g);
                    break;
                case Component c:
                    Rest(c);
                    End(c);
                    c.Owner.Detach(c);
                    break;
                case ScriptableObject s:
                    s.SendDestroy();
                    s.Kill();
                    break;
                default:
                    obj.Kill();
                    break;
            }
        }

        /// <summary>First OnDisable for all, then OnDestroy for all, then nothing is left.</summary>
        static void DestroyHierarchy(GameObject root)
        {
            foreach (var component in Components(root))
                Rest(component);
            // OnDisable may have changed the hierarchy.
            var all = root.OwnTransform.Subtree(true).ToList();
            foreach (var component in Components(root))
                if (component is not Transform)
                    End(component);
            root.OwnTransform.Unhook();
            foreach (var g in all)
            {
                g.OwnTransform.Kill();
                g.SetActiveInHierarchy(false);
                g.Kill();
            }
        }

        static List<Component> Components(GameObject root) => root.OwnTransform.Subtree(true).SelectMany(g => g.Components).ToList();

        static void Rest(Component component)
        {
            if (!Object.IsAlive(component))
                return;
            (component as Behaviour)?.DeactivateIfNeeded();
            if (component is MonoBehaviour script)
                Coroutines.StopAll(script);
        }

        static void End(Component component)
        {
            if (!Object.IsAlive(component))
                return;
            (component as MonoBehaviour)?.SendOnDestroy();
            component.Kill();
        }
    }
}
