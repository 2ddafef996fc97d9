using AnatomyCarve.Editor;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>The parts of the verification that need no Editor.</summary>
    sealed class VerificationTests
    {
        static readonly Color32 Black = new Color32(0, 0, 0, 255), White = new Color32(255, 255, 255, 255), Grey = new Color32(51, 51, 51, 255);
        static readonly string[] Arguments = { "Unity", "-batchmode", "-anatomycarveOutput", "a", "-anatomycarveoutput", "b", "-anatomycarveScene" };

        [Test]
        public void Value_OfAnOptionGivenTwice_IsTheLast() => Assert.That(CommandLineArguments.Value(Arguments, "-anatomycarveOutput"), Is.EqualTo("b"));

        [Test]
        public void Value_OfAnOptionThatIsNotGiven_IsNull() => Assert.That(CommandLineArguments.Value(Arguments, "-other"), Is.Null);

        [TestCase("-anatomycarveScene")]
        [TestCase("Unity")]
        public void Value_ThatIsMissing_IsRefused(string option) =>
            Assert.That(() => CommandLineArguments.Value(Arguments, option), Throws.ArgumentException.With.Message.Contain(option));

        [Test]
        public void Check_CountsOnlyPixelsWithASegment()
        {
            ushort none = PictureData.NoSegment;
            var check = new PictureCheck(new[] { White, Grey, White }, new[] { White, White, Black }, new ushort[] { 3, 4, none }, Black);
            Assert.That(check.Covered, Is.EqualTo(2));
            Assert.That(check.DifferenceFromKernel, Is.EqualTo(0.4f).Within(1e-6f));
            Assert.That(check.DifferenceFromBackground, Is.EqualTo(0.6f).Within(1e-6f));
        }

        [Test]
        public void Check_WithoutSegments_IsZero()
        {
            var check = new PictureCheck(new[] { White }, new[] { Black }, new[] { PictureData.NoSegment }, Black);
            Assert.That(check.Covered, Is.Zero);
            Assert.That(check.DifferenceFromKernel, Is.Zero);
        }

        [Test]
        public void Check_OfPicturesOfOtherSizes_IsRefused() =>
            Assert.That(() => new PictureCheck(new Color32[2], new Color32[1], new ushort[1], Black), Throws.ArgumentException);
    }
}
