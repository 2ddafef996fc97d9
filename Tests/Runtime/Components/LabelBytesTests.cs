using System;
using System.Linq;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>Labels in 8 bits are the indices in 16.</summary>
    sealed class LabelBytesTests
    {
        [TestCase(0)]
        [TestCase(1)]
        [TestCase(3)]
        [TestCase(4)]
        [TestCase(257)]
        [TestCase(4098)]
        public void Narrow_OfAnyLength_KeepsEveryIndex(int length)
        {
            var random = new System.Random(length);
            ushort[] indices = Enumerable.Range(0, length).Select(v => (ushort)random.Next(256)).ToArray();
            var labels = new byte[length + 1];
            LabelBytes.Narrow(indices, labels.AsSpan(0, length));
            Assert.That(labels.Take(length).Select(b => (ushort)b), Is.EqualTo(indices));
            Assert.That(labels[length], Is.Zero);
        }
    }
}
