using System;
using System.Linq;
using AnatomyCarve.Carving;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Carving
{
    /// <summary>Parts of bricks: what they hold, how many voxels, and in which packing.</summary>
    public sealed class BrickPartTests
    {
        [Test]
        public void With_PlacesOfStrips_RoundsOutwardsToSteps()
        {
            BrickPart part = BrickPart.None.With(0, 1, 4, BrickPart.NormalsStep).With(7, 3, 3, BrickPart.OpacityStep).With(2, 5, 2, BrickPart.OpacityStep);
            Assert.That(part.Packed, Is.EqualTo(0x7000000Bu));
            Assert.That(Enumerable.Range(0, 8).Where(k => part.Holds(3, 1, k)), Is.EqualTo(new[] { 0, 1, 2, 3, 4, 5 }));
            Assert.That(Enumerable.Range(0, 8).Where(k => part.Holds(4, 6, k)), Is.EqualTo(new[] { 0, 1, 2, 3 }));
            Assert.That(part.Holds(3, 2, 3) || part.Holds(4, 0, 3) || part.Holds(4, 5, 3) || part.Holds(3, 6, 3), Is.False);
            Assert.That(part.With(7, 1, 0, BrickPart.OpacityStep).Packed, Is.EqualTo(0xBu));
        }

        [Test]
        public void VoxelsIn_BricksAtTheBorder_CountsWhatHoldsSays()
        {
            var random = new Random(7);
            for (int n = 0; n < 200; n++)
            {
                BrickPart part = n == 0 ? BrickPart.Whole : BrickPart.None;
                for (int strip = 0; n > 0 && strip < BrickPart.Strips; strip++)
                    part = part.With(strip, random.Next(8), random.Next(8), BrickPart.NormalsStep);
                int sizeI = random.Next(1, 9), sizeJ = random.Next(1, 9), sizeK = random.Next(1, 9), expected = 0;
                for (int k = 0; k < sizeK; k++)
                    for (int j = 0; j < sizeJ; j++)
                        for (int i = 0; i < sizeI; i++)
                            expected += part.Holds(i, j, k) ? 1 : 0;
                VoxelBox box = new VoxelBox { MinI = 8, MinJ = 16, MinK = 24, MaxI = 7 + sizeI, MaxJ = 15 + sizeJ, MaxK = 23 + sizeK };
                Assert.That(part.VoxelsIn(box), Is.EqualTo(expected), $"{part.Packed:x8} of {sizeI} x {sizeJ} x {sizeK}");
            }
        }

        [Test]
        public void With_WhatDoesNotExist_IsRefused()
        {
            Assert.That(() => BrickPart.None.With(8, 0, 1, 4), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => BrickPart.None.With(0, 0, 8, 4), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => BrickPart.None.With(0, 0, 1, 3), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }
    }
}
