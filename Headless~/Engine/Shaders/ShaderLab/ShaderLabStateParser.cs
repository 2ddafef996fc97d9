using System;
using System.Collections.Generic;
using System.Globalization;
using UnityEngine.Rendering;

namespace UnityEngine.Shaders
{
    /// <summary>Reads fixed states: Cull, ZTest, Blend and the like.</summary>
    sealed class ShaderLabStateParser
    {
        static readonly (string Word, CompareFunction Value)[] s_Comparisons =
        {
            ("Disabled", CompareFunction.Disabled), ("Never", CompareFunction.Never), ("Less", CompareFunction.Less), ("Equal", CompareFunction.Equal),
            ("LEqual", CompareFunction.LessEqual), ("Greater", CompareFunction.Greater), ("NotEqual", CompareFunction.NotEqual),
            ("GEqual", CompareFunction.GreaterEqual), ("Always", CompareFunction.Always),
        };

        static readonly (string Word, BlendOp Value)[] s_Operations =
        {
            ("Add", BlendOp.Add), ("Sub", BlendOp.Subtract), ("RevSub", BlendOp.ReverseSubtract), ("Min", BlendOp.Min), ("Max", BlendOp.Max),
        };

        readonly ShaderLabLexer m_Lexer;

        internal ShaderLabStateParser(ShaderLabLexer lexer) => m_Lexer = lexer;

        /// <summary>False if the token starts no state.</summary>
        internal bool TryParse(in ShaderLabToken token, ShaderLabState state)
        {
            if (token.Kind != ShaderLabTokenKind.Word)
                return false;
            switch (token.Text.ToLowerInvariant())
            {
                case "cull": state.Cull = Value("Back, Front or Off", Cull); break;
                case "ztest": state.ZTest = Value("a comparison such as LEqual", Comparison); break;
                case "zwrite": state.ZWrite = Value("On or Off", Switch); break;
                case "zclip": state.ZClip = Value("True or False", Switch); break;
                case "alphatomask": state.AlphaToMask = Value("On or Off", Switch); break;
                case "colormask": state.ColorMask = Value("channels such as RGB, or 0", Mask); break;
                case "offset": Offset(state); break;
                case "blend": Blend(state); break;
                case "blendop": BlendOperation(state); break;
                case "stencil": Stencil(state); break;
                // Fixed-function lighting and fog, which programmable passes do not have anyway.
                case "lighting": Value("On or Off", Switch); break;
                case "fog": Skip(); break;
                default: return false;
            }
            return true;
        }

        void Offset(ShaderLabState state)
        {
            state.OffsetFactor = Value("a factor", _ => null);
            m_Lexer.Expect(",");
            state.OffsetUnits = Value("units", _ => null);
        }

        void Blend(ShaderLabState state)
        {
            RefuseOtherTargets();
            state.Blends = !m_Lexer.TryTake("Off");
            if (!state.Blends)
                return;
            state.SourceAlpha = state.SourceColor = Factor();
            state.TargetAlpha = state.TargetColor = Factor();
            if (!m_Lexer.TryTake(","))
                return;
            state.SourceAlpha = Factor();
            state.TargetAlpha = Factor();
        }

        void BlendOperation(ShaderLabState state)
        {
            RefuseOtherTargets();
            state.AlphaOperation = state.ColorOperation = Operation();
            if (m_Lexer.TryTake(","))
                state.AlphaOperation = Operation();
        }

        void RefuseOtherTargets()
        {
            var token = m_Lexer.Peek();
            if (token.Kind != ShaderLabTokenKind.Number)
                return;
            if (token.Text != "0")
                throw m_Lexer.Error(token.Line, $"blending of its own for target {token.Text} is not supported by this host");
            m_Lexer.Take();
        }

        void Stencil(ShaderLabState state)
        {
            state.Stencil = new Dictionary<string, StateValue>(StringComparer.OrdinalIgnoreCase);
            m_Lexer.Expect("{");
            while (!m_Lexer.TryTake("}"))
            {
                var key = m_Lexer.Word("a stencil value");
                state.Stencil[key] = Value("a number or a word", StencilWord);
            }
        }

        StateValue Factor() => Value("a blend factor such as One", w => Enum.TryParse<BlendMode>(w, true, out var mode) ? (float)(int)mode : null);

        StateValue Operation() => Value("a blend operation such as Add", w => Lookup(s_Operations, w));

        /// <summary>A number, a property in brackets, or a word.</summary>
        StateValue Value(string expected, Func<string, float?> ofWord)
        {
            var token = m_Lexer.Peek();
            if (m_Lexer.TryTake("["))
            {
                var property = m_Lexer.Word("a property's name");
                m_Lexer.Expect("]");
                return StateValue.OfProperty(property);
            }
            if (token.Kind == ShaderLabTokenKind.Number)
                return StateValue.Of(m_Lexer.Number(expected));
            if (token.Kind == ShaderLabTokenKind.Word && ofWord(token.Text) is { } value)
            {
                m_Lexer.Take();
                return StateValue.Of(value);
            }
            throw m_Lexer.Unexpected(expected);
        }

        void Skip()
        {
            m_Lexer.Expect("{");
            while (!m_Lexer.TryTake("}"))
                if (m_Lexer.Take().Kind == ShaderLabTokenKind.End)
                    throw m_Lexer.Unexpected("'}'");
        }

        static float? Cull(string word) => Enum.TryParse<CullMode>(word, true, out var mode) ? (float)(int)mode : null;

        static float? Comparison(string word) => word.Equals("Off", StringComparison.OrdinalIgnoreCase) ? (float)(int)CompareFunction.Disabled
            : Lookup(s_Comparisons, word);

        static float? StencilWord(string word) => Comparison(word)
            ?? (Enum.TryParse<StencilOp>(word.Replace("Sat", "Saturate").Replace("Incr", "Increment").Replace("Decr", "Decrement"), true, out var operation)
                ? (float)(int)operation : null);

        static float? Switch(string word) => word.ToLowerInvariant() switch { "on" or "true" => 1f, "off" or "false" => 0f, _ => null };

        static float? Mask(string word)
        {
            var mask = (ColorWriteMask)0;
            foreach (var c in word.ToUpper(CultureInfo.InvariantCulture))
            {
                if ("RGBA".IndexOf(c) < 0)
                    return null;
                mask |= c switch { 'R' => ColorWriteMask.Red, 'G' => ColorWriteMask.Green, 'B' => ColorWriteMask.Blue, _ => ColorWriteMask.Alpha };
            }
            return (int)mask;
        }

        static float? Lookup<T>((string Word, T Value)[] table, string word)
        {
            foreach (var (known, value) in table)
                if (known.Equals(word, StringComparison.OrdinalIgnoreCase))
                    return Convert.ToInt32(value, CultureInfo.InvariantCulture);
            return null;
        }
    }
}
