using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>Everything that ClipVoxels reads, as plain arrays.</summary>
    sealed class CarveScene
    {
        public const int LookupSize = 4096;

        /// <summary>A clip sphere in centred mm with its mask.</summary>
        public sealed class Sphere
        {
            public float X, Y, Z, Radius;
            public bool[] Clips;
        }

        public KernelGrid Grid { get; private set; }

        public ushort[] Intensities { get; private set; }

        public ushort[] Labels { get; private set; }

        public int SegmentCount { get; private set; }

        public List<Sphere> Spheres { get; } = new List<Sphere>();

        public float[] SegmentOpacities { get; private set; }

        public float[] Lookup { get; private set; }

        /// <summary>Entry of the lookup = saturate(code * scale + offset) * (size - 1).</summary>
        public float LookupScale { get; set; } = 1f / 65535f;

        public float LookupOffset { get; set; }

        public bool SmoothCut { get; set; }

        /// <summary>Everything opaque, every voxel of a random segment.</summary>
        public static CarveScene Opaque(KernelGrid grid, int segmentCount, System.Random random)
        {
            var scene = new CarveScene
            {
                Grid = grid,
                SegmentCount = segmentCount,
                Intensities = new ushort[grid.VoxelCount],
                Labels = new ushort[grid.VoxelCount],
                SegmentOpacities = new float[segmentCount],
                Lookup = new float[LookupSize],
            };
            for (int v = 0; v < grid.VoxelCount; v++)
            {
                scene.Intensities[v] = (ushort)random.Next(65536);
                scene.Labels[v] = (ushort)random.Next(segmentCount);
            }
            Fill(scene.SegmentOpacities, () => 1f);
            Fill(scene.Lookup, () => 1f);
            return scene;
        }

        /// <summary>Random opacities of segments, a random transfer function over a random window.</summary>
        public void MakeTranslucent(System.Random random)
        {
            Fill(SegmentOpacities, () => random.Next(4) == 0 ? 0f : (float)random.NextDouble());
            var points = new double[9];
            for (int p = 0; p < points.Length; p++)
                points[p] = random.Next(3) == 0 ? 0 : random.NextDouble();
            for (int e = 0; e < LookupSize; e++)
            {
                double place = e * 8.0 / LookupSize;
                Lookup[e] = (float)(points[(int)place] + (points[(int)place + 1] - points[(int)place]) * (place - (int)place));
            }
            LookupScale = (float)((0.5 + 3 * random.NextDouble()) / 65535);
            LookupOffset = (float)(-random.NextDouble());
        }

        /// <summary>A sphere whose surface runs through the volume, with a random mask.</summary>
        public Sphere AddRandomSphere(System.Random random)
        {
            double[] centre = Grid.PositionOf(
                (random.NextDouble() * 1.4 - 0.2) * Grid.SizeI, (random.NextDouble() * 1.4 - 0.2) * Grid.SizeJ, (random.NextDouble() * 1.4 - 0.2) * Grid.SizeK);
            double[] corner = Grid.PositionOf(0, 0, 0);
            double size = Math.Sqrt(corner[0] * corner[0] + corner[1] * corner[1] + corner[2] * corner[2]);
            return AddSphere(centre[0], centre[1], centre[2], size * random.NextDouble() * random.NextDouble(), random);
        }

        /// <summary>A sphere around a voxel's centre, whose surface passes exactly through another voxel's, as far as float tells.</summary>
        public Sphere AddBoundarySphere(System.Random random)
        {
            float[] centre = Grid.Position(random.Next(Grid.SizeI), random.Next(Grid.SizeJ), random.Next(Grid.SizeK));
            float[] surface = Grid.Position(random.Next(Grid.SizeI), random.Next(Grid.SizeJ), random.Next(Grid.SizeK));
            double dx = (double)surface[0] - centre[0], dy = (double)surface[1] - centre[1], dz = (double)surface[2] - centre[2];
            return AddSphere(centre[0], centre[1], centre[2], Math.Sqrt(dx * dx + dy * dy + dz * dz), random);
        }

        public Sphere AddSphere(double x, double y, double z, double radius, System.Random random)
        {
            var sphere = new Sphere { X = (float)x, Y = (float)y, Z = (float)z, Radius = (float)radius, Clips = new bool[SegmentCount] };
            double share = random.NextDouble() * 1.4 - 0.2; // some masks are full, some empty
            for (int s = 0; s < SegmentCount; s++)
                sphere.Clips[s] = random.NextDouble() < share;
            Spheres.Add(sphere);
            return sphere;
        }

        /// <summary>Gives the kernel everything but its target and the bricks.</summary>
        public void Bind(KernelRig rig)
        {
            int words = (SegmentCount + 31) / 32;
            var rows = new SphereRow[Math.Max(1, Spheres.Count)];
            var masks = new uint[Math.Max(1, words * Spheres.Count)];
            for (int n = 0; n < Spheres.Count; n++)
            {
                Sphere sphere = Spheres[n];
                rows[n].CenterRadius = new Vector4(sphere.X, sphere.Y, sphere.Z, sphere.Radius);
                rows[n].MaskOffset = (uint)(n * words);
                for (int s = 0; s < SegmentCount; s++)
                    masks[n * words + s / 32] |= sphere.Clips[s] ? 1u << (s % 32) : 0u;
                rows[n].MaskWord0 = masks[n * words];
                rows[n].MaskWord1 = words > 1 ? masks[n * words + 1] : 0;
                rows[n].MaskWord2 = words > 2 ? masks[n * words + 2] : 0;
            }
            int tableRows = (SegmentCount + 1023) / 1024;
            var colors = new Vector4[1024 * tableRows];
            for (int s = 0; s < SegmentCount; s++)
                colors[s] = new Vector4(1, 1, 1, SegmentOpacities[s]);
            rig.Set(Grid);
            rig.SetCounts(Spheres.Count, words, SegmentCount, SmoothCut);
            rig.Set("_IntensityToLookup", new Vector4(LookupScale, LookupOffset, LookupSize - 1, 0));
            rig.SetVolume("_Intensity", GraphicsFormat.R16_UInt, Grid, Intensities);
            if (SegmentCount <= 255)
                rig.SetVolume("_Labels", GraphicsFormat.R8_UInt, Grid, Array.ConvertAll(Labels, label => (byte)label));
            else
                rig.SetVolume("_Labels", GraphicsFormat.R16_UInt, Grid, Labels);
            rig.SetPicture("_TransferFunction", GraphicsFormat.R32_SFloat, LookupSize, 1, Lookup);
            rig.SetPicture("_SegmentColors", GraphicsFormat.R32G32B32A32_SFloat, 1024, tableRows, colors);
            rig.SetRows("_Spheres", rows);
            rig.SetRows("_MaskWords", masks);
        }

        static void Fill(float[] values, Func<float> value)
        {
            for (int n = 0; n < values.Length; n++)
                values[n] = value();
        }

        struct SphereRow
        {
            public Vector4 CenterRadius;
            public uint MaskOffset, MaskWord0, MaskWord1, MaskWord2;
        }
    }
}
