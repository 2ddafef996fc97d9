using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem
{
    /// <summary>A named set of devices, and the group of bindings that goes with it.</summary>
    [Serializable]
    public struct InputControlScheme : IEquatable<InputControlScheme>
    {
        [SerializeField]
        string m_Name;

        [SerializeField]
        string m_BindingGroup;

        [SerializeField]
        DeviceRequirement[] m_DeviceRequirements;

        /// <exception cref="ArgumentNullException">There is no name.</exception>
        public InputControlScheme(string name, IEnumerable<DeviceRequirement> devices = null, string bindingGroup = null) : this()
        {
            m_Name = string.IsNullOrEmpty(name) ? throw new ArgumentNullException(nameof(name)) : name;
            m_BindingGroup = string.IsNullOrEmpty(bindingGroup) ? name : bindingGroup;
            m_DeviceRequirements = devices?.ToArray();
        }

        public string name => m_Name;

        public string bindingGroup { get => m_BindingGroup; set => m_BindingGroup = value; }

        public ReadOnlyArray<DeviceRequirement> deviceRequirements => m_DeviceRequirements;

        public bool Equals(InputControlScheme other) =>
            string.Equals(m_Name, other.m_Name, StringComparison.OrdinalIgnoreCase)
                && string.Equals(m_BindingGroup, other.m_BindingGroup, StringComparison.OrdinalIgnoreCase)
                && (m_DeviceRequirements ?? Array.Empty<DeviceRequirement>()).SequenceEqual(other.m_DeviceRequirements ?? Array.Empty<DeviceRequirement>());

        public override bool Equals(object obj) => obj is InputControlScheme other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(m_Name, m_BindingGroup);

        public override string ToString() => $"{m_Name}({string.Join(",", m_DeviceRequirements ?? Array.Empty<DeviceRequirement>())})";

        /// <summary>A device that a scheme asks for.</summary>
        [Serializable]
        public struct DeviceRequirement : IEquatable<DeviceRequirement>
        {
            [SerializeField]
            string m_ControlPath;

            [SerializeField]
            bool m_IsOptional;

            [SerializeField]
            bool m_IsOr;

            public string controlPath { get => m_ControlPath; set => m_ControlPath = value; }

            public bool isOptional { get => m_IsOptional; set => m_IsOptional = value; }

            public bool isOR { get => m_IsOr; set => m_IsOr = value; }

            public bool isAND { get => !isOR; set => isOR = !value; }

            public bool Equals(DeviceRequirement other) =>
                m_ControlPath == other.m_ControlPath && m_IsOptional == other.m_IsOptional && m_IsOr == other.m_IsOr;

            public override bool Equals(object obj) => obj is DeviceRequirement other && Equals(other);

            public override int GetHashCode() => HashCode.Combine(m_ControlPath, m_IsOptional, m_IsOr);

            public override string ToString() => m_IsOptional ? $"{m_ControlPath} (Optional)" : $"{m_ControlPath} (Required)";
        }
    }
}
