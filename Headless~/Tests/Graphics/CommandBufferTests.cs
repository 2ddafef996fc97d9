using System;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    public sealed class CommandBufferTests : GpuTest
    {
        [Test]
        public void Recorded_RunsOnlyWhenExecuted_AndEachTime()
        {
            var shader = Load("Buffers");
            var kernel = shader.FindKernel("Grid");
            var words = Buffer(new uint[] { 0 });
            using var commands = new CommandBuffer { name = "count" };
            commands.BeginSample("stage");
            commands.SetComputeBufferParam(shader, kernel, "_Words", words);
            commands.DispatchCompute(shader, kernel, 2, 1, 1);
            commands.EndSample("stage");
            Assert.That(Read<uint>(words)[0], Is.Zero);
            UnityEngine.Graphics.ExecuteCommandBuffer(commands);
            UnityEngine.Graphics.ExecuteCommandBuffer(commands);
            Assert.That(Read<uint>(words)[0], Is.EqualTo(4));
            commands.Clear();
            UnityEngine.Graphics.ExecuteCommandBuffer(commands);
            Assert.That(Read<uint>(words)[0], Is.EqualTo(4));
        }

        [Test]
        public void Values_AreCapturedWhenRecorded_AndStayOnTheShader()
        {
            var shader = Load("Constants");
            var kernel = shader.FindKernel("Loose");
            var result = Buffer(8, 16);
            var values = new[] { 3 };
            using var commands = new CommandBuffer();
            commands.SetComputeFloatParam(shader, "_LooseFloat", 2);
            commands.SetComputeIntParams(shader, "_LooseInt", values);
            commands.SetComputeBufferParam(shader, kernel, "_Result", result);
            commands.DispatchCompute(shader, kernel, 1, 1, 1);
            values[0] = 99;
            UnityEngine.Graphics.ExecuteCommandBuffer(commands);
            Assert.That(Read<Vector4>(result)[0], Is.EqualTo(new Vector4(2, 3, 0, 0)));
            shader.Dispatch(kernel, 1, 1, 1);
            Assert.That(Read<Vector4>(result)[0], Is.EqualTo(new Vector4(2, 3, 0, 0)));
        }

        [Test]
        public void Samples_ThatDoNotNest_LogAnError()
        {
            using var commands = new CommandBuffer();
            commands.BeginSample("a");
            LogAssert.Expect(LogType.Error, new Regex("EndSample of 'b' does not match"));
            commands.EndSample("b");
        }

        [Test]
        public void Null_Executed_IsRefused() => Assert.Throws<ArgumentNullException>(() => UnityEngine.Graphics.ExecuteCommandBuffer(null));
    }
}
