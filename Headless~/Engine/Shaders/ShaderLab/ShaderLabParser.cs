using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using UnityEngine.Rendering;

namespace UnityEngine.Shaders
{
    /// <summary>Reads .shader files. What this host cannot do (UsePass, GrabPass, surface shaders, fixed function) is an error, not left out.</summary>
    sealed class ShaderLabParser
    {
        readonly ShaderLabLexer m_Lexer;
        readonly ShaderLabStateParser m_States;
        readonly List<ShaderLabBlock> m_SharedCode = new();
        ShaderLabFile m_File;

        ShaderLabParser(string path, string source)
        {
            m_Lexer = new ShaderLabLexer(path, source);
            m_States = new ShaderLabStateParser(m_Lexer);
        }

        /// <exception cref="ShaderCompileException">The text is no ShaderLab; the message names file and line.</exception>
        internal static ShaderLabFile Parse(string path, string source) => new ShaderLabParser(path, source).File(path);

        ShaderLabFile File(string path)
        {
            m_Lexer.Expect("Shader");
            m_File = new ShaderLabFile(path, m_Lexer.Text("the shader's name"));
            m_Lexer.Expect("{");
            while (!m_Lexer.TryTake("}"))
                Part();
            if (m_Lexer.Peek().Kind != ShaderLabTokenKind.End)
                throw m_Lexer.Unexpected("the end of the file");
            if (m_File.SubShaders.Count == 0 && m_File.Fallback == null)
                throw m_Lexer.Error(m_Lexer.Peek().Line, $"shader \"{m_File.Name}\" has neither a SubShader nor a Fallback");
            return m_File;
        }

        void Part()
        {
            var token = m_Lexer.Take();
            if (IsShared(token))
                m_SharedCode.Add(new ShaderLabBlock(token.Text, token.Line));
            else if (token.Is("Properties"))
                Properties();
            else if (token.Is("SubShader"))
                SubShader();
            else if (token.Is("Fallback"))
                m_File.Fallback = m_Lexer.TryTake("Off") ? null : m_Lexer.Text("a shader's name or Off");
            else if (token.Is("CustomEditor"))
                m_File.CustomEditor = m_Lexer.Text("a class");
            else if (token.Is("CustomEditorForRenderPipeline"))
                (_, _) = (m_Lexer.Text("a class"), m_Lexer.Text("a class"));
            else if (token.Is("Dependency"))
            {
                var name = m_Lexer.Text("a name");
                m_Lexer.Expect("=");
                m_File.Dependencies[name] = m_Lexer.Text("a shader's name");
            }
            else
                throw m_Lexer.Error(token.Line, $"expected Properties, SubShader, Fallback or CustomEditor, got {token}");
        }

        void Properties()
        {
            m_Lexer.Expect("{");
            while (!m_Lexer.TryTake("}"))
                m_File.Properties.Add(ShaderLabPropertyParser.Parse(m_Lexer, m_File.Properties));
        }

        void SubShader()
        {
            var subShader = new ShaderLabSubShader();
            var state = new ShaderLabState();
            var shared = new List<ShaderLabBlock>(m_SharedCode);
            m_Lexer.Expect("{");
            while (!m_Lexer.TryTake("}"))
            {
                var token = m_Lexer.Take();
                if (IsShared(token))
                    shared.Add(new ShaderLabBlock(token.Text, token.Line));
                else if (token.Is("PackageRequirements"))
                    Requirements(subShader.Requirements);
                else if (token.Is("Tags"))
                    Tags(subShader.Tags);
                else if (token.Is("LOD"))
                    subShader.Lod = (int)m_Lexer.Number("a level of detail");
                else if (token.Is("Pass"))
                    subShader.Passes.Add(Pass(token.Line, state.Copy(), shared));
                else if (token.Is("UsePass") || token.Is("GrabPass"))
                    throw m_Lexer.Error(token.Line, $"{token.Text} is not supported by this host");
                else if (token.Kind == ShaderLabTokenKind.Code)
                    throw m_Lexer.Error(token.Line, "code outside of a Pass would be a surface shader, which is not supported by this host");
                else if (!m_States.TryParse(token, state))
                    throw m_Lexer.Error(token.Line, $"expected Tags, LOD, a state or Pass, got {token}");
            }
            CheckProperties(subShader);
            m_File.SubShaders.Add(subShader);
        }

        ShaderLabPass Pass(int line, ShaderLabState state, List<ShaderLabBlock> shared)
        {
            var pass = new ShaderLabPass { State = state, Line = line };
            var blocks = new List<ShaderLabBlock>(shared);
            m_Lexer.Expect("{");
            while (!m_Lexer.TryTake("}"))
            {
                var token = m_Lexer.Take();
                if (IsShared(token))
                    blocks.Add(new ShaderLabBlock(token.Text, token.Line));
                else if (token.Kind == ShaderLabTokenKind.Code)
                {
                    if (pass.Code != null)
                        throw m_Lexer.Error(token.Line, "a Pass has one program, this is a second one");
                    pass.Code = new ShaderLabCode { IsCg = token.Opening == "CGPROGRAM" };
                    pass.Code.Blocks.AddRange(blocks);
                    pass.Code.Blocks.Add(new ShaderLabBlock(token.Text, token.Line));
                }
                else if (token.Is("Name"))
                    pass.Name = m_Lexer.Text("a name");
                else if (token.Is("Tags"))
                    Tags(pass.Tags);
                else if (!m_States.TryParse(token, state))
                    throw m_Lexer.Error(token.Line, $"expected Name, Tags, a state or HLSLPROGRAM, got {token}");
            }
            if (pass.Code == null)
                throw m_Lexer.Error(line, "a Pass without a program would be drawn by fixed functions, which are not supported by this host");
            return pass;
        }

        void Tags(Dictionary<string, string> tags)
        {
            m_Lexer.Expect("{");
            while (!m_Lexer.TryTake("}"))
            {
                var name = m_Lexer.Text("a tag's name");
                m_Lexer.Expect("=");
                tags[name] = m_Lexer.Text("a tag's value");
                m_Lexer.TryTake(",");
            }
        }

        void Requirements(List<PackageRequirement> requirements)
        {
            m_Lexer.Expect("{");
            while (!m_Lexer.TryTake("}"))
            {
                var package = m_Lexer.Text("a package's name");
                requirements.Add(new PackageRequirement(package, m_Lexer.TryTake(":") ? m_Lexer.Text("a version") : null));
                m_Lexer.TryTake(",");
            }
        }

        void CheckProperties(ShaderLabSubShader subShader)
        {
            foreach (var pass in subShader.Passes)
                foreach (var name in pass.State.Properties())
                    if (m_File.Properties.All(p => p.Name != name))
                        throw m_Lexer.Error(pass.Line, $"a state of this Pass refers to [{name}], which is no property of the shader");
        }

        static bool IsShared(in ShaderLabToken token) => token.Kind == ShaderLabTokenKind.Code && token.Opening is "HLSLINCLUDE" or "CGINCLUDE";
    }

    /// <summary>What all readers of tokens need.</summary>
    static class ShaderLabReading
    {
        internal static bool TryTake(this ShaderLabLexer lexer, string symbolOrWord)
        {
            if (!lexer.Peek().Is(symbolOrWord))
                return false;
            lexer.Take();
            return true;
        }

        internal static void Expect(this ShaderLabLexer lexer, string symbolOrWord)
        {
            if (!lexer.TryTake(symbolOrWord))
                throw lexer.Unexpected("'" + symbolOrWord + "'");
        }

        internal static string Text(this ShaderLabLexer lexer, string what) =>
            lexer.Peek().Kind == ShaderLabTokenKind.Text ? lexer.Take().Text : throw lexer.Unexpected(what + " in quotation marks");

        internal static string Word(this ShaderLabLexer lexer, string what) =>
            lexer.Peek().Kind == ShaderLabTokenKind.Word ? lexer.Take().Text : throw lexer.Unexpected(what);

        internal static float Number(this ShaderLabLexer lexer, string what) => lexer.Peek().Kind == ShaderLabTokenKind.Number
            ? float.Parse(lexer.Take().Text, NumberStyles.Float, CultureInfo.InvariantCulture) : throw lexer.Unexpected(what);

        internal static ShaderCompileException Unexpected(this ShaderLabLexer lexer, string expected) =>
            lexer.Error(lexer.Peek().Line, $"expected {expected}, got {lexer.Peek()}");
    }
}
