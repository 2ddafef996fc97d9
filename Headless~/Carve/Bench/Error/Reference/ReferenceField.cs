using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error.Reference
{
    /// <summary>What of an opacity is kept.</summary>
    enum OpacityPrecision
    {
        /// <summary>All of it.</summary>
        Exact,

        /// <summary>The nearest of 256 steps, which the package stores, before anti-aliasing.</summary>
        EightBits,
    }

    /// <summary>
    /// A carved volume as the definitions have it, before anything is rounded: opacities, anti-aliased opacities and normals in double precision, from the
    /// stored intensities and the points of the transfer function. Eq. 1 alone is decided in float, as it is defined. Computed where somebody
    /// looks, from any thread.
    /// </summary>
    sealed class ReferenceField
    {
        readonly SegmentedVolume volume;
        readonly double[] opacityOfCode;
        readonly IReadOnlyList<ClipSphere> spheres;
        readonly SphereF[] centredSpheres;
        readonly CutMode cut;
        readonly OpacityPrecision precision;
        readonly LazyBricks<double> opacities, antiAliased;
        readonly LazyBricks<VectorMm> normals;

        public ReferenceField(
            SegmentedVolume volume, OpacityTransferFunction transferFunction, SegmentTable segments, IReadOnlyList<ClipSphere> spheres, CutMode cut,
            OpacityPrecision precision = OpacityPrecision.Exact)
        {
            Segments = segments;
            this.volume = volume;
            this.cut = cut;
            this.precision = precision;
            this.spheres = [.. spheres.Where(sphere => sphere.CanClip)];
            Grid = new CentredGrid(volume.Geometry);
            Bricks = new BrickGrid(volume.Geometry);
            centredSpheres = [.. this.spheres.Select(Grid.ToCentred)];
            opacityOfCode = [.. Enumerable.Range(0, ushort.MaxValue + 1).Select(code => transferFunction.OpacityAt(volume.Intensity.ValueOf((ushort)code)))];
            opacities = new LazyBricks<double>(Bricks, Opacity);
            antiAliased = new LazyBricks<double>(Bricks, (i, j, k) => AntiAliasReference.At(this, i, j, k));
            normals = new LazyBricks<VectorMm>(Bricks, (i, j, k) => NormalReference.At(this, i, j, k));
        }

        /// <summary>With the opacities and colours that are shown.</summary>
        public SegmentTable Segments { get; }

        public VolumeGeometry Geometry => volume.Geometry;

        public CentredGrid Grid { get; }

        public BrickGrid Bricks { get; }

        /// <summary>Per reference length, carved. Beyond the border the nearest voxel counts.</summary>
        public double OpacityOf(int i, int j, int k) => opacities.Clamped(i, j, k);

        /// <summary>Anti-aliased; beyond the border the nearest voxel counts.</summary>
        public double AntiAliasedOf(int i, int j, int k) => antiAliased.Clamped(i, j, k);

        /// <summary>A unit vector out of matter, LPS; (0, 0, 0) = none. Beyond the border the nearest voxel counts.</summary>
        public VectorMm NormalOf(int i, int j, int k) => normals.Clamped(i, j, k);

        public bool Holds(int i, int j, int k) =>
            (uint)i < (uint)Bricks.SizeI && (uint)j < (uint)Bricks.SizeJ && (uint)k < (uint)Bricks.SizeK;

        /// <summary>
        /// The segment that a place in the cell above a corner shows: that of the most opaque of the cell's voxels; where all are empty, of the 4 x 4 x 4
        /// around it; -1 where these are too.
        /// </summary>
        public int SegmentAround(int i, int j, int k)
        {
            var segment = MostOpaque(i, j, k, 2);
            return segment >= 0 ? segment : MostOpaque(i - 1, j - 1, k - 1, 4);
        }

        /// <summary>
        /// The normal of the sphere that a voxel lies deepest in, of those that clip its segment, where its surface is within 1.75 voxel extents; null elsewhere.
        /// </summary>
        public VectorMm? CutNormal(int i, int j, int k)
        {
            var segment = volume.Labels.Indices[VoxelAt(i, j, k)];
            var depth = double.NegativeInfinity;
            ClipSphere deepest = null;
            foreach (var sphere in spheres)
            {
                if (!sphere.Mask[segment]) continue;
                var inside = DepthInVoxels(sphere, i, j, k);
                if (inside > depth) (depth, deepest) = (inside, sphere);
            }

            if (deepest == null || Math.Abs(depth) > CarvingReach.SurfaceExtents) return null;
            var inwards = deepest.CentreLps - Geometry.IjkToLps.TransformPoint(new PointMm(i, j, k));
            return inwards.Length > 0 ? inwards.Normalized() : null;
        }

        /// <summary>The eight voxels of a cell: each one's opacity before anti-aliasing and segment, i fastest.</summary>
        public void Cell(int i, int j, int k, Span<double> cellOpacities, Span<int> cellSegments)
        {
            for (var n = 0; n < 8; n++)
            {
                var vi = Math.Clamp(i + (n & 1), 0, Bricks.SizeI - 1);
                var vj = Math.Clamp(j + (n >> 1 & 1), 0, Bricks.SizeJ - 1);
                var vk = Math.Clamp(k + (n >> 2), 0, Bricks.SizeK - 1);
                cellOpacities[n] = opacities[vi, vj, vk];
                cellSegments[n] = volume.Labels.Indices[VoxelAt(vi, vj, vk)];
            }
        }

        int MostOpaque(int i, int j, int k, int size)
        {
            double most = 0;
            var segment = -1;
            for (var n = 0; n < size * size * size; n++)
            {
                var vi = Math.Clamp(i + n % size, 0, Bricks.SizeI - 1);
                var vj = Math.Clamp(j + n / size % size, 0, Bricks.SizeJ - 1);
                var vk = Math.Clamp(k + n / (size * size), 0, Bricks.SizeK - 1);
                var opacity = opacities[vi, vj, vk];
                if (opacity > most) (most, segment) = (opacity, volume.Labels.Indices[VoxelAt(vi, vj, vk)]);
            }

            return segment;
        }

        double Opacity(int i, int j, int k)
        {
            var voxel = VoxelAt(i, j, k);
            var segment = volume.Labels.Indices[voxel];
            var uncut = opacityOfCode[volume.Intensity.Codes[voxel]] * Segments[segment].Opacity;
            var carved = uncut > 0 ? uncut * (1 - Coverage(i, j, k, segment)) : 0;
            return precision == OpacityPrecision.EightBits ? Math.Round(255 * carved) / 255 : carved;
        }

        double Coverage(int i, int j, int k, int segment)
        {
            double most = 0;
            Grid.Position(i, j, k, out var x, out var y, out var z);
            for (var s = 0; s < spheres.Count && most < 1; s++)
            {
                if (!spheres[s].Mask[segment]) continue;
                most = Math.Max(most, cut == CutMode.Smooth ? SmoothCoverage(spheres[s], i, j, k) : ClipTest.Inside(centredSpheres[s], x, y, z) ? 1 : 0);
            }

            return most;
        }

        double SmoothCoverage(ClipSphere sphere, int i, int j, int k) => Math.Clamp(0.5 + DepthInVoxels(sphere, i, j, k), 0, 1);

        /// <summary>How deep a voxel's centre lies in a sphere, in extents of a voxel along the sphere's normal.</summary>
        double DepthInVoxels(ClipSphere sphere, int i, int j, int k)
        {
            var offset = Geometry.IjkToLps.TransformPoint(new PointMm(i, j, k)) - sphere.CentreLps;
            var distance = offset.Length;
            var extent = Geometry.ReferenceLengthMm;
            if (distance > 0)
            {
                var normal = offset / distance;
                extent = 0;
                for (var axis = 0; axis < 3; axis++) extent += Math.Abs(normal.Dot(Geometry.IjkToLps.Column(axis)));
            }

            return (sphere.RadiusMm - distance) / extent;
        }

        long VoxelAt(int i, int j, int k) => i + (long)Bricks.SizeI * (j + (long)Bricks.SizeJ * k);
    }
}
