using System;
using System.Globalization;
using System.Linq;
using System.Threading;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Volumes
{
    public sealed class OpacityTransferFunctionTests
    {
        [TestCase(-2000, 0)]
        [TestCase(-1000, 0)]
        [TestCase(150, 0)]
        [TestCase(225, 0.1)]
        [TestCase(300, 0.2)]
        [TestCase(1000, 0.7)]
        [TestCase(5000, 0.7)]
        public void OpacityAt_IsLinearBetweenPointsAndConstantOutside(double value, double opacity)
        {
            OpacityTransferFunction function = OpacityTransferFunction.Parse("-1000:0,150:0,300:0.2,1000:0.7");
            Assert.That(function.OpacityAt(value), Is.EqualTo(opacity).Within(1e-12));
        }

        [Test]
        public void PointsOfOneValue_MakeAStep()
        {
            OpacityTransferFunction function = OpacityTransferFunction.Parse("0:0,100:0.1,100:0.9,200:1");
            Assert.That(function.OpacityAt(100), Is.EqualTo(0.1));
            Assert.That(function.OpacityAt(100.000001), Is.EqualTo(0.9).Within(1e-6));
        }

        [TestCase("0:0,300:0,300:1")]
        [TestCase("300:0,300:1")]
        [TestCase("300:1,300:0")]
        [TestCase("0:0,300:0.2,300:0.9")]
        [TestCase("300:1,300:0,2000:0")]
        [TestCase("0:0,0:1")]
        [TestCase("-900:0.5,-900:0")]
        public void Step_AtAnEnd_IsThatOfTheLookupToo(string text)
        {
            OpacityTransferFunction function = OpacityTransferFunction.Parse(text);
            var ct = new IntensityVolume(new VolumeGeometry(1, 1, 1, Affine.Identity), new ushort[1], -1024, 1, 3000);
            var lookup = new OpacityLookup(function, ct);
            foreach (double value in new double[] { -1024, -901, -900, -899, -1, 0, 1, 150, 299, 300, 301, 500, 2500 })
                Assert.That(lookup.OpacityOf((ushort)(value + 1024)), Is.EqualTo(function.OpacityAt(value)).Within(0.02), $"{value}");
        }

        [Test]
        public void Points_InAnyOrder_AreSortedByValue()
        {
            Assert.That(OpacityTransferFunction.Parse("5:1,-3:0.5").ToString(), Is.EqualTo("-3:0.5,5:1"));
        }

        [Test]
        public void Lookup_HoldsTheFunctionAtEvenSteps()
        {
            OpacityTransferFunction function = OpacityTransferFunction.Parse("-1000:0,150:0,300:0.2,3000:0.8");
            float[] table = function.Lookup();
            Assert.That(table, Has.Length.EqualTo(OpacityTransferFunction.LookupSize));
            Assert.That(table[0], Is.EqualTo(0f));
            Assert.That(table[OpacityTransferFunction.LookupSize - 1], Is.EqualTo(0.8f));
            Assert.That(table[2048], Is.EqualTo((float)function.OpacityAt(-1000 + (4000.0 * 2048 / 4095))));
        }

        [Test]
        public void Constant_IsTheSameEverywhere()
        {
            OpacityTransferFunction function = OpacityTransferFunction.Constant(0.3);
            Assert.That(function.LookupMin, Is.EqualTo(function.LookupMax));
            Assert.That(new[] { -1e9, 0, 1e9, double.NaN }.Select(function.OpacityAt), Is.All.EqualTo(0.3));
            Assert.That(function.Lookup(), Is.All.EqualTo(0.3f));
        }

        [TestCase("")]
        [TestCase("1")]
        [TestCase("1:2:3")]
        [TestCase("1:0.5,")]
        [TestCase("a:0.5")]
        [TestCase("1:1.5")]
        [TestCase("1:-0.1")]
        [TestCase("nan:0.5")]
        public void Parse_OfBadText_SaysWhatIsWrong(string text)
        {
            var refusal = Assert.Throws<AnatomyCarveException>(() => OpacityTransferFunction.Parse(text));
            Assert.That(refusal.Message, Does.Contain("transfer function"));
        }

        [Test]
        public void Parse_UnderACultureWithDecimalComma_ReadsPoints()
        {
            CultureInfo before = Thread.CurrentThread.CurrentCulture;
            try
            {
                Thread.CurrentThread.CurrentCulture = new CultureInfo("de-DE");
                OpacityTransferFunction function = OpacityTransferFunction.Parse("-0.5:0.25,1.5:0.75");
                Assert.That(function.OpacityAt(0.5), Is.EqualTo(0.5));
                Assert.That(function.ToString(), Is.EqualTo("-0.5:0.25,1.5:0.75"));
            }
            finally
            {
                Thread.CurrentThread.CurrentCulture = before;
            }
        }

        [Test]
        public void Automatic_ForCt_ShowsSoftTissueAndNotAir()
        {
            OpacityTransferFunction function = OpacityTransferFunction.Automatic(Scan(-1024, -1000, -700, -100, 40, 1500));
            Assert.That(new[] { -1000.0, -700, -400 }.Select(function.OpacityAt), Is.All.EqualTo(0));
            Assert.That(new[] { -100.0, 0, 40, 1500 }.Select(function.OpacityAt), Is.All.EqualTo(1));
        }

        [Test]
        public void Automatic_ForMr_ShowsTissueAndNotTheNoiseAroundIt()
        {
            var random = new Random(5);
            short[] values = Enumerable.Range(0, 20000)
                .Select(n => (short)(n % 2 == 0 ? random.Next(0, 12) : random.Next(180, 320))).ToArray();
            OpacityTransferFunction function = OpacityTransferFunction.Automatic(Scan(values));
            Assert.That(new[] { 0.0, 6, 12 }.Select(function.OpacityAt), Is.All.LessThan(0.01));
            Assert.That(new[] { 180.0, 250, 320 }.Select(function.OpacityAt), Is.All.GreaterThan(0.99));
        }

        [Test]
        public void Automatic_ForMrWithAFewNegativeValues_IsNotThatOfCt()
        {
            short[] values = Enumerable.Range(0, 20000).Select(n => (short)(n == 0 ? -610 : n % 2 == 0 ? 100 : 9000)).ToArray();
            Assert.That(OpacityTransferFunction.Automatic(Scan(values)).OpacityAt(100), Is.LessThan(0.01));
        }

        [Test]
        public void Automatic_ForAConstantScan_IsOpaque()
        {
            Assert.That(OpacityTransferFunction.Automatic(Scan(7, 7)).OpacityAt(7), Is.EqualTo(1));
        }

        static IntensityVolume Scan(params short[] values) =>
            IntensityVolume.FromVolumeData(new VolumeData(new VolumeGeometry(values.Length, 1, 1, Affine.Identity), values));
    }
}
