using System;
using System.Collections.Generic;
using System.Globalization;
using System.Reflection;

namespace UnityEngine.InputSystem
{
    /// <summary>What is written as <c>scale(factor=2)</c>: a processor, a composite or a control's settings.</summary>
    readonly struct NameWithParameters
    {
        NameWithParameters(string name, List<KeyValuePair<string, string>> parameters)
        {
            Name = name;
            Parameters = parameters;
        }

        internal string Name { get; }

        internal List<KeyValuePair<string, string>> Parameters { get; }

        /// <exception cref="FormatException">The parentheses are not closed.</exception>
        internal static NameWithParameters Parse(string text)
        {
            text = text.Trim();
            var open = text.IndexOf('(');
            if (open < 0)
                return new NameWithParameters(text, new List<KeyValuePair<string, string>>());
            if (!text.EndsWith(")", StringComparison.Ordinal))
                throw new FormatException($"Expecting ')' after parameters in '{text}'");
            return new NameWithParameters(text.Substring(0, open).Trim(), ParseParameters(text.Substring(open + 1, text.Length - open - 2)));
        }

        /// <summary>Several, separated by commas outside of parentheses, or by semicolons.</summary>
        internal static List<NameWithParameters> ParseMultiple(string text)
        {
            var found = new List<NameWithParameters>();
            var depth = 0;
            var start = 0;
            for (var i = 0; i <= text.Length; i++)
            {
                var c = i < text.Length ? text[i] : ',';
                depth += c == '(' ? 1 : c == ')' ? -1 : 0;
                if (depth != 0 || (c != ',' && c != ';'))
                    continue;
                if (i > start)
                    found.Add(Parse(text.Substring(start, i - start)));
                start = i + 1;
            }

            if (depth != 0)
                throw new FormatException($"Expecting ')' after parameters in '{text}'");
            return found;
        }

        /// <summary>"a=1,b": a name alone means true.</summary>
        internal static List<KeyValuePair<string, string>> ParseParameters(string text)
        {
            var found = new List<KeyValuePair<string, string>>();
            foreach (var item in (text ?? "").Split(new[] { ',', ';' }, StringSplitOptions.RemoveEmptyEntries))
            {
                var equals = item.IndexOf('=');
                found.Add(equals < 0
                    ? new KeyValuePair<string, string>(item.Trim(), "true")
                    : new KeyValuePair<string, string>(item.Substring(0, equals).Trim(), item.Substring(equals + 1).Trim()));
            }

            return found;
        }

        /// <summary>Sets public fields by name, case ignored.</summary>
        /// <exception cref="FormatException">There is no such field, or the text is no value for it.</exception>
        internal static void Apply(List<KeyValuePair<string, string>> parameters, object target)
        {
            foreach (var parameter in parameters)
            {
                var field = target.GetType().GetField(parameter.Key, BindingFlags.Instance | BindingFlags.Public | BindingFlags.IgnoreCase);
                if (field == null)
                    throw new FormatException($"{target.GetType().Name} has no parameter '{parameter.Key}'");
                field.SetValue(target, Convert(parameter.Value, field.FieldType));
            }
        }

        static object Convert(string text, Type type)
        {
            if (type.IsEnum)
                return int.TryParse(text, NumberStyles.Integer, CultureInfo.InvariantCulture, out var number)
                    ? Enum.ToObject(type, number)
                    : Enum.Parse(type, text, true);
            if (type == typeof(bool))
                return text is not ("false" or "False" or "0");
            return System.Convert.ChangeType(text, type, CultureInfo.InvariantCulture);
        }
    }
}
