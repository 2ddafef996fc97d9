using System;

namespace UnityEngine.InputSystem
{
    /// <summary>An action of an asset, as something that fields can refer to.</summary>
    public class InputActionReference : ScriptableObject
    {
        [SerializeField]
        internal InputActionAsset m_Asset;

        [SerializeField]
        internal string m_ActionId;

        [NonSerialized]
        InputAction m_Action;

        public InputActionAsset asset => m_Asset;

        /// <summary>Null if the asset does not have it any more.</summary>
        public InputAction action
        {
            get
            {
                if (m_Action == null && m_Asset != null)
                    m_Action = m_Asset.FindAction(new Guid(m_ActionId));
                return m_Action;
            }
        }

        public static implicit operator InputAction(InputActionReference reference) => reference?.action;

        public static InputActionReference Create(InputAction action)
        {
            if (action == null)
                return null;
            var reference = CreateInstance<InputActionReference>();
            reference.Set(action);
            return reference;
        }

        /// <exception cref="InvalidOperationException">The action is in no asset.</exception>
        public void Set(InputAction action)
        {
            m_Action = null;
            if (action == null)
            {
                m_Asset = null;
                m_ActionId = null;
                return;
            }

            if (action.actionMap?.asset == null)
                throw new InvalidOperationException(
                    $"Action '{action}' must be part of an InputActionAsset in order to be able to create an InputActionReference for it");
            m_Asset = action.actionMap.asset;
            m_ActionId = action.id.ToString();
            name = DisplayName(action);
        }

        /// <exception cref="ArgumentException">There is no such map or action.</exception>
        public void Set(InputActionAsset asset, string mapName, string actionName)
        {
            if (asset == null)
                throw new ArgumentNullException(nameof(asset));
            if (string.IsNullOrEmpty(mapName))
                throw new ArgumentNullException(nameof(mapName));
            if (string.IsNullOrEmpty(actionName))
                throw new ArgumentNullException(nameof(actionName));
            var map = asset.FindActionMap(mapName) ?? throw new ArgumentException($"No action map '{mapName}' in '{asset}'", nameof(mapName));
            Set(map.FindAction(actionName)
                ?? throw new ArgumentException($"No action '{actionName}' in map '{mapName}' of asset '{asset}'", nameof(actionName)));
        }

        public InputAction ToInputAction() => action;

        public override string ToString() => action == null ? base.ToString() : $"{m_Asset.name}:{DisplayName(action)}";

        internal static string DisplayName(InputAction action) =>
            string.IsNullOrEmpty(action.actionMap?.name) ? action.name : $"{action.actionMap.name}/{action.name}";
    }

    /// <summary>An action as a field: one of its own, or a reference to one of an asset.</summary>
    [Serializable]
    public struct InputActionProperty : IEquatable<InputActionProperty>, IEquatable<InputAction>, IEquatable<InputActionReference>
    {
        [SerializeField]
        bool m_UseReference;

        [SerializeField]
        InputAction m_Action;

        [SerializeField]
        InputActionReference m_Reference;

        public InputActionProperty(InputAction action)
        {
            m_UseReference = false;
            m_Action = action;
            m_Reference = null;
        }

        public InputActionProperty(InputActionReference reference)
        {
            m_UseReference = true;
            m_Action = null;
            m_Reference = reference;
        }

        public InputAction action => m_UseReference ? m_Reference != null ? m_Reference.action : null : m_Action;

        public InputActionReference reference => m_UseReference ? m_Reference : null;

        public static bool operator ==(InputActionProperty left, InputActionProperty right) => left.Equals(right);

        public static bool operator !=(InputActionProperty left, InputActionProperty right) => !left.Equals(right);

        public bool Equals(InputActionProperty other) =>
            m_Reference == other.m_Reference && m_UseReference == other.m_UseReference && m_Action == other.m_Action;

        public bool Equals(InputAction other) => ReferenceEquals(action, other);

        public bool Equals(InputActionReference other) => m_Reference == other;

        public override bool Equals(object obj) => m_UseReference
            ? obj is InputActionProperty property ? Equals(property) : obj is InputActionReference reference && Equals(reference)
            : obj is InputActionProperty own ? Equals(own) : obj is InputAction action && Equals(action);

        public override int GetHashCode() => m_UseReference ? m_Reference != null ? m_Reference.GetHashCode() : 0 : m_Action?.GetHashCode() ?? 0;
    }
}
