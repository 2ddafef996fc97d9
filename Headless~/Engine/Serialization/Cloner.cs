using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>Instantiate: copies hierarchies, scripts and assets.</summary>
    static class Cloner
    {
        internal static Object Clone(Object original, Transform parent, bool worldPositionStays)
        {
            var (copy, root) = Copy(original);
            if (root is not null)
                Place(root, IsActive(original), parent, worldPositionStays, null);
            return copy;
        }

        internal static Object Clone(Object original, Transform parent, Vector3 position, Quaternion rotation)
        {
            var (copy, root) = Copy(original);
            if (root is not null)
                Place(root, IsActive(original), parent, false, t => t.SetPositionAndRotation(position, rotation));
            return copy;
        }

        static (Object Copy, GameObject Root) Copy(Object original)
        {
            MainThread.Check("Instantiate");
            if (!Object.IsAlive(original))
                throw new ArgumentException("The Object you want to instantiate is null.");
            switch (original)
            {
                case GameObject g:
                    return CopyHierarchy(g, g);
                case Component c:
                    return CopyHierarchy(c.Owner, c);
                case ScriptableObject s:
                    var copy = ScriptableObject.Construct(s.GetType());
                    new FieldCopier(o => o).Copy(s, copy);
                    Rename(copy, s);
                    copy.SendAwake();
                    return (copy, null);
                default:
                    var native =
                        original.CloneNative() ?? throw new NotSupportedException($"Instantiate of a {original.GetType().Name} is not implemented headless");
                    Rename(native, original);
                    return (native, null);
            }
        }

        static void Rename(Object copy, Object original)
        {
            copy.NativeName = original.NameForMessages + "(Clone)";
            copy.hideFlags = original.hideFlags;
        }

        /// <summary>Structure first, then fields, so that references inside find their copies; nobody is awake yet.</summary>
        static (Object Copy, GameObject Root) CopyHierarchy(GameObject original, Object wanted)
        {
            var map = new Dictionary<Object, Object>();
            var root = CopyStructure(original, null, map);
            root.NativeName = original.NameForMessages + "(Clone)";
            Object Remap(Object o) => map.TryGetValue(o, out var copy) ? copy : o;
            foreach (var (from, to) in map.Select(p => (p.Key, p.Value)))
            {
                if (from is not Component source)
                    continue;
                ((Component)to).CopyNativeState(source, Remap);
                if (source is Behaviour behaviour)
                    ((Behaviour)to).EnabledFlag = behaviour.EnabledFlag;
                if (source is MonoBehaviour)
                    new FieldCopier(Remap).Copy(source, to);
            }

            return (map[wanted], root);
        }

        static GameObject CopyStructure(GameObject original, Transform parent, Dictionary<Object, Object> map)
        {
            var copy = original.OwnTransform is RectTransform
                ? new GameObject(original.NameForMessages, typeof(RectTransform))
                : new GameObject(original.NameForMessages);
            (copy.layer, copy.tag, copy.hideFlags, copy.isStatic) = (original.layer, original.tag, original.hideFlags, original.isStatic);
            // Nobody wakes up before the whole copy is in place.
            copy.SetActiveSelfSilently(false);
            map.Add(original, copy);
            map.Add(original.OwnTransform, copy.OwnTransform);
            if (parent is not null)
                copy.OwnTransform.SetParent(parent, false);
            foreach (var component in original.Components)
                if (component is not Transform)
                    map.Add(component, ComponentFactory.Construct(component.GetType(), copy));
            foreach (var child in original.OwnTransform.Children)
                CopyStructure(child.Owner, copy.OwnTransform, map).SetSelfFlag(child.Owner.ActiveSelfFlag);
            return copy;
        }

        static bool IsActive(Object original) => (original as GameObject ?? ((Component)original).Owner).ActiveSelfFlag;

        /// <summary>Hangs the finished copy into the scene and switches it as its original is: Awake and OnEnable have run on return.</summary>
        static void Place(GameObject root, bool active, Transform parent, bool worldPositionStays, Action<Transform> pose)
        {
            if (Object.IsAlive(parent))
                root.OwnTransform.SetParent(parent, worldPositionStays);
            pose?.Invoke(root.OwnTransform);
            Validation.SendToAll(new[] { root });
            root.SetActive(active);
        }
    }
}
