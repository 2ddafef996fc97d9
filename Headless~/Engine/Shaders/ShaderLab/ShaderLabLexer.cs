using System.Globalization;
using System.Text;

namespace UnityEngine.Shaders
{
    /// <summary>What a token of ShaderLab is.</summary>
    enum ShaderLabTokenKind
    {
        Word,
        Number,
        Text,
        Symbol,

        /// <summary>A block of HLSL; its text is the code, its line that of the code's first line.</summary>
        Code,
        End,
    }

    /// <summary>A token and where it begins.</summary>
    readonly struct ShaderLabToken
    {
        internal ShaderLabToken(ShaderLabTokenKind kind, string text, int line, string opening = null)
        {
            Kind = kind;
            Text = text;
            Line = line;
            Opening = opening;
        }

        internal readonly ShaderLabTokenKind Kind;
        internal readonly string Text;
        internal readonly int Line;

        /// <summary>Of code: HLSLPROGRAM, CGPROGRAM, HLSLINCLUDE or CGINCLUDE.</summary>
        internal readonly string Opening;

        internal bool Is(string symbolOrWord) =>
            Kind is ShaderLabTokenKind.Symbol or ShaderLabTokenKind.Word && string.Equals(Text, symbolOrWord, System.StringComparison.OrdinalIgnoreCase);

        public override string ToString() => Kind switch
        {
            ShaderLabTokenKind.End => "the end of the file",
            ShaderLabTokenKind.Text => "\"" + Text + "\"",
            ShaderLabTokenKind.Code => Opening,
            _ => "'" + Text + "'",
        };
    }

    /// <summary>Cuts a .shader file into tokens, one ahead.</summary>
    sealed class ShaderLabLexer
    {
        readonly string m_Path;
        readonly string m_Source;
        int m_At;
        int m_Line = 1;
        ShaderLabToken? m_Next;

        internal ShaderLabLexer(string path, string source)
        {
            m_Path = path;
            m_Source = source;
        }

        internal ShaderLabToken Peek() => m_Next ??= Read();

        internal ShaderLabToken Take()
        {
            var token = Peek();
            m_Next = null;
            return token;
        }

        internal ShaderCompileException Error(int line, string problem) =>
            new(string.Format(CultureInfo.InvariantCulture, "Shader error in '{0}': {1} at line {2}", m_Path, problem, line));

        ShaderLabToken Read()
        {
            SkipBlanks();
            if (m_At >= m_Source.Length)
                return new ShaderLabToken(ShaderLabTokenKind.End, "", m_Line);
            var c = m_Source[m_At];
            if (c == '"')
                return QuotedText();
            if (char.IsLetter(c) || c == '_')
                return WordOrCode();
            if (char.IsDigit(c) || (c is '-' or '+' or '.' && m_At + 1 < m_Source.Length && (char.IsDigit(m_Source[m_At + 1]) || m_Source[m_At + 1] == '.')))
                return NumberOrWord();
            m_At++;
            return new ShaderLabToken(ShaderLabTokenKind.Symbol, c.ToString(), m_Line);
        }

        void SkipBlanks()
        {
            while (m_At < m_Source.Length)
            {
                if (m_Source[m_At] == '\n')
                    m_Line++;
                if (char.IsWhiteSpace(m_Source[m_At]))
                    m_At++;
                else if (Starts("//"))
                    m_At = IndexOf("\n", m_Source.Length);
                else if (Starts("/*"))
                    SkipComment();
                else
                    return;
            }
        }

        void SkipComment()
        {
            var end = m_Source.IndexOf("*/", m_At + 2, System.StringComparison.Ordinal);
            if (end < 0)
                throw Error(m_Line, "a comment has no end");
            for (; m_At < end; m_At++)
                if (m_Source[m_At] == '\n')
                    m_Line++;
            m_At = end + 2;
        }

        ShaderLabToken QuotedText()
        {
            var line = m_Line;
            var end = m_Source.IndexOf('"', m_At + 1);
            var lineEnd = IndexOf("\n", m_Source.Length);
            if (end < 0 || end > lineEnd)
                throw Error(line, "a text has no closing quotation mark");
            var text = m_Source.Substring(m_At + 1, end - m_At - 1);
            m_At = end + 1;
            return new ShaderLabToken(ShaderLabTokenKind.Text, text, line);
        }

        ShaderLabToken WordOrCode()
        {
            var start = m_At;
            while (m_At < m_Source.Length && (char.IsLetterOrDigit(m_Source[m_At]) || m_Source[m_At] is '_' or '.'))
                m_At++;
            var word = m_Source.Substring(start, m_At - start);
            return word switch
            {
                "HLSLPROGRAM" or "HLSLINCLUDE" => Code(word, "ENDHLSL"),
                "CGPROGRAM" or "CGINCLUDE" => Code(word, "ENDCG"),
                _ => new ShaderLabToken(ShaderLabTokenKind.Word, word, m_Line),
            };
        }

        /// <summary>A number, or a word that starts with a digit such as 2D and 3D.</summary>
        ShaderLabToken NumberOrWord()
        {
            var start = m_At++;
            while (m_At < m_Source.Length && (char.IsLetterOrDigit(m_Source[m_At]) || m_Source[m_At] == '.'
                || (m_Source[m_At] is '-' or '+' && m_Source[m_At - 1] is 'e' or 'E')))
                m_At++;
            var text = m_Source.Substring(start, m_At - start);
            var isNumber = float.TryParse(text.TrimEnd('f'), NumberStyles.Float, CultureInfo.InvariantCulture, out _);
            if (!isNumber && !char.IsLetter(text[text.Length - 1]))
                throw Error(m_Line, $"'{text}' is no number");
            return new ShaderLabToken(isNumber ? ShaderLabTokenKind.Number : ShaderLabTokenKind.Word, isNumber ? text.TrimEnd('f') : text, m_Line);
        }

        ShaderLabToken Code(string opening, string closing)
        {
            var line = m_Line;
            var code = new StringBuilder();
            while (true)
            {
                var end = IndexOf("\n", m_Source.Length);
                var text = m_Source.Substring(m_At, end - m_At);
                if (Closes(text, closing))
                {
                    m_At += text.IndexOf(closing, System.StringComparison.Ordinal) + closing.Length;
                    return new ShaderLabToken(ShaderLabTokenKind.Code, code.ToString(), line, opening);
                }
                if (end >= m_Source.Length)
                    throw Error(line, $"{opening} has no {closing}");
                code.Append(text.TrimEnd('\r')).Append('\n');
                m_At = end + 1;
                m_Line++;
            }
        }

        static bool Closes(string line, string word)
        {
            var text = line.TrimStart();
            return text.StartsWith(word, System.StringComparison.Ordinal) && (text.Length == word.Length || !char.IsLetterOrDigit(text[word.Length]));
        }

        bool Starts(string text) => string.CompareOrdinal(m_Source, m_At, text, 0, text.Length) == 0;

        int IndexOf(string text, int otherwise)
        {
            var found = m_Source.IndexOf(text, m_At, System.StringComparison.Ordinal);
            return found < 0 ? otherwise : found;
        }
    }
}
