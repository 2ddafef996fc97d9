using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.InputSystem;

namespace AnatomyCarve.Desktop
{
    /// <summary>
    /// What the components of this folder share: their default controls, and which of them use an action map at the moment. One asset of this type
    /// lies in a Resources folder of the package, so that a component that was added at run time needs no wiring.
    /// </summary>
    public sealed class AnatomyCarveDesktop : ScriptableObject
    {
        const string ResourceName = "AnatomyCarveDesktop";

        [SerializeField, Tooltip("The controls of components that were given none")]
        InputActionAsset controls = null;

        [NonSerialized]
        readonly Dictionary<InputActionMap, MapUse> inUse = new Dictionary<InputActionMap, MapUse>();

        /// <summary>The controls of components that were given none.</summary>
        public InputActionAsset Controls => controls;

        /// <summary>Loads the package's asset.</summary>
        /// <returns>The asset; null where it is not part of the build.</returns>
        public static AnatomyCarveDesktop Load() => Resources.Load<AnatomyCarveDesktop>(ResourceName);

        /// <summary>Enables a map for one more user.</summary>
        internal void Enable(InputActionMap map)
        {
            if (!inUse.TryGetValue(map, out MapUse use))
                use.WasEnabled = map.enabled;
            use.Users++;
            inUse[map] = use;
            map.Enable();
        }

        /// <summary>Lets a map go. Its last user disables it, unless somebody else had enabled it before the first one came.</summary>
        internal void Release(InputActionMap map)
        {
            if (!inUse.TryGetValue(map, out MapUse use))
                return;
            use.Users--;
            if (use.Users > 0)
            {
                inUse[map] = use;
                return;
            }
            inUse.Remove(map);
            if (!use.WasEnabled)
                map.Disable();
        }

        struct MapUse
        {
            public int Users;
            public bool WasEnabled;
        }
    }
}
