using System;
using AnatomyCarve.Editor;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>What a plot shows of its values.</summary>
    sealed class ValueWindowTests
    {
        static readonly ValueWindow Widest = new ValueWindow(-1000, 3000);

        [Test]
        public void Zoom_AroundAValue_LeavesItWhereItIs()
        {
            ValueWindow zoomed = Widest.Zoomed(0.5, 200, Widest);
            Assert.That(zoomed.Width, Is.EqualTo(2000).Within(1e-9));
            Assert.That(zoomed.FractionOf(200), Is.EqualTo(Widest.FractionOf(200)).Within(1e-12));
        }

        [Test]
        public void Zoom_Outwards_EndsAtTheWidest() => Assert.That(new ValueWindow(0, 100).Zoomed(1000, 50, Widest), Is.EqualTo(Widest));

        [Test]
        public void Zoom_Inwards_KeepsAWidth()
        {
            ValueWindow window = Widest;
            for (int n = 0; n < 1000; n++)
                window = window.Zoomed(0.8, 42, Widest);
            Assert.That(window.Width, Is.EqualTo(Widest.Width / 10000).Within(1e-9));
            Assert.That(window.Min, Is.LessThanOrEqualTo(42));
            Assert.That(window.Max, Is.GreaterThanOrEqualTo(42));
        }

        [TestCase(100, 100, 1100)]
        [TestCase(1e6, 2000, 3000)]
        [TestCase(-1e6, -1000, 0)]
        public void Pan_ByAValue_StopsAtTheWidest(double by, double min, double max) =>
            Assert.That(new ValueWindow(0, 1000).Panned(by, Widest), Is.EqualTo(new ValueWindow(min, max)));

        [Test]
        public void Window_WithoutExtent_IsWidened() => Assert.That(new ValueWindow(7, 7), Is.EqualTo(new ValueWindow(6.5, 7.5)));

        [TestCase(1, 0)]
        [TestCase(double.NaN, 1)]
        [TestCase(0, double.PositiveInfinity)]
        public void Window_ThatIsNoRange_IsRefused(double min, double max) => Assert.That(() => new ValueWindow(min, max), Throws.ArgumentException);

        [Test]
        public void Union_OfTwoWindows_HoldsBoth() =>
            Assert.That(new ValueWindow(0, 10).United(new ValueWindow(-5, 3)), Is.EqualTo(new ValueWindow(-5, 10)));

        [Test]
        public void Margin_OnBothSides_IsAShareOfTheWidth() => Assert.That(new ValueWindow(0, 100).WithMargin(0.05), Is.EqualTo(new ValueWindow(-5, 105)));

        [Test]
        public void Fraction_OfAValue_GivesItBack([Values(-1000, 0, 2999.5)] double value) =>
            Assert.That(Widest.ValueAt(Widest.FractionOf(value)), Is.EqualTo(value).Within(1e-9));
    }
}
