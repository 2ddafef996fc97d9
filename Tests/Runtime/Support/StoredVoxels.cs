using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests
{
    /// <summary>Reads what a renderer stores of a volume as if all of it were stored.</summary>
    static class StoredVoxels
    {
        /// <summary>A byte per voxel of the whole volume, 0 beyond what is stored.</summary>
        public static byte[] Whole(byte[] stored, CarvedVolumeRenderer renderer)
        {
            VolumeGeometry geometry = renderer.Volume.Geometry;
            VoxelBox box = renderer.Statistics.StoredVoxels.Value;
            Assert.That(stored.Length, Is.EqualTo(box.VoxelCount));
            var whole = new byte[geometry.VoxelCount];
            int row = box.MaxI - box.MinI + 1, next = 0;
            for (int k = box.MinK; k <= box.MaxK; k++)
                for (int j = box.MinJ; j <= box.MaxJ; j++, next += row)
                    Array.Copy(stored, next, whole, box.MinI + geometry.SizeI * (j + geometry.SizeJ * k), row);
            return whole;
        }
    }
}
