using System;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine.Shaders;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>The stages of .shader files that Direct3D's compilers are asked about.</summary>
    public sealed class ShaderStagesTests : DrawTest
    {
        static string Root => GraphicsSetUp.Host.PackageRoot;

        [Test]
        public void Stages_AreThoseOfAllPassesAndVariants_ButViews()
        {
            var stages = ShaderStages.Of(Root, Fixture("Box"));
            Assert.That(stages.Select(s => $"{s.Name} {s.Entry} [{string.Join(" ", s.Keywords)}]"), Is.EquivalentTo(new[]
            {
                "Box 1.1 vert []", "Box 1.1 frag []",
                "Box 1.1 vert [STEREO_INSTANCING_ON]", "Box 1.1 frag [STEREO_INSTANCING_ON]",
                "Box 1.1 vert [INSTANCING_ON]", "Box 1.1 frag [INSTANCING_ON]",
                "Box 1.1 vert [INSTANCING_ON STEREO_INSTANCING_ON]", "Box 1.1 frag [INSTANCING_ON STEREO_INSTANCING_ON]",
            }));
            Assert.That(stages.Count(s => s.IsVertex), Is.EqualTo(4));
        }

        [Test]
        public void Stages_HaveUnitysDefines()
        {
            var stage = ShaderStages.Of(Root, Fixture("Box")).Single(s => s.IsVertex && s.Keywords.Count == 2);
            Assert.That(stage.Defines, Is.SupersetOf(new[]
            {
                "SHADER_API_D3D11=1", "SHADER_STAGE_VERTEX=1", "SHADER_TARGET=45", "INSTANCING_ON=1", "STEREO_INSTANCING_ON=1",
            }));
            Assert.That(stage.Defines, Has.None.StartsWith("SHADER_API_VULKAN"));
        }

        [Test]
        public void Text_HoldsAllIncludes_ThoseOfUniversalToo()
        {
            var stages = ShaderStages.Of(Root, Fixture("Eyes"));
            Assert.That(stages.Select(s => s.Name).Distinct(), Is.EqualTo(new[] { "Eyes 1.1", "Eyes 2.1" }), "the SubShader for URP and the other one");
            foreach (var stage in stages)
                Assert.That(stage.Text.Split('\n').Where(l => l.Contains("#include") || l.StartsWith("#error", StringComparison.Ordinal)), Is.Empty);
            Assert.That(stages[0].Text, Does.Contain("TransformObjectToHClip"));
            Assert.That(stages[^1].Text, Does.Contain("UnityObjectToClipPos"));
            Assert.That(ShaderEnvironment.HasPackage(ShaderEnvironment.UniversalPackage), Is.False, "URP was there for this only");
        }

        [Test]
        public void WhatDependsOnTheColourSpace_ComesForBoth()
        {
            var path = Written("Shader \"T\" { SubShader { Pass { HLSLPROGRAM\n#pragma vertex v\n#pragma fragment f\n"
                + "#ifdef UNITY_COLORSPACE_GAMMA\n#endif\nENDHLSL } } }");
            Assert.That(ShaderStages.Of(Root, path).Select(s => s.Entry + string.Concat(s.Keywords)),
                Is.EqualTo(new[] { "v", "f", "fUNITY_COLORSPACE_GAMMA", "vSTEREO_INSTANCING_ON", "fSTEREO_INSTANCING_ON" }));
        }

        [TestCase("#pragma exclude_renderers d3d11", 0)]
        [TestCase("#pragma only_renderers vulkan", 0)]
        [TestCase("#pragma only_renderers vulkan d3d11", 4)]
        public void PassesForOtherApis_AreLeftOut(string pragma, int count)
        {
            var path = Written($"Shader \"T\" {{ SubShader {{ Pass {{ HLSLPROGRAM\n#pragma vertex v\n#pragma fragment f\n{pragma}\nENDHLSL }} }} }}");
            Assert.That(ShaderStages.Of(Root, path), Has.Count.EqualTo(count));
        }

        [Test]
        public void Errors_SayWhere()
        {
            var path = Written("Shader \"T\"\n{\n    Subshader\n    {\n        Cull Sideways\n    }\n}");
            Assert.That(() => ShaderStages.Of(Root, path), Throws.TypeOf<FormatException>().With.Message.Contains("at line 5"));
        }

        static string Fixture(string name) => Path.Combine(FixtureFolder, name + ".shader");

        static string Written(string text)
        {
            var path = Path.Combine(TestContext.CurrentContext.WorkDirectory, "written.shader");
            File.WriteAllText(path, text);
            return path;
        }
    }
}
