using System.Linq;
using AnatomyCarve.Editor;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>Edits of a transfer function's points.</summary>
    sealed class TransferPointsTests
    {
        [Test]
        public void Drag_PastANeighbour_StopsThere()
        {
            TransferPoints points = Of("0:0,100:0.5,200:1");
            points.Drag(1, 500, 0.25);
            Assert.That(Text(points), Is.EqualTo("0:0,200:0.25,200:1"));
            points.Drag(1, -500, 2);
            Assert.That(Text(points), Is.EqualTo("0:0,0:1,200:1"));
        }

        [Test]
        public void Place_PastANeighbour_ChangesTheOrder()
        {
            TransferPoints points = Of("0:0,100:0.5,200:1");
            Assert.That(points.Place(0, 150, 0.25), Is.EqualTo(1));
            Assert.That(Text(points), Is.EqualTo("100:0.5,150:0.25,200:1"));
        }

        [Test]
        public void Add_AtAValueThatIsThere_GoesBehindIt()
        {
            TransferPoints points = Of("0:0,100:0.5,200:1");
            Assert.That(points.Add(100, 0.75), Is.EqualTo(2));
            Assert.That(Text(points), Is.EqualTo("0:0,100:0.5,100:0.75,200:1"));
        }

        [Test]
        public void Remove_OfTheLastPoint_IsRefused()
        {
            TransferPoints points = Of("0:0,100:1");
            Assert.That(points.Remove(0), Is.True);
            Assert.That(points.Remove(0), Is.False);
            Assert.That(Text(points), Is.EqualTo("100:1"));
        }

        [TestCase(-1)]
        [TestCase(2)]
        public void Remove_OfNoPoint_IsRefused(int index) => Assert.That(Of("0:0,100:1").Remove(index), Is.False);

        [TestCase(double.NaN, 0)]
        [TestCase(double.PositiveInfinity, float.MaxValue)]
        public void Value_ThatNoSceneCanHold_BecomesOneThatItCan(double value, double expected)
        {
            TransferPoints points = Of("0:0");
            points.Place(0, value, double.NaN);
            Assert.That(points[0].Value, Is.EqualTo(expected));
            Assert.That(points[0].Opacity, Is.EqualTo(0));
        }

        [Test]
        public void Function_AfterAnEdit_IsAnotherOne()
        {
            TransferPoints points = Of("0:0,100:1");
            OpacityTransferFunction before = points.Function;
            Assert.That(points.Function, Is.SameAs(before));
            points.Drag(0, -10, 0);
            Assert.That(points.Function.OpacityAt(-10), Is.EqualTo(0));
            Assert.That(points.Function.OpacityAt(45), Is.EqualTo(0.5).Within(1e-9));
        }

        [Test]
        public void Points_OfAFunction_AreFloats()
        {
            TransferPoints points = Of("143.556:0.686275");
            Assert.That(points[0].Value, Is.EqualTo(143.556f));
            Assert.That(points[0].Opacity, Is.EqualTo(0.686275f));
        }

        [Test]
        public void Name_OfEachPreset_IsFoundAlsoAfterAScenesFloats()
        {
            foreach (string name in TransferFunctionPresets.Names)
            {
                var points = new TransferPoints();
                points.Set(TransferFunctionPresets.Named(name));
                Assert.That(TransferFunctionNames.Of(points.Function), Is.EqualTo(name));
            }
        }

        [Test]
        public void Name_OfAnotherFunction_IsCustom() => Assert.That(TransferFunctionNames.Of(OpacityTransferFunction.Constant(1)), Is.EqualTo("Custom"));

        [Test]
        public void Name_OfNone_IsAutomatic() => Assert.That(TransferFunctionNames.Of(null), Is.EqualTo("Automatic"));

        static TransferPoints Of(string text)
        {
            var points = new TransferPoints();
            points.Set(OpacityTransferFunction.Parse(text));
            return points;
        }

        static string Text(TransferPoints points) => string.Join(",", points.Points.Select(p => p.ToString()).ToArray());
    }
}
