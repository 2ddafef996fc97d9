using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem
{
    /// <summary>What an .inputactions file holds: action maps and control schemes.</summary>
    public class InputActionAsset : ScriptableObject, IInputActionCollection2
    {
        public const string Extension = "inputactions";

        [SerializeField]
        internal InputActionMap[] m_ActionMaps = Array.Empty<InputActionMap>();

        [SerializeField]
        internal InputControlScheme[] m_ControlSchemes = Array.Empty<InputControlScheme>();

        InputBinding? m_BindingMask;
        InputDevice[] m_Devices;

        /// <summary>Whether any action is enabled.</summary>
        public bool enabled => Maps.Any(m => m.enabled);

        public ReadOnlyArray<InputActionMap> actionMaps => Maps;

        public ReadOnlyArray<InputControlScheme> controlSchemes => m_ControlSchemes;

        public IEnumerable<InputBinding> bindings => Maps.SelectMany(m => m.m_Bindings);

        public InputBinding? bindingMask
        {
            get => m_BindingMask;
            set
            {
                m_BindingMask = value;
                ForgetResolutions();
            }
        }

        /// <summary>The devices whose controls it uses; null = all.</summary>
        public ReadOnlyArray<InputDevice>? devices
        {
            // Null is to mean all; what converts an array makes an empty list of it, which means none.
            get => m_Devices == null ? default(ReadOnlyArray<InputDevice>?) : new ReadOnlyArray<InputDevice>(m_Devices);
            set
            {
                m_Devices = value?.ToArray();
                ForgetResolutions();
            }
        }

        /// <exception cref="KeyNotFoundException">There is none.</exception>
        public InputAction this[string actionNameOrId] =>
            FindAction(actionNameOrId) ?? throw new KeyNotFoundException($"Cannot find action '{actionNameOrId}' in '{this}'");

        /// <summary>The maps, which know the asset: a copy's know the copy.</summary>
        InputActionMap[] Maps
        {
            get
            {
                foreach (var map in m_ActionMaps)
                    map.m_Asset = this;
                return m_ActionMaps;
            }
        }

        /// <summary>An asset from the text of an .inputactions file.</summary>
        public static InputActionAsset FromJson(string json)
        {
            if (string.IsNullOrEmpty(json))
                throw new ArgumentNullException(nameof(json));
            var asset = CreateInstance<InputActionAsset>();
            asset.LoadFromJson(json);
            return asset;
        }

        public void LoadFromJson(string json)
        {
            if (string.IsNullOrEmpty(json))
                throw new ArgumentNullException(nameof(json));
            ActionsJson.Read(json, this);
        }

        public string ToJson() => ActionsJson.Write(name, Maps, m_ControlSchemes);

        /// <param name="actionNameOrId">"Map/Action", "Action" or an id.</param>
        /// <param name="throwIfNotFound">Else null is returned.</param>
        public InputAction FindAction(string actionNameOrId, bool throwIfNotFound = false)
        {
            if (actionNameOrId == null)
                throw new ArgumentNullException(nameof(actionNameOrId));
            var slash = actionNameOrId.IndexOf('/');
            if (slash == 0 || slash == actionNameOrId.Length - 1)
                throw new ArgumentException("Malformed action path: " + actionNameOrId, nameof(actionNameOrId));
            InputAction found;
            if (slash < 0)
            {
                var candidates = Maps.Select(m => m.FindAction(actionNameOrId)).Where(a => a != null).ToList();
                found = candidates.Find(a => a.enabled || a.m_Id == actionNameOrId) ?? candidates.FirstOrDefault();
            }
            else
            {
                found = FindActionMap(actionNameOrId.Substring(0, slash))?.FindAction(actionNameOrId.Substring(slash + 1));
            }

            if (found == null && throwIfNotFound)
                throw new ArgumentException($"No action '{actionNameOrId}' in '{this}'");
            return found;
        }

        public InputAction FindAction(Guid guid) => Maps.Select(m => m.FindAction(guid)).FirstOrDefault(a => a != null);

        public InputActionMap FindActionMap(string nameOrId, bool throwIfNotFound = false)
        {
            if (nameOrId == null)
                throw new ArgumentNullException(nameof(nameOrId));
            var found = Array.Find(Maps, m => m.m_Id == nameOrId) ?? Array.Find(Maps, m => string.Equals(m.name, nameOrId, StringComparison.OrdinalIgnoreCase));
            if (found == null && throwIfNotFound)
                throw new ArgumentException($"Cannot find action map '{nameOrId}' in '{this}'");
            return found;
        }

        public InputActionMap FindActionMap(Guid id) => Array.Find(Maps, m => m.id == id);

        public int FindBinding(InputBinding mask, out InputAction action)
        {
            foreach (var map in Maps)
            {
                var index = map.FindBinding(mask, out action);
                if (index >= 0)
                    return index;
            }

            action = null;
            return -1;
        }

        public InputControlScheme? FindControlScheme(string name)
        {
            var index = FindControlSchemeIndex(name);
            return index < 0 ? null : m_ControlSchemes[index];
        }

        public int FindControlSchemeIndex(string name)
        {
            if (string.IsNullOrEmpty(name))
                throw new ArgumentNullException(nameof(name));
            return Array.FindIndex(m_ControlSchemes, s => string.Equals(s.name, name, StringComparison.OrdinalIgnoreCase));
        }

        public bool Contains(InputAction action) => action?.actionMap != null && Array.IndexOf(Maps, action.actionMap) >= 0;

        public bool IsUsableWithDevice(InputDevice device) => Maps.Any(m => m.IsUsableWithDevice(device));

        public void Enable()
        {
            foreach (var map in Maps)
                map.Enable();
        }

        public void Disable()
        {
            foreach (var map in Maps)
                map.Disable();
        }

        public IEnumerator<InputAction> GetEnumerator() => Maps.SelectMany(m => m.m_Actions).GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

        internal void Add(InputActionMap map)
        {
            if (map.m_Asset != null && map.m_Asset != this)
                throw new InvalidOperationException($"Cannot add map '{map}' to asset '{this}' as it has already been added to asset '{map.m_Asset}'");
            m_ActionMaps = m_ActionMaps.Append(map).ToArray();
            map.m_Asset = this;
        }

        void OnDestroy() => Disable();

        void ForgetResolutions()
        {
            foreach (var map in Maps)
                map.ForgetResolution();
        }
    }
}
