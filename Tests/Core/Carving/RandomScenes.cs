using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Carving
{
    /// <summary>Small random volumes and carvings for laws that have to hold for all of them. The seed is printed, so that a failure can be repeated.</summary>
    sealed class RandomScenes
    {
        readonly Random random;

        public RandomScenes(int seed)
        {
            random = new Random(seed);
            TestContext.WriteLine(FormattableString.Invariant($"seed {seed}"));
        }

        public int Next(int below) => random.Next(below);

        public int Between(int first, int last) => random.Next(first, last + 1);

        public double Between(double low, double high) => low + (high - low) * random.NextDouble();

        public bool Chance(double probability) => random.NextDouble() < probability;

        /// <summary>A grid of up to the given number of voxels per axis: any rotation, spacings 0.3 to 3 mm, now and then sheared or mirrored.</summary>
        public VolumeGeometry Geometry(int maxSize)
        {
            VectorMm a = Direction();
            VectorMm b = a.Cross(Direction()).Normalized();
            VectorMm c = a.Cross(b);
            if (Chance(0.5))
                c = -c;
            if (Chance(0.2))
                b = (b + Between(-0.5, 0.5) * a).Normalized();
            var origin = new PointMm(Between(-300, 300), Between(-300, 300), Between(-300, 300));
            return new VolumeGeometry(
                Between(1, maxSize), Between(1, maxSize), Between(1, maxSize),
                Affine.FromColumns(Between(0.3, 3) * a, Between(0.3, 3) * b, Between(0.3, 3) * c, origin));
        }

        /// <summary>A volume with random intensities 0..100 and random segments, coarse enough that neighbours often agree.</summary>
        public SegmentedVolume Volume(int maxSize, int segmentCount)
        {
            VolumeGeometry geometry = Geometry(maxSize);
            var codes = new ushort[geometry.VoxelCount];
            var labels = new ushort[geometry.VoxelCount];
            int period = Between(1, 4);
            for (int v = 0; v < codes.Length; v++)
            {
                codes[v] = (ushort)(v % period == 0 || v == 0 ? Next(101) : codes[v - 1]);
                labels[v] = (ushort)(v % period == 0 || v == 0 ? Next(segmentCount) : labels[v - 1]);
            }
            return Phantoms.Of(geometry, codes, labels, segmentCount);
        }

        public SegmentMask Mask(int segmentCount)
        {
            double share = Chance(0.2) ? 1 : Chance(0.1) ? 0 : Between(0.0, 1.0);
            return SegmentMask.FromIndices(segmentCount, Enumerable.Range(0, segmentCount).Where(_ => Chance(share)));
        }

        /// <summary>A sphere that often meets the volume.</summary>
        public ClipSphere Sphere(VolumeGeometry geometry, int segmentCount)
        {
            PointMm centre = geometry.IjkToLps.TransformPoint(new PointMm(
                Between(-3.0, geometry.SizeI + 2), Between(-3.0, geometry.SizeJ + 2), Between(-3.0, geometry.SizeK + 2)));
            double largest = geometry.SpacingMm.Length * Math.Max(geometry.SizeI, Math.Max(geometry.SizeJ, geometry.SizeK));
            return new ClipSphere(centre, Chance(0.05) ? 0 : Between(0, 0.6 * largest), Mask(segmentCount));
        }

        public List<ClipSphere> Spheres(VolumeGeometry geometry, int segmentCount, int max) =>
            Enumerable.Range(0, Next(max + 1)).Select(_ => Sphere(geometry, segmentCount)).ToList();

        public VectorMm Direction()
        {
            while (true)
            {
                var direction = new VectorMm(Between(-1.0, 1.0), Between(-1.0, 1.0), Between(-1.0, 1.0));
                if (direction.Length > 0.1 && direction.Length < 1)
                    return direction.Normalized();
            }
        }

        public List<T> Shuffled<T>(IEnumerable<T> items) => items.OrderBy(_ => random.Next()).ToList();
    }
}
