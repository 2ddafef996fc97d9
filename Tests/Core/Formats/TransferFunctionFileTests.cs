using System.IO;
using System.Text;
using AnatomyCarve.Formats;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Formats
{
    public sealed class TransferFunctionFileTests
    {
        [Test]
        public void Example_HasItsScalarOpacities()
        {
            OpacityTransferFunction function = TransferFunctionFile.Read(SharedData.PathOf("tables/example.vp"));
            Assert.That(function.ToString(), Is.EqualTo("-1000:0,150:0,300:0.2,1000:0.7,3000:0.8"));
        }

        [Test]
        public void WindowsLineEnds_AreRead()
        {
            OpacityTransferFunction function = Read("1\r\n1\r\n0.9\r\n0.1\r\n0.2\r\n10\r\n4 -10.5 0 20 1\r\n4 0 1 255 1\r\n4 0 0 0 0\r\n");
            Assert.That(function.ToString(), Is.EqualTo("-10.5:0,20:1"));
        }

        [TestCase("")]
        [TestCase("1\n1\n1\n1\n1\n1\n\n")]
        [TestCase("1\n1\n1\n1\n1\n1\n3 0 0 1\n")]
        [TestCase("1\n1\n1\n1\n1\n1\n4 0 0 1\n")]
        [TestCase("1\n1\n1\n1\n1\n1\n4 0 0 1 1.5\n")]
        [TestCase("1\n1\n1\n1\n1\n1\n4 0 0 x 1\n")]
        [TestCase("1\n1\n1\n1\n1\n1\n4 0 0 nan 1\n")]
        public void BadText_IsRefused(string text)
        {
            Assert.That(() => Read(text), Throws.TypeOf<VolumeFormatException>());
        }

        static OpacityTransferFunction Read(string text) => TransferFunctionFile.Read(new MemoryStream(Encoding.UTF8.GetBytes(text)), "test.vp");
    }
}
