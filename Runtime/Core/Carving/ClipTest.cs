using System;
using System.Collections.Generic;

namespace AnatomyCarve.Carving
{
    /// <summary>How a clip sphere cuts the voxels at its surface.</summary>
    public enum CutMode
    {
        /// <summary>A voxel is clipped whole or not at all, by its centre: Eq. 1 of the design.</summary>
        Binary = 0,

        /// <summary>A voxel loses the share of its opacity that lies inside the sphere.</summary>
        Smooth = 1,
    }

    /// <summary>
    /// Eq. 1 of the design and the coverage of a voxel by a sphere, in float. <see cref="Inside"/> does the kernel's operations in the kernel's order,
    /// each rounded to float by a cast of its own (a C# compiler may otherwise keep more precision), so that CPU and GPU agree in every bit.
    /// </summary>
    public static class ClipTest
    {
        /// <summary>Whether a point lies in a sphere, the surface included: radius > 0 and (dx*dx + dy*dy) + dz*dz &lt;= radius*radius.</summary>
        /// <param name="sphere">The sphere in centred millimetres.</param>
        /// <param name="px">The point's L component in centred millimetres.</param>
        /// <param name="py">P component.</param>
        /// <param name="pz">S component.</param>
        public static bool Inside(in SphereF sphere, float px, float py, float pz)
        {
            float dx = (float)(px - sphere.X);
            float dy = (float)(py - sphere.Y);
            float dz = (float)(pz - sphere.Z);
            float squared = (float)((float)((float)(dx * dx) + (float)(dy * dy)) + (float)(dz * dz));
            return sphere.Radius > 0 && squared <= (float)(sphere.Radius * sphere.Radius);
        }

        /// <summary>
        /// The share of a voxel that lies inside a sphere, 0 to 1. Smooth: the sphere's surface is taken as a plane and the share as linear over the
        /// voxel's extent w along the plane's normal: saturate(0.5 + s / w), with s the distance of the voxel's centre below the surface. For a
        /// voxel in the sphere's very centre w is the smallest voxel spacing. Radius 0 covers nothing.
        /// </summary>
        /// <param name="grid">The volume's grid.</param>
        /// <param name="sphere">The sphere in centred millimetres.</param>
        /// <param name="px">The voxel centre's L component in centred millimetres.</param>
        /// <param name="py">P component.</param>
        /// <param name="pz">S component.</param>
        /// <param name="cut">Binary: 1 where <see cref="Inside"/>, otherwise 0.</param>
        /// <exception cref="ArgumentNullException"><paramref name="grid"/> is null.</exception>
        public static float Coverage(CentredGrid grid, in SphereF sphere, float px, float py, float pz, CutMode cut)
        {
            if (grid == null)
                throw new ArgumentNullException(nameof(grid));
            if (cut == CutMode.Binary)
                return Inside(sphere, px, py, pz) ? 1f : 0f;
            if (!(sphere.Radius > 0))
                return 0f;
            float dx = (float)(px - sphere.X);
            float dy = (float)(py - sphere.Y);
            float dz = (float)(pz - sphere.Z);
            float squared = (float)((float)((float)(dx * dx) + (float)(dy * dy)) + (float)(dz * dz));
            float distance = (float)Math.Sqrt(squared);
            float extent = distance > 0
                ? grid.VoxelExtent((float)(dx / distance), (float)(dy / distance), (float)(dz / distance))
                : (float)grid.Geometry.ReferenceLengthMm;
            float share = (float)(0.5f + (float)((float)(sphere.Radius - distance) / extent));
            return share <= 0 ? 0f : share >= 1 ? 1f : share;
        }

        /// <summary>Eq. 1: whether any of the spheres contains the voxel's centre and has its segment in the mask. Does not depend on the cut mode.</summary>
        /// <param name="grid">The volume's grid.</param>
        /// <param name="spheres">The carving.</param>
        /// <param name="i">Voxel index, as <paramref name="j"/> and <paramref name="k"/>; it may lie outside the volume.</param>
        /// <param name="j">Voxel index.</param>
        /// <param name="k">Voxel index.</param>
        /// <param name="segment">The voxel's dense segment index.</param>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        /// <exception cref="ArgumentOutOfRangeException">A mask has no such segment.</exception>
        public static bool IsClipped(CentredGrid grid, IReadOnlyList<ClipSphere> spheres, int i, int j, int k, int segment)
        {
            if (grid == null)
                throw new ArgumentNullException(nameof(grid));
            if (spheres == null)
                throw new ArgumentNullException(nameof(spheres));
            grid.Position(i, j, k, out float x, out float y, out float z);
            for (int s = 0; s < spheres.Count; s++)
            {
                if (spheres[s].Mask[segment] && Inside(grid.ToCentred(spheres[s]), x, y, z))
                    return true;
            }
            return false;
        }
    }
}
