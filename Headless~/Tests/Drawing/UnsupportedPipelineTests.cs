using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Drawing
{
    /// <summary>A render pipeline that the eye shader is not made for: said once, and pictures on demand still work.</summary>
    public sealed class UnsupportedPipelineTests
    {
        [TestCase(HostPipeline.HighDefinition)]
        [TestCase(HostPipeline.Other)]
        public void Draw_InAnUnknownPipeline_SaysSoOnce_AndRendersOnDemand(HostPipeline pipeline)
        {
            using var drawn = new DrawnScene(new HostOptions { RenderPipeline = pipeline });
            drawn.ShowMarkers();
            for (int frame = 0; frame < 3; frame++)
            {
                drawn.Step();
                drawn.Draw();
            }
            Assert.That(drawn.Errors, Has.Count.EqualTo(1));
            Assert.That(drawn.Errors[0], Does.Contain("not supported").And.Contain("Universal").And.Contain("Render"));
            Assert.That(drawn.Renderer.Problem, Does.Contain("not supported"));
            Assert.That(drawn.Renderer.Statistics.VolumeDispatches, Is.Zero, "nobody draws it, so nothing is computed");
            Assert.That(drawn.Renderer.Statistics.BytesResident, Is.Zero, "nor taken to the GPU");
            Assert.That(drawn.Kernel(0).Segments, Has.Some.LessThan(PictureData.NoSegment));
        }

        [TestCase(HostPipeline.BuiltIn)]
        [TestCase(HostPipeline.Universal)]
        public void Draw_InAKnownPipeline_SaysNothing(HostPipeline pipeline)
        {
            using var drawn = new DrawnScene(new HostOptions { RenderPipeline = pipeline });
            drawn.ShowMarkers();
            drawn.Draw();
            Assert.That(drawn.Renderer.Problem, Is.Null);
            Assert.That(drawn.Errors, Is.Empty);
        }
    }
}
