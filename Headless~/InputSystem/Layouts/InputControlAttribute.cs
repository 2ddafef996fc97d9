using System;
using UnityEngine.InputSystem.LowLevel;

namespace UnityEngine.InputSystem.Layouts
{
    /// <summary>Makes a control of a field of a state struct, or of a property of a device or control. Several on one field make several controls.</summary>
    [AttributeUsage(AttributeTargets.Field | AttributeTargets.Property, AllowMultiple = true)]
    public sealed class InputControlAttribute : PropertyAttribute
    {
        /// <summary>Empty = that of the control's type.</summary>
        public string layout { get; set; }

        public string name { get; set; }

        public string displayName { get; set; }

        public string shortDisplayName { get; set; }

        public string usage { get; set; }

        public string[] usages { get; set; }

        public string alias { get; set; }

        public string[] aliases { get; set; }

        /// <summary>Public fields of the control, such as "invert,scale=1,scaleFactor=2".</summary>
        public string parameters { get; set; }

        public string processors { get; set; }

        /// <summary>A control whose state it reads, instead of having one of its own.</summary>
        public string useStateFrom { get; set; }

        public string format { get; set; }

        public uint offset { get; set; } = InputStateBlock.InvalidOffset;

        public uint bit { get; set; } = InputStateBlock.InvalidOffset;

        public uint sizeInBits { get; set; }

        public object defaultState { get; set; }

        public bool noisy { get; set; }

        public bool synthetic { get; set; }

        public bool dontReset { get; set; }
    }

    /// <summary>Says more of a device or control class.</summary>
    [AttributeUsage(AttributeTargets.Class)]
    public sealed class InputControlLayoutAttribute : Attribute
    {
        /// <summary>The struct that is the device's state.</summary>
        public Type stateType { get; set; }

        public string[] commonUsages { get; set; }

        public string displayName { get; set; }

        public bool isGenericTypeOfDevice { get; set; }

        public bool hideInUI { get; set; }

        public bool isNoisy { get; set; }

        public bool canRunInBackground { get; set; }

        public bool updateBeforeRender { get; set; }
    }
}
