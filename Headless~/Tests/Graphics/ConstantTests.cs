using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    [TestFixture(KernelCompiler.Glslang)]
    [TestFixture(KernelCompiler.Fxc)]
    public sealed class ConstantTests(KernelCompiler compiler) : GpuTest(compiler)
    {
        static readonly Matrix4x4 s_Matrix = Matrix4x4.TRS(new Vector3(1, 2, 3), Quaternion.Euler(10, 20, 30), new Vector3(1, 2, 4));
        static readonly Vector4 s_Point = new(5, 6, 7, 1);

        [Test]
        public void NamedValues_OfAllKinds_ArriveWhereTheShaderReadsThem()
        {
            var shader = Load("Constants");
            shader.SetMatrix("_Matrix", s_Matrix);
            shader.SetVector("_Point", s_Point);
            shader.SetInts("_Ints", -1, 2, -3, 4);
            shader.SetFloats("_Three", 1.5f, 2.5f, 3.5f);
            shader.SetFloat("_AfterThree", 4.5f);
            shader.SetFloats("_Two", 5.5f, 6.5f);
            shader.SetInt("_Word", 77);
            shader.SetVectorArray("_Rows", new[] { Vector4.zero, new Vector4(1, 2, 3, 4), new Vector4(5, 6, 7, 8) });
            shader.SetMatrixArray("_Matrices", new[] { Matrix4x4.identity, s_Matrix });
            var result = Run(shader, "Named");
            Assert.That(result[0], Is.EqualTo(s_Matrix * s_Point));
            Assert.That(result[1], Is.EqualTo(new Vector4(-1, 2, -3, 4)));
            Assert.That(result[2], Is.EqualTo(new Vector4(1.5f, 2.5f, 3.5f, 4.5f)));
            Assert.That(result[3], Is.EqualTo(new Vector4(5.5f, 6.5f, 77, s_Matrix.m03)));
            Assert.That(result[4], Is.EqualTo(new Vector4(1, 2, 3, 4)));
            Assert.That(result[5], Is.EqualTo(new Vector4(5, 6, 7, 8)));
            Assert.That(result[6], Is.EqualTo(s_Matrix * s_Point));
            Assert.That(result[7], Is.EqualTo(new Vector4(s_Matrix.m03, s_Matrix.m30, s_Matrix.m13, 0)));
        }

        [Test]
        public void Value_NeverSet_IsZero()
        {
            var shader = Load("Constants");
            Assert.That(Run(shader, "Loose")[0], Is.EqualTo(Vector4.zero));
        }

        [Test]
        public void GlobalValue_NotSetLocally_IsSeen()
        {
            Shader.SetGlobalFloat("_LooseFloat", 3);
            try
            {
                var shader = Load("Constants");
                Assert.That(Run(shader, "Loose")[0].x, Is.EqualTo(3));
                shader.SetFloat("_LooseFloat", 4);
                Assert.That(Run(shader, "Loose")[0].x, Is.EqualTo(4));
            }
            finally
            {
                ShaderGlobals.Clear();
            }
        }

        [Test]
        public void FloatSetAsInt_KeepsTheBits_AndWarnsOnce()
        {
            var shader = Load("Constants");
            LogAssert.Expect(LogType.Warning, new Regex("'_LooseFloat' is of Float but was set as Int"));
            shader.SetInt("_LooseFloat", 0x40000000);
            Assert.That(Run(shader, "Loose")[0].x, Is.EqualTo(2));
            Assert.That(Run(shader, "Loose")[0].x, Is.EqualTo(2));
        }

        [Test]
        public void UnknownName_Set_Warns()
        {
            var shader = Load("Constants");
            LogAssert.Expect(LogType.Warning, new Regex("no property '_LoseFloat'"));
            shader.SetFloat("_LoseFloat", 1);
        }

        [Test]
        public void UnpaddedArray_Set_Warns()
        {
            var shader = Load("Constants");
            LogAssert.Expect(LogType.Warning, new Regex("'_Rows' has 48 bytes but 12 were set"));
            shader.SetFloats("_Rows", 1, 2, 3);
            Run(shader, "Named");
        }

        [Test]
        public void ConstantBuffer_BoundAsAWhole_ReplacesNamedValues()
        {
            var shader = Load("Constants");
            var rows = new Vector4[19];
            rows[0] = new Vector4(1, 0, 0, 0); // first column of _Matrix
            rows[4] = new Vector4(2, 0, 0, 0); // _Point
            var buffer = Buffer(rows, GraphicsBuffer.Target.Constant);
            shader.SetVector("_Point", s_Point);
            shader.SetConstantBuffer("Block", buffer, 0, 19 * 16);
            Assert.That(Run(shader, "Named")[0], Is.EqualTo(new Vector4(2, 0, 0, 0)));
        }

        Vector4[] Run(ComputeShader shader, string name)
        {
            var result = Buffer(8, 16);
            var kernel = shader.FindKernel(name);
            shader.SetBuffer(kernel, "_Result", result);
            shader.Dispatch(kernel, 1, 1, 1);
            return Read<Vector4>(result);
        }
    }
}
