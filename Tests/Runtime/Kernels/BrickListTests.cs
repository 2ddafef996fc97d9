using System;
using System.Collections.Generic;
using AnatomyCarve.Carving;
using NUnit.Framework;
using UnityEngine;
using Random = System.Random;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>A kernel that gets a list of bricks writes those as a full run does, and no other voxel.</summary>
    public sealed class BrickListTests
    {
        [Test]
        public void ClipVoxels_ListOfBricks_ChangesThoseOnly([Values(0, 1, 3)] int groupsPerRow, [Values(false, true)] bool portable)
        {
            var random = new Random(1);
            CarveScene carve = CarveScene.Opaque(KernelGrid.Aligned(30, 17, 26), 5, random);
            carve.AddRandomSphere(random).Radius = 20;
            Check(KernelRig.ClipVoxels(portable), carve.Grid, random, groupsPerRow, "_OpacityOut", 1, BrickPart.OpacityStep, carve.Bind, rig => rig.SetCounts(0, 1, 5, false));
        }

        [Test]
        public void AntiAlias_ListOfBricks_ChangesThoseOnly([Values(false, true)] bool portable)
        {
            var random = new Random(2);
            KernelGrid grid = KernelGrid.Aligned(30, 17, 26);
            byte[] codes = OpacityFields.Fill(grid, (i, j, k) => random.Next(256));
            Check(KernelRig.AntiAlias(portable), grid, random, 0, "_OpacityAAOut", 1, BrickPart.OpacityStep, rig =>
            {
                rig.Set(grid);
                rig.SetOpacities("_Opacity", grid, codes);
                rig.Set("_AntiAlias", new Vector4(0, 0, 0, 1));
            }, rig => rig.Set("_AntiAlias", Vector4.zero));
        }

        [Test]
        public void SobelNormals_ListOfBricks_ChangesThoseOnly([Values(false, true)] bool portable)
        {
            var random = new Random(3);
            KernelGrid grid = KernelGrid.Aligned(30, 17, 26);
            byte[] codes = OpacityFields.Fill(grid, (i, j, k) => random.Next(256));
            Check(KernelRig.SobelNormals(portable), grid, random, 0, "_NormalsOut", 2, BrickPart.NormalsStep, rig =>
            {
                rig.Set(grid);
                rig.SetUncarved(grid);
                rig.SetOpacities("_OpacityAA", grid, codes);
            }, rig => rig.SetOpacities("_OpacityAA", grid, new byte[grid.VoxelCount]));
        }

        /// <summary>Whole bricks, nothing, and places of each strip's columns in steps; strips of a quarter share theirs where steps are of four voxels.</summary>
        static uint RandomPart(Random random, int step)
        {
            if (random.Next(4) == 0)
                return KernelRig.WholeBrick;
            uint part = 0;
            for (int strip = 0; strip < BrickPart.Strips; strip += step / BrickPart.StripRows)
            {
                int a = step * random.Next(8 / step + 1), b = step * random.Next(8 / step + 1);
                if (a == b)
                    continue;
                uint places = (uint)(3 - Math.Min(a, b) / 2 | (Math.Max(a, b) / 2 - 1) << 2);
                part |= (step == BrickPart.OpacityStep ? 17 * places : places) << (4 * strip);
            }
            return part;
        }

        static bool IsIn(uint part, int i, int j, int k)
        {
            int places = (int)(part >> (4 * (j / 2 % 2 + 2 * (i / 4) + 4 * (j / 4))));
            return k >= 6 - 2 * (places & 3) && k < 2 + 2 * (places >> 2 & 3);
        }

        /// <param name="step">Voxels along k that the kernel computes together.</param>
        /// <param name="prepare">Sets what the kernel reads.</param>
        /// <param name="change">Changes it, so that a second run over a list of bricks differs from the first.</param>
        static void Check(
            KernelRig rig, KernelGrid grid, Random random, int groupsPerRow, string target, int bytesPerVoxel, int step,
            Action<KernelRig> prepare, Action<KernelRig> change)
        {
            using (rig)
            {
                prepare(rig);
                RenderTexture texture = rig.BytesTarget(target, grid, bytesPerVoxel);
                rig.DispatchBricks(grid);
                byte[] before = rig.ReadBytes(texture, grid, bytesPerVoxel);
                change(rig);
                rig.DispatchBricks(grid);
                byte[] changed = rig.ReadBytes(texture, grid, bytesPerVoxel);
                prepare(rig);
                rig.DispatchBricks(grid);
                Assert.That(rig.ReadBytes(texture, grid, bytesPerVoxel), Is.EqualTo(before), "the same input twice");
                change(rig);
                uint[] bricks = Array.FindAll(grid.AllBricks(), brick => random.Next(2) == 0);
                uint[] parts = Array.ConvertAll(bricks, brick => RandomPart(random, step));
                rig.DispatchBricks(grid, bricks, groupsPerRow, parts);
                byte[] after = rig.ReadBytes(texture, grid, bytesPerVoxel);
                var listed = new Dictionary<uint, uint>();
                for (int n = 0; n < bricks.Length; n++)
                    listed.Add(bricks[n], parts[n]);
                int wrong = 0, different = 0;
                grid.ForEach((i, j, k) =>
                {
                    bool inList = listed.TryGetValue((uint)(i / 8) | (uint)(j / 8) << 10 | (uint)(k / 8) << 20, out uint part) && IsIn(part, i % 8, j % 8, k % 8);
                    for (int b = 0; b < bytesPerVoxel; b++)
                    {
                        int at = bytesPerVoxel * grid.Index(i, j, k) + b;
                        different += changed[at] != before[at] ? 1 : 0;
                        wrong += after[at] != (inList ? changed[at] : before[at]) ? 1 : 0;
                    }
                });
                Assert.That(bricks, Is.Not.Empty);
                Assert.That(different, Is.GreaterThan(0), "bytes that the change changes");
                Assert.That(wrong, Is.EqualTo(0), "bytes");
            }
        }
    }
}
