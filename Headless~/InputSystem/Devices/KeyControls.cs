using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using UnityEngine.InputSystem.Layouts;

namespace UnityEngine.InputSystem
{
    /// <summary>A keyboard's controls: what each key is called, in paths and by people.</summary>
    static class KeyControls
    {
        static readonly Dictionary<Key, string> s_Signs = new()
        {
            [Key.Backquote] = "`", [Key.Quote] = "'", [Key.Semicolon] = ";", [Key.Comma] = ",", [Key.Period] = ".", [Key.Slash] = "/",
            [Key.Backslash] = "\\", [Key.LeftBracket] = "[", [Key.RightBracket] = "]", [Key.Minus] = "-", [Key.Equals] = "=",
            [Key.NumpadDivide] = "Numpad /", [Key.NumpadMultiply] = "Numpad *", [Key.NumpadPlus] = "Numpad +", [Key.NumpadMinus] = "Numpad -",
            [Key.NumpadPeriod] = "Numpad .", [Key.NumpadEquals] = "Numpad =", [Key.Pause] = "Pause/Break", [Key.LeftCtrl] = "Left Control",
            [Key.RightCtrl] = "Right Control", [Key.LeftMeta] = "Left System", [Key.RightMeta] = "Right System",
        };

        static readonly Dictionary<Key, string[]> s_Aliases = new()
        {
            [Key.RightAlt] = new[] { "AltGr" },
            [Key.LeftMeta] = new[] { "LeftWindows", "LeftApple", "LeftCommand" },
            [Key.RightMeta] = new[] { "RightWindows", "RightApple", "RightCommand" },
        };

        static readonly Dictionary<Key, string[]> s_Usages = new()
        {
            [Key.Escape] = new[] { "Back", "Cancel" },
            [Key.Enter] = new[] { "Submit" },
        };

        /// <summary>The keys, each once.</summary>
        internal static IEnumerable<Key> All => Enumerable.Range(1, Keyboard.KeyCount).Select(i => (Key)i);

        /// <summary>All controls, as attributes of the keyboard's state would say them.</summary>
        internal static IEnumerable<InputControlAttribute> Attributes()
        {
            yield return new InputControlAttribute
            {
                name = "anyKey", displayName = "Any Key", layout = "AnyKey", bit = 0, sizeInBits = Keyboard.KeyCount + 1, synthetic = true,
            };
            foreach (var key in All)
                yield return new InputControlAttribute
                {
                    name = NameOf(key), displayName = DisplayNameOf(key), layout = "Key", bit = (uint)key,
                    aliases = s_Aliases.TryGetValue(key, out var aliases) ? aliases : null,
                    usages = s_Usages.TryGetValue(key, out var usages) ? usages : IsModifier(key) ? new[] { "Modifier" } : null,
                };
            yield return Either("shift", "Shift", Key.LeftShift);
            yield return Either("alt", "Alt", Key.LeftAlt);
            yield return Either("ctrl", "Control", Key.LeftCtrl);
            yield return new InputControlAttribute { name = "IMESelected", layout = "Button", bit = (uint)Key.IMESelected, synthetic = true };
        }

        internal static string NameOf(Key key)
        {
            var text = key.ToString();
            if (key is >= Key.Digit1 and <= Key.Digit0)
                return text.Substring("Digit".Length);
            return key >= Key.OEM1 ? text : char.ToLowerInvariant(Canonical(key)[0]) + Canonical(key).Substring(1);
        }

        static string DisplayNameOf(Key key)
        {
            if (s_Signs.TryGetValue(key, out var sign))
                return sign;
            if (key is >= Key.Digit1 and <= Key.Digit0)
                return NameOf(key);
            if (key is >= Key.F1 and <= Key.F12 || key >= Key.OEM1)
                return key.ToString();
            // "LeftArrow" is Left Arrow, "Numpad7" Numpad 7.
            var words = new StringBuilder();
            foreach (var c in Canonical(key))
                words.Append(words.Length > 0 && (char.IsUpper(c) || char.IsDigit(c)) ? " " : "").Append(c);
            return words.ToString();
        }

        /// <summary>Of several names of one value, the one that its control has.</summary>
        static string Canonical(Key key) => key switch
        {
            Key.RightAlt => nameof(Key.RightAlt),
            Key.LeftMeta => nameof(Key.LeftMeta),
            Key.RightMeta => nameof(Key.RightMeta),
            _ => key.ToString(),
        };

        static bool IsModifier(Key key) => key is >= Key.LeftShift and <= Key.ContextMenu;

        /// <summary>A control that is down while the left or the right key is; their bits lie side by side.</summary>
        static InputControlAttribute Either(string name, string displayName, Key left) => new()
        {
            name = name, displayName = displayName, layout = "DiscreteButton", usage = "Modifier", bit = (uint)left, sizeInBits = 2, synthetic = true,
            parameters = "minValue=1,maxValue=3,writeMode=1",
        };
    }
}
