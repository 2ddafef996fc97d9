using System;
using System.Linq;

namespace UnityEngine.InputSystem
{
    /// <summary>A control path that triggers an action; or a composite, whose parts follow it in the map's list; or such a part.</summary>
    [Serializable]
    public struct InputBinding : IEquatable<InputBinding>
    {
        public const char Separator = ';';

        const int CompositeFlag = 1 << 2;
        const int PartFlag = 1 << 3;

        [SerializeField]
        string m_Name;

        [SerializeField]
        internal string m_Id;

        [SerializeField]
        string m_Path;

        [SerializeField]
        string m_Interactions;

        [SerializeField]
        string m_Processors;

        [SerializeField]
        string m_Groups;

        [SerializeField]
        string m_Action;

        [SerializeField]
        int m_Flags;

        [NonSerialized]
        string m_OverridePath;

        [NonSerialized]
        string m_OverrideInteractions;

        [NonSerialized]
        string m_OverrideProcessors;

        public InputBinding(
            string path, string action = null, string groups = null, string processors = null, string interactions = null, string name = null) : this()
        {
            m_Path = path;
            m_Action = action;
            m_Groups = groups;
            m_Processors = processors;
            m_Interactions = interactions;
            m_Name = name;
        }

        /// <summary>What to show how much of.</summary>
        [Flags]
        public enum DisplayStringOptions
        {
            DontUseShortDisplayNames = 1 << 0,
            DontOmitDevice = 1 << 1,
            DontIncludeInteractions = 1 << 2,
            IgnoreBindingOverrides = 1 << 3,
        }

        /// <summary>A part's name, such as "modifier"; a composite's is for people.</summary>
        public string name { get => m_Name; set => m_Name = value; }

        public Guid id
        {
            get => string.IsNullOrEmpty(m_Id) ? default : new Guid(m_Id);
            set => m_Id = value.ToString();
        }

        public string path { get => m_Path; set => m_Path = value; }

        public string overridePath { get => m_OverridePath; set => m_OverridePath = value; }

        public string interactions { get => m_Interactions; set => m_Interactions = value; }

        public string overrideInteractions { get => m_OverrideInteractions; set => m_OverrideInteractions = value; }

        public string processors { get => m_Processors; set => m_Processors = value; }

        public string overrideProcessors { get => m_OverrideProcessors; set => m_OverrideProcessors = value; }

        /// <summary>Names of binding groups, separated by semicolons.</summary>
        public string groups { get => m_Groups; set => m_Groups = value; }

        /// <summary>Name or id of the action.</summary>
        public string action { get => m_Action; set => m_Action = value; }

        public bool isComposite { get => Has(CompositeFlag); set => Set(CompositeFlag, value); }

        public bool isPartOfComposite { get => Has(PartFlag); set => Set(PartFlag, value); }

        public bool hasOverrides => overridePath != null || overrideProcessors != null || overrideInteractions != null;

        public string effectivePath => overridePath ?? path;

        public string effectiveInteractions => overrideInteractions ?? interactions;

        public string effectiveProcessors => overrideProcessors ?? processors;

        public static bool operator ==(InputBinding left, InputBinding right) => left.Equals(right);

        public static bool operator !=(InputBinding left, InputBinding right) => !left.Equals(right);

        /// <summary>Bindings in a group.</summary>
        public static InputBinding MaskByGroup(string group) => new() { groups = group };

        /// <summary>Bindings in any of some groups.</summary>
        public static InputBinding MaskByGroups(params string[] groups) => new() { groups = string.Join(";", groups.Where(g => !string.IsNullOrEmpty(g))) };

        /// <summary>The composite's kind: "2DVector". Null if this is none.</summary>
        public string GetNameOfComposite() => !isComposite ? null : string.IsNullOrEmpty(name) ? NameWithParameters.Parse(effectivePath).Name : name;

        /// <summary>Whether a binding has all that this one says.</summary>
        public bool Matches(InputBinding binding) => Matches(binding, false);

        public string ToDisplayString(DisplayStringOptions options = default, InputControl control = null) =>
            ToDisplayString(out _, out _, options, control);

        /// <summary>What people call the control; nothing for a composite.</summary>
        public string ToDisplayString(
            out string deviceLayoutName, out string controlPath, DisplayStringOptions options = default, InputControl control = null)
        {
            deviceLayoutName = null;
            controlPath = null;
            if (isComposite)
                return "";
            var readable = InputControlPath.HumanReadableStringOptions.None;
            if ((options & DisplayStringOptions.DontOmitDevice) == 0)
                readable |= InputControlPath.HumanReadableStringOptions.OmitDevice;
            if ((options & DisplayStringOptions.DontUseShortDisplayNames) == 0)
                readable |= InputControlPath.HumanReadableStringOptions.UseShortNames;
            var shown = (options & DisplayStringOptions.IgnoreBindingOverrides) != 0 ? path : effectivePath;
            return InputControlPath.ToHumanReadableString(shown, out deviceLayoutName, out controlPath, readable, control);
        }

        public bool Equals(InputBinding other) =>
            Same(effectivePath, other.effectivePath) && Same(effectiveInteractions, other.effectiveInteractions)
                && Same(effectiveProcessors, other.effectiveProcessors) && Same(groups, other.groups) && Same(action, other.action);

        public override bool Equals(object obj) => obj is InputBinding other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(effectivePath, effectiveInteractions, effectiveProcessors, groups, action);

        public override string ToString() =>
            $"{action}:{effectivePath}{(string.IsNullOrEmpty(groups) ? "" : $"[{groups}]")}";

        internal bool Matches(InputBinding binding, bool emptyGroupMatchesAny) =>
            MatchesList(name, binding.name) && MatchesList(path, binding.path) && MatchesList(action, binding.action)
                && (MatchesList(groups, binding.groups) || (emptyGroupMatchesAny && string.IsNullOrEmpty(binding.groups)))
                && (string.IsNullOrEmpty(m_Id) || binding.id == id);

        internal bool Triggers(InputAction candidate) =>
            string.Equals(action, candidate.name, StringComparison.OrdinalIgnoreCase) || (action != null && action == candidate.m_Id);

        internal void MakeSureItHasAnId()
        {
            if (string.IsNullOrEmpty(m_Id))
                m_Id = Guid.NewGuid().ToString();
        }

        static bool MatchesList(string wanted, string present) =>
            wanted == null || (present != null && wanted.Split(Separator).Intersect(present.Split(Separator), StringComparer.OrdinalIgnoreCase).Any());

        static bool Same(string a, string b) => string.Equals(a, b, StringComparison.OrdinalIgnoreCase);

        readonly bool Has(int flag) => (m_Flags & flag) != 0;

        void Set(int flag, bool on) => m_Flags = on ? m_Flags | flag : m_Flags & ~flag;
    }
}
