using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.InputSystem
{
    /// <summary>One part of a control path: <c>&lt;layout&gt;{usage}#(display name)name</c>, each of which may be absent. Case does not matter.</summary>
    sealed class PathComponent
    {
        readonly List<string> m_Usages = new();

        internal string Layout { get; private set; }

        internal string Name { get; private set; }

        internal string DisplayName { get; private set; }

        internal IReadOnlyList<string> Usages => m_Usages;

        /// <summary>Whether it says nothing but usages, which are looked for in the whole device.</summary>
        internal bool IsUsageOnly => m_Usages.Count > 0 && Layout == null && Name == null && DisplayName == null;

        internal bool IsWildcard => Name == InputControlPath.Wildcard;

        /// <exception cref="FormatException">A bracket is not closed, or a part is empty.</exception>
        internal static List<PathComponent> Parse(string path)
        {
            var components = new List<PathComponent>();
            var at = path.Length > 0 && path[0] == InputControlPath.Separator ? 1 : 0;
            while (at < path.Length)
            {
                var component = new PathComponent();
                component.Read(path, ref at);
                components.Add(component);
                if (at < path.Length)
                    at++; // the separator
            }

            if (components.Count == 0)
                throw new FormatException($"'{path}' is no control path");
            return components;
        }

        /// <summary>Whether a control is meant, whatever its parents are.</summary>
        internal bool Matches(InputControl control)
        {
            if (Layout != null && Layout != InputControlPath.Wildcard && !InputManager.Instance.Layouts.IsBasedOn(control.layout, Layout))
                return false;
            foreach (var usage in m_Usages)
                if (usage != InputControlPath.Wildcard && !control.m_Usages.Any(u => u == usage))
                    return false;
            if (DisplayName != null && !Same(DisplayName, control.displayName))
                return false;
            return Name == null || Same(Name, control.name) || control.m_Aliases.Any(a => Same(Name, a));
        }

        void Read(string path, ref int at)
        {
            var start = at;
            if (at < path.Length && path[at] == '<')
                Layout = Bracketed(path, ref at, '>');
            while (at < path.Length && path[at] == '{')
                m_Usages.Add(Bracketed(path, ref at, '}'));
            if (at + 1 < path.Length && path[at] == '#' && path[at + 1] == '(')
            {
                at++;
                DisplayName = Bracketed(path, ref at, ')');
            }

            var end = path.IndexOf(InputControlPath.Separator, at);
            end = end < 0 ? path.Length : end;
            if (end > at)
                Name = path.Substring(at, end - at);
            at = end;
            if (at == start)
                throw new FormatException($"Control path '{path}' has an empty part at {start}");
        }

        static string Bracketed(string path, ref int at, char close)
        {
            var end = path.IndexOf(close, at);
            if (end < 0)
                throw new FormatException($"Control path '{path}' lacks a '{close}'");
            var text = path.Substring(at + 1, end - at - 1);
            at = end + 1;
            return text;
        }

        /// <summary>A star stands for any characters.</summary>
        static bool Same(string pattern, string text)
        {
            if (pattern.IndexOf('*') < 0)
                return string.Equals(pattern, text, StringComparison.OrdinalIgnoreCase);
            var parts = pattern.Split('*');
            if (!text.StartsWith(parts[0], StringComparison.OrdinalIgnoreCase))
                return false;
            var at = parts[0].Length;
            for (var i = 1; i < parts.Length - 1; i++)
            {
                var found = text.IndexOf(parts[i], at, StringComparison.OrdinalIgnoreCase);
                if (found < 0)
                    return false;
                at = found + parts[i].Length;
            }

            var last = parts[parts.Length - 1];
            return text.Length - at >= last.Length && text.EndsWith(last, StringComparison.OrdinalIgnoreCase);
        }
    }
}
