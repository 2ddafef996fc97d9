using System.Linq;
using AnatomyCarve.Editor;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>Coordinates of the transfer function's plot.</summary>
    sealed class TransferFunctionPlotTests
    {
        const float M = TransferFunctionPlot.Margin;
        static readonly Rect Area = new Rect(20f, 100f, 200f + 2f * M, 80f + 2f * M);
        static readonly TransferFunctionPlot Plot = new TransferFunctionPlot(Area, new ValueWindow(-1000, 1000));

        [TestCase(-1000, 0, 20f + M, 180f + M)]
        [TestCase(1000, 1, 220f + M, 100f + M)]
        [TestCase(0, 0.5, 120f + M, 140f + M)]
        public void Points_OfAPlot_LieWhereValueAndOpacitySay(double value, double opacity, float x, float y)
        {
            Vector2 pixels = Plot.ToPixels(value, opacity);
            Assert.That(pixels.x, Is.EqualTo(x).Within(1e-3f));
            Assert.That(pixels.y, Is.EqualTo(y).Within(1e-3f));
        }

        [Test]
        public void Pixels_OfAPoint_GiveItsValueAndOpacityBack([Values(-1000, -312.5, 0, 999)] double value, [Values(0, 0.125, 1)] double opacity)
        {
            Vector2 pixels = Plot.ToPixels(value, opacity);
            Assert.That(Plot.ValueAt(pixels.x), Is.EqualTo(value).Within(1e-2));
            Assert.That(Plot.OpacityAt(pixels.y), Is.EqualTo(opacity).Within(1e-4));
        }

        [Test]
        public void Opacity_AboveAndBelowThePlot_IsClamped()
        {
            Assert.That(Plot.OpacityAt(0f), Is.EqualTo(1));
            Assert.That(Plot.OpacityAt(1000f), Is.EqualTo(0));
        }

        [Test]
        public void Steps_OfAPixel_AreTheWindowsShare()
        {
            Assert.That(Plot.ValuePerPixel, Is.EqualTo(10).Within(1e-9));
            Assert.That(Plot.OpacityPerPixel, Is.EqualTo(1.0 / 80).Within(1e-9));
        }

        [Test]
        public void HitTest_BesideTwoPoints_FindsTheNearer()
        {
            TransferPoint[] points = Points("0:0.5,50:0.5,900:1");
            Assert.That(Plot.HitTest(points, Plot.ToPixels(20, 0.5)), Is.EqualTo(0));
            Assert.That(Plot.HitTest(points, Plot.ToPixels(30, 0.5)), Is.EqualTo(1));
        }

        [Test]
        public void HitTest_FarFromAllPoints_FindsNone() => Assert.That(Plot.HitTest(Points("0:0.5,900:1"), Plot.ToPixels(-500, 0.5)), Is.EqualTo(-1));

        [Test]
        public void HitTest_PointOutsideTheWindow_IsNotFound()
        {
            var zoomed = new TransferFunctionPlot(Area, new ValueWindow(0, 10));
            Assert.That(zoomed.HitTest(Points("-5:0.5"), new Vector2(zoomed.XOf(-5), zoomed.YOf(0.5))), Is.EqualTo(-1));
        }

        [Test]
        public void Line_OfAFunction_GoesFromEdgeToEdgeThroughThePointsInside()
        {
            Vector3[] line = null;
            int count = Plot.Line(OpacityTransferFunction.Parse("-3000:0,0:0.5,5000:1"), ref line);
            Assert.That(count, Is.EqualTo(3));
            Assert.That(line[0].x, Is.EqualTo(Area.xMin));
            Assert.That((Vector2)line[1], Is.EqualTo(Plot.ToPixels(0, 0.5)));
            Assert.That(line[2].x, Is.EqualTo(Area.xMax));
            Assert.That(Plot.OpacityAt(line[0].y), Is.EqualTo(0.5 * (3000 + Plot.ValueAt(Area.xMin)) / 3000).Within(1e-4));
        }

        [Test]
        public void Line_OfAnotherFunction_UsesTheSameArray()
        {
            Vector3[] line = null;
            Plot.Line(OpacityTransferFunction.Parse("0:0,1:1,2:0,3:1"), ref line);
            Vector3[] before = line;
            Assert.That(Plot.Line(OpacityTransferFunction.Parse("0:0,1:1"), ref line), Is.EqualTo(4));
            Assert.That(line, Is.SameAs(before));
        }

        static TransferPoint[] Points(string text) => OpacityTransferFunction.Parse(text).Points.ToArray();
    }
}
