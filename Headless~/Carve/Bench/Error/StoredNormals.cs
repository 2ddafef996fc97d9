using System;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Phantoms;
using AnatomyCarve.Volumes;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// P16: what storing a normal costs. Each brick of a volume holds a linear field in R32, whose gradient every symmetric filter gets right; the normal in
    /// its middle, as the kernel SobelNormals stores it, is off by its two bytes and nothing else.
    /// </summary>
    sealed class StoredNormals : IMeasure
    {
        const int BrickSize = 8, Bricks = 16, Size = BrickSize * Bricks, Middle = 4;
        const float Slope = 0.06f; // opacity per voxel; within 0..1 over a brick in every direction

        public Quantity Quantity { get; } = new("P16", "stored normal's error, mean and largest", "degrees", [0.35, 1.0]);

        public Outcome Run(MeasureContext context)
        {
            var geometry = Grids.Centred(Size, Size, Size);
            var random = new Random(16);
            var directions = Enumerable.Range(0, Bricks * Bricks * Bricks).Select(_ => Grids.RandomDirection(random)).ToArray();
            var opacities = new float[geometry.VoxelCount];
            Grids.ForEach(geometry, (i, j, k, voxel) =>
            {
                var d = directions[Brick(i, j, k)];
                opacities[voxel] = (float)(0.5 - Slope * (d.X * Offset(i) + d.Y * Offset(j) + d.Z * Offset(k)));
            });
            using var kernel = LoneKernel.SobelNormals(geometry);
            kernel.SetVolume("_Opacity", GraphicsFormat.R32_SFloat, opacities);
            kernel.SetVolume("_OpacityAA", GraphicsFormat.R32_SFloat, opacities);
            var target = kernel.VolumeTarget("_NormalsOut", GraphicsFormat.R8G8_UNorm);
            kernel.RunOverVolume();
            var codes = Texels.Read<byte>(target);
            var errors = new AngleErrors();
            Grids.ForEach(geometry, (i, j, k, voxel) =>
            {
                if (i % BrickSize == Middle && j % BrickSize == Middle && k % BrickSize == Middle)
                {
                    errors.Add(Octahedral.Decode(codes[2 * voxel], codes[2 * voxel + 1]), directions[Brick(i, j, k)]);
                }
            });
            return new Outcome([errors.Mean, errors.Max], "linear fields", new JsonObject { ["directions"] = directions.Length, ["slopePerVoxel"] = Slope });
        }

        static int Brick(int i, int j, int k) => i / BrickSize + Bricks * (j / BrickSize + Bricks * (k / BrickSize));

        static int Offset(int index) => index % BrickSize - Middle;
    }
}
