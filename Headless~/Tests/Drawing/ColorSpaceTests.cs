using System;
using AnatomyCarve.Tests;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Drawing
{
    /// <summary>T32: a patch of a known colour, in linear and in gamma projects of both pipelines.</summary>
    public sealed class ColorSpaceTests
    {
        const int Middle = 48 * 96 + 48;

        [Test]
        public void Patch_OfASegment_HasItsColourOnTheScreen([Values] ColorSpaceOfTest space,
            [Values(HostPipeline.BuiltIn, HostPipeline.Universal)] HostPipeline pipeline)
        {
            using var drawn = new DrawnScene(new HostOptions { ColorSpace = (ColorSpace)space, RenderPipeline = pipeline });
            SegmentColor color = ShowPatch(drawn);
            drawn.Draw();
            Color32 pixel = drawn.Drawn(0)[Middle];
            Assert.That(Math.Abs(pixel.r - color.R), Is.LessThanOrEqualTo(1), $"{pixel} is not {color}");
            Assert.That(Math.Abs(pixel.g - color.G), Is.LessThanOrEqualTo(1), $"{pixel} is not {color}");
            Assert.That(Math.Abs(pixel.b - color.B), Is.LessThanOrEqualTo(1), $"{pixel} is not {color}");
            Assert.That(drawn.Errors, Is.Empty);
        }

        /// <summary>The same names as Unity's, without the one that is none.</summary>
        public enum ColorSpaceOfTest
        {
            Gamma = ColorSpace.Gamma,
            Linear = ColorSpace.Linear,
        }

        /// <summary>A cube that is lit by the ambient light alone.</summary>
        static SegmentColor ShowPatch(DrawnScene drawn)
        {
            CarvedVolumeRenderer renderer = drawn.Show(Phantoms.Cube(20, "Patch"));
            renderer.TransferFunction = OpacityTransferFunction.Parse("400:0,600:1");
            (renderer.Light.Ambient, renderer.Light.Diffuse, renderer.Light.Specular) = (1f, 0f, 0f);
            renderer.Quality = RenderQuality.Best();
            return renderer.Segments[1].Color;
        }
    }
}
