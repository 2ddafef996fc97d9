using System;

namespace UnityEngine.InputSystem.Utilities
{
    /// <summary>A text that is compared without case: names of layouts, controls and usages.</summary>
    public struct InternedString : IEquatable<InternedString>, IComparable<InternedString>
    {
        readonly string m_Text;

        public InternedString(string text) => m_Text = string.IsNullOrEmpty(text) ? null : string.Intern(text);

        public int length => m_Text?.Length ?? 0;

        public static implicit operator string(InternedString str) => str.ToString();

        public static bool operator ==(InternedString a, InternedString b) => a.Equals(b);

        public static bool operator !=(InternedString a, InternedString b) => !a.Equals(b);

        public static bool operator ==(InternedString a, string b) => a.CompareTo(new InternedString(b)) == 0;

        public static bool operator !=(InternedString a, string b) => a.CompareTo(new InternedString(b)) != 0;

        public static bool operator ==(string a, InternedString b) => b == a;

        public static bool operator !=(string a, InternedString b) => b != a;

        public static bool operator <(InternedString left, InternedString right) => left.CompareTo(right) < 0;

        public static bool operator >(InternedString left, InternedString right) => left.CompareTo(right) > 0;

        public bool IsEmpty() => m_Text == null;

        public string ToLower() => ToString().ToLowerInvariant();

        public bool Equals(InternedString other) => CompareTo(other) == 0;

        public override bool Equals(object obj) => (obj is InternedString other && Equals(other)) || (obj is string text && this == text);

        public override int GetHashCode() => m_Text == null ? 0 : StringComparer.OrdinalIgnoreCase.GetHashCode(m_Text);

        public override string ToString() => m_Text ?? "";

        public int CompareTo(InternedString other) => string.Compare(m_Text ?? "", other.m_Text ?? "", StringComparison.OrdinalIgnoreCase);
    }
}
