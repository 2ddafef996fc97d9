using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Shaders;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>What a .shader file says, and what is said of a wrong one. No device is needed.</summary>
    public sealed class ShaderLabTests
    {
        const string Program = "HLSLPROGRAM\n#pragma vertex v\n#pragma fragment f\nENDHLSL";

        static ShaderLabFile Parse(string text) => ShaderLabParser.Parse("some.shader", text);

        static ShaderLabPass Pass(string states) => Parse($"Shader \"S\" {{ SubShader {{ Pass {{ {states}\n{Program} }} }} }}").SubShaders[0].Passes[0];

        static string Problem(string text)
        {
            var problem = Assert.Throws<ShaderCompileException>(() => Parse(text)).Message;
            Assert.That(problem, Does.StartWith("Shader error in 'some.shader': "));
            return problem;
        }

        [Test]
        public void File_WithEverything_IsRead()
        {
            var file = Parse(@"
// a comment
Shader ""Group/Name""
{
    Properties
    {
        [MainColor] _Color (""Colour"", Color) = (0.5, 1, .25, 1)
        [Toggle(ON)] [HideInInspector] _On (""On"", Float) = 1
        _Part (""Part"", Range(-1, 2.5)) = 0.5
        _Count (""Count"", Integer) = -3
        _Vector (""Vector"", Vector) = (1, 2, 3, 4)
        [NoScaleOffset] _Volume (""Volume"", 3D) = """" {}
        _MainTex (""Texture"", 2D) = ""bump"" {}
    }
    HLSLINCLUDE
    float shared1;
    ENDHLSL
    /* another
       comment */
    SubShader
    {
        PackageRequirements { ""com.unity.render-pipelines.universal"": ""17.0"" ""unity"": ""6000.0"" }
        Tags { ""RenderPipeline"" = ""UniversalPipeline"" ""Queue"" = ""Transparent+5"" }
        LOD 200
        Cull Front
        Pass
        {
            Name ""ONE""
            Tags { ""LightMode"" = ""UniversalForward"" }
            ZWrite Off
            " + Program + @"
        }
    }
    SubShader { Pass { " + Program + @" } }
    Fallback ""Other""
    CustomEditor ""Some.Editor""
}");
            Assert.That((file.Name, file.Fallback, file.CustomEditor), Is.EqualTo(("Group/Name", "Other", "Some.Editor")));
            Assert.That(file.Properties.Select(p => (p.Name, p.Type)), Is.EqualTo(new[]
            {
                ("_Color", ShaderPropertyType.Color), ("_On", ShaderPropertyType.Float), ("_Part", ShaderPropertyType.Range),
                ("_Count", ShaderPropertyType.Int), ("_Vector", ShaderPropertyType.Vector), ("_Volume", ShaderPropertyType.Texture),
                ("_MainTex", ShaderPropertyType.Texture),
            }));
            Assert.That(file.Properties[0].Default, Is.EqualTo(new Vector4(0.5f, 1, 0.25f, 1)));
            Assert.That(file.Properties[0].Flags, Is.EqualTo(ShaderPropertyFlags.MainColor));
            Assert.That(file.Properties[1].Flags, Is.EqualTo(ShaderPropertyFlags.HideInInspector));
            Assert.That((file.Properties[2].Range, file.Properties[3].Default.x), Is.EqualTo((new Vector2(-1, 2.5f), -3f)));
            Assert.That((file.Properties[5].Dimension, file.Properties[6].DefaultTexture), Is.EqualTo((TextureDimension.Tex3D, "bump")));
            var first = file.SubShaders[0];
            Assert.That((first.Tag("renderpipeline"), first.Lod, ShaderQueue.Parse(first.Tag("Queue"))), Is.EqualTo(("UniversalPipeline", 200, 3005)));
            Assert.That(first.Requirements.Select(r => (r.Package, r.Version)),
                Is.EqualTo(new[] { ("com.unity.render-pipelines.universal", "17.0"), ("unity", "6000.0") }));
            var pass = first.Passes[0];
            Assert.That((pass.Name, pass.LightMode, pass.State.Cull.Number, pass.State.ZWrite.Number), Is.EqualTo(("ONE", "UniversalForward", 1f, 0f)));
            Assert.That(pass.Code.Blocks.Select(b => b.Text.Trim()).First(), Is.EqualTo("float shared1;"));
            Assert.That(file.SubShaders[1].Passes[0].State.Cull.Number, Is.EqualTo(2f), "states of one SubShader are its own");
        }

        [Test]
        public void States_AreReadAsNumbersAndProperties()
        {
            var file = Parse(@"Shader ""S"" { Properties { _Z (""Z"", Int) = 4 } SubShader { Pass {
                ZTest [_Z] Blend SrcAlpha OneMinusSrcAlpha, One Zero BlendOp Max, RevSub ColorMask RB Offset -1, 2.5 ZClip False AlphaToMask On
                Stencil { Ref 3 Comp Equal Pass IncrSat } " + Program + "} } }");
            var state = file.SubShaders[0].Passes[0].State;
            Assert.That(state.ZTest.Property, Is.EqualTo("_Z"));
            Assert.That(state.Blends, Is.True);
            Assert.That(((BlendMode)state.SourceColor.Number, (BlendMode)state.TargetColor.Number, (BlendMode)state.SourceAlpha.Number),
                Is.EqualTo((BlendMode.SrcAlpha, BlendMode.OneMinusSrcAlpha, BlendMode.One)));
            Assert.That(((BlendOp)state.ColorOperation.Number, (BlendOp)state.AlphaOperation.Number), Is.EqualTo((BlendOp.Max, BlendOp.ReverseSubtract)));
            Assert.That((ColorWriteMask)state.ColorMask.Number, Is.EqualTo(ColorWriteMask.Red | ColorWriteMask.Blue));
            Assert.That((state.OffsetFactor.Number, state.OffsetUnits.Number, state.ZClip.Number, state.AlphaToMask.Number), Is.EqualTo((-1f, 2.5f, 0f, 1f)));
            Assert.That((StencilOp)state.Stencil["Pass"].Number, Is.EqualTo(StencilOp.IncrementSaturate));
        }

        [TestCase("Cull Sideways", "expected Back, Front or Off, got 'Sideways' at line 1")]
        [TestCase("Blend One", "expected a blend factor such as One, got HLSLPROGRAM at line 2")]
        [TestCase("Blend 1 One Zero", "blending of its own for target 1 is not supported by this host at line 1")]
        [TestCase("ZTest [_Absent]", "a state of this Pass refers to [_Absent], which is no property of the shader at line 1")]
        [TestCase("Colour Red", "expected Name, Tags, a state or HLSLPROGRAM, got 'Colour' at line 1")]
        public void Pass_WithAWrongState_SaysWhere(string states, string problem) =>
            Assert.That(Problem($"Shader \"S\" {{ SubShader {{ Pass {{ {states}\n{Program} }} }} }}"), Does.EndWith(problem));

        [TestCase("Shader Name { }", "expected the shader's name in quotation marks, got 'Name' at line 1")]
        [TestCase("Shader \"S\" { Properties { _A (\"A\", Number) = 1 } }", "property _A has an unknown type 'Number' at line 1")]
        [TestCase("Shader \"S\" { Properties { _A (\"A\", Float) = 1\n_A (\"A\", Float) = 1 } }", "property _A is declared twice at line 2")]
        [TestCase("Shader \"S\" {\n}", "shader \"S\" has neither a SubShader nor a Fallback at line 2")]
        [TestCase("Shader \"S\" { SubShader {\nPass { } } }",
            "a Pass without a program would be drawn by fixed functions, which are not supported by this host at line 2")]
        [TestCase("Shader \"S\" { SubShader { UsePass \"X\" } }", "UsePass is not supported by this host at line 1")]
        [TestCase("Shader \"S\" { SubShader { Pass {\nHLSLPROGRAM\nvoid f() {}\n } } }", "HLSLPROGRAM has no ENDHLSL at line 2")]
        [TestCase("Shader \"S\" { /* open", "a comment has no end at line 1")]
        public void File_ThatIsWrong_SaysWhere(string text, string problem) => Assert.That(Problem(text), Does.EndWith(problem));

        [TestCase("", 2000)]
        [TestCase("Geometry-10", 1990)]
        [TestCase("AlphaTest + 50", 2500)]
        [TestCase("overlay", 4000)]
        public void Queue_IsANameAndANumber(string tag, int expected) => Assert.That(ShaderQueue.Parse(tag), Is.EqualTo(expected));

        [TestCase(null, "1.0", true)]
        [TestCase("17.0", "17.0.3", true)]
        [TestCase("17.0", "16.9.9", false)]
        [TestCase("[16,17)", "16.5", true)]
        [TestCase("[16,17)", "17.0.0", false)]
        [TestCase("(16,]", "16.0", false)]
        [TestCase("[2.0.1]", "2.0.1", true)]
        [TestCase("2021.2", "6000.0.78f1", true)]
        public void VersionRange_IsUnitysNotation(string expression, string version, bool expected) =>
            Assert.That(VersionRange.Contains(expression, version), Is.EqualTo(expected));

        [Test]
        public void Variants_AreAllCombinationsOfKeywords()
        {
            var file = Parse(@"Shader ""S"" { SubShader { Pass {
HLSLPROGRAM
#pragma vertex v // comment
#pragma fragment f
#pragma target 4.5
#pragma multi_compile_local _ A B
#pragma shader_feature C
#pragma only_renderers d3d11 vulkan
ENDHLSL
} } }");
            var source = PassSource.Load(file, file.SubShaders[0].Passes[0]);
            Assert.That((source.VertexEntry, source.FragmentEntry, source.Target), Is.EqualTo(("v", "f", 45)));
            Assert.That((source.RunsOn("vulkan"), source.RunsOn("metal")), Is.EqualTo((true, false)));
            Assert.That(source.AllVariants().Count(), Is.EqualTo(3 * 2 * 3), "one eye, both by instances, both by views");
        }

        [TestCase("#pragma vertex v", "the Pass's program needs '#pragma vertex' and '#pragma fragment' at some.shader(1)")]
        [TestCase("#pragma geometry g", "'#pragma geometry' is not supported by this host at some.shader(2)")]
        [TestCase("#pragma target 7.0", "'#pragma target 7.0' is no shader model from 2.0 to 5.0 at some.shader(2)")]
        [TestCase("#pragma multi_compile", "'#pragma multi_compile' names no keyword at some.shader(2)")]
        public void Pragma_ThatIsWrong_SaysWhere(string pragma, string problem)
        {
            var file = Parse("Shader \"S\" { SubShader { Pass { HLSLPROGRAM\n" + pragma + "\nENDHLSL } } }");
            Assert.That(() => PassSource.Load(file, file.SubShaders[0].Passes[0]),
                Throws.TypeOf<ShaderCompileException>().With.Message.EqualTo("Shader error in 'S': " + problem));
        }
    }
}
