using System;
using AnatomyCarve.Picking;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>Everything that Raymarch reads, as plain arrays; rays in centred mm.</summary>
    sealed class RayScene
    {
        public const int NoSegment = 0xFFFF;

        public KernelGrid Grid { get; private set; }

        /// <summary>Opacity before anti-aliasing, R8.</summary>
        public byte[] Opacity { get; private set; }

        /// <summary>The opacity that rays sample.</summary>
        public float[] OpacityAA { get; private set; }

        public ushort[] Labels { get; private set; }

        /// <summary>Two codes per voxel.</summary>
        public byte[] Normals { get; private set; }

        public Vector4[] Colors { get; private set; }

        public int Width { get; set; } = 21;

        public int Height { get; set; } = 13;

        public double[] Origin { get; set; } = new double[3];

        public double[] OriginDx { get; set; } = new double[3];

        public double[] OriginDy { get; set; } = new double[3];

        public double[] Direction { get; set; } = new double[3];

        public double[] DirectionDx { get; set; } = new double[3];

        public double[] DirectionDy { get; set; } = new double[3];

        public double NearT { get; set; }

        public double FarT { get; set; } = 1e6;

        public double Step { get; set; } = 0.5;

        public double OpaqueAlpha { get; set; } = 1 - 1 / 255.0;

        public double VisibleAlpha { get; set; } = 0.5;

        public OpacityFilter Filter { get; set; } = OpacityFilter.Exact;

        public double[] Light { get; set; } = { 0, 0, 1 };

        public double[] LightColor { get; set; } = { 1, 1, 1 };

        public double Ambient { get; set; } = 0.25;

        public double Diffuse { get; set; } = 0.75;

        public double Specular { get; set; } = 0.2;

        public double Shininess { get; set; } = 24;

        /// <summary>One t per pixel, or null.</summary>
        public float[] SceneDepth { get; set; }

        /// <summary>A volume of one opacity, segment and colour, without normals.</summary>
        public static RayScene Uniform(KernelGrid grid, float opacity, Vector4 color)
        {
            var scene = Empty(grid, 1);
            scene.Colors[0] = color;
            for (int v = 0; v < grid.VoxelCount; v++)
            {
                scene.OpacityAA[v] = opacity;
                scene.Opacity[v] = (byte)Math.Round(opacity * 255);
            }
            return scene;
        }

        /// <summary>Random smooth opacities with holes, random segments, normals and colours, light from anywhere.</summary>
        public static RayScene Random(KernelGrid grid, System.Random random)
        {
            int segments = 1 + random.Next(40);
            RayScene scene = Empty(grid, segments);
            scene.Opacity = OpacityFields.Balls(grid, random);
            double strength = 0.4 + 0.6 * random.NextDouble();
            for (int v = 0; v < grid.VoxelCount; v++)
            {
                scene.Opacity[v] = (byte)(scene.Opacity[v] * strength);
                scene.Labels[v] = (ushort)random.Next(segments);
                scene.Normals[2 * v] = (byte)random.Next(255);
                scene.Normals[2 * v + 1] = (byte)(random.Next(5) == 0 ? 0 : random.Next(255));
                if (scene.Normals[2 * v + 1] == 0)
                    scene.Normals[2 * v] = 0;
            }
            var smooth = new AntiAliasTwin(grid, scene.Opacity);
            grid.ForEach((i, j, k) => scene.OpacityAA[grid.Index(i, j, k)] = (float)smooth.Opacity(i, j, k));
            for (int s = 0; s < segments; s++)
                scene.Colors[s] = new Vector4((float)random.NextDouble(), (float)random.NextDouble(), (float)random.NextDouble(), 1);
            scene.Light = RandomDirection(random);
            scene.LightColor = new[] { 0.5 + random.NextDouble(), 0.5 + random.NextDouble(), 0.5 + random.NextDouble() };
            scene.Step = 0.3 + random.NextDouble();
            return scene;
        }

        /// <summary>A perspective camera; t = distance along the axis in units of the given length.</summary>
        public void LookFrom(double[] eye, double[] target, double tangentOfHalfHeight, double unitMm, System.Random random)
        {
            double[] forward = OctahedralTwin.Normalized(Subtract(target, eye));
            double[] right = OctahedralTwin.Normalized(Cross(forward, RandomDirection(random)));
            double[] up = Cross(right, forward);
            double pixel = 2 * tangentOfHalfHeight / Height;
            Origin = eye;
            DirectionDx = Scale(right, pixel * unitMm);
            DirectionDy = Scale(up, pixel * unitMm);
            Direction = new double[3];
            for (int axis = 0; axis < 3; axis++)
                Direction[axis] = forward[axis] * unitMm - 0.5 * Width * DirectionDx[axis] - 0.5 * Height * DirectionDy[axis];
            FarT = 1e6 / unitMm;
        }

        /// <summary>Parallel rays along a direction through a window around the volume's centre.</summary>
        public void LookAlong(double[] direction, double[] right, double[] up, double windowMm, double distanceMm)
        {
            Direction = direction;
            OriginDx = Scale(right, windowMm / Height);
            OriginDy = Scale(up, windowMm / Height);
            Origin = new double[3];
            for (int axis = 0; axis < 3; axis++)
                Origin[axis] = -distanceMm * direction[axis] - 0.5 * Width * OriginDx[axis] - 0.5 * Height * OriginDy[axis];
        }

        byte[] OpacityAACodes => Array.ConvertAll(OpacityAA, o => (byte)Math.Round(o * 255));

        /// <summary>Gives the kernel everything but its targets.</summary>
        /// <param name="rig">The kernel; of the portable layout if the opacities are to be packed.</param>
        /// <param name="opacityFormat">Of the opacities that rays sample; R32_UInt = packed.</param>
        public void Bind(KernelRig rig, GraphicsFormat opacityFormat = GraphicsFormat.R32_SFloat)
        {
            rig.Set(Grid);
            rig.SetCounts(0, 0, Colors.Length, false);
            rig.SetPictureSize(Width, Height, SceneDepth != null);
            rig.Set("_RayOrigin", Row(Origin));
            rig.Set("_RayOriginDx", Row(OriginDx));
            rig.Set("_RayOriginDy", Row(OriginDy));
            rig.Set("_RayDirection", Row(Direction));
            rig.Set("_RayDirectionDx", Row(DirectionDx));
            rig.Set("_RayDirectionDy", Row(DirectionDy));
            rig.Set("_RayRange", new Vector4((float)NearT, (float)FarT, 0, 0));
            rig.Set("_March", new Vector4((float)Step, (float)OpaqueAlpha, (float)VisibleAlpha, Filter == OpacityFilter.Exact ? 1 : 0));
            rig.Set("_Skip", new Vector4(0, RaySettings.PartsOfStep, 0, 0));
            rig.SetTexels("_SkipMap", 1, 1, 1, new uint[1]);
            rig.Set("_LightDirection", Row(Light));
            rig.Set("_LightColor", Row(LightColor));
            rig.Set("_Shading", new Vector4((float)Ambient, (float)Diffuse, (float)Specular, (float)Shininess));
            rig.SetVolume("_Labels", GraphicsFormat.R16_UInt, Grid, Labels);
            if (opacityFormat == GraphicsFormat.R32_UInt)
            {
                rig.SetPacked("_Opacity", Grid, Opacity);
                rig.SetPacked("_OpacityAA", Grid, OpacityAACodes);
                rig.SetPacked("_Normals", Grid, Normals);
            }
            else
            {
                rig.SetVolume("_Opacity", GraphicsFormat.R8_UNorm, Grid, Opacity);
                rig.SetVolume("_Normals", GraphicsFormat.R8G8_UNorm, Grid, Normals);
                if (opacityFormat == GraphicsFormat.R8_UNorm)
                    rig.SetVolume("_OpacityAA", opacityFormat, Grid, OpacityAACodes, FilterMode.Bilinear);
                else
                    rig.SetVolume("_OpacityAA", opacityFormat, Grid, OpacityAA, FilterMode.Bilinear);
            }
            var table = new Vector4[1024 * ((Colors.Length + 1023) / 1024)];
            Colors.CopyTo(table, 0);
            rig.SetPicture("_SegmentColors", GraphicsFormat.R32G32B32A32_SFloat, 1024, table.Length / 1024, table);
            if (SceneDepth == null)
                rig.SetPicture("_SceneDepth", GraphicsFormat.R32_SFloat, 1, 1, new float[1]);
            else
                rig.SetPicture("_SceneDepth", GraphicsFormat.R32_SFloat, Width, Height, SceneDepth);
        }

        public static double[] RandomDirection(System.Random random)
        {
            double z = random.NextDouble() * 2 - 1, angle = random.NextDouble() * 2 * Math.PI, r = Math.Sqrt(1 - z * z);
            return new[] { r * Math.Cos(angle), r * Math.Sin(angle), z };
        }

        public static double[] Scale(double[] v, double factor) => new[] { v[0] * factor, v[1] * factor, v[2] * factor };

        static RayScene Empty(KernelGrid grid, int segments) => new RayScene
        {
            Grid = grid,
            Opacity = new byte[grid.VoxelCount],
            OpacityAA = new float[grid.VoxelCount],
            Labels = new ushort[grid.VoxelCount],
            Normals = new byte[2 * grid.VoxelCount],
            Colors = new Vector4[segments],
        };

        static Vector4 Row(double[] v) => new Vector4((float)v[0], (float)v[1], (float)v[2], 0);

        static double[] Subtract(double[] a, double[] b) => new[] { a[0] - b[0], a[1] - b[1], a[2] - b[2] };

        static double[] Cross(double[] a, double[] b) =>
            new[] { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
    }
}
