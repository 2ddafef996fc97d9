using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Desktop
{
    /// <summary>
    /// The active sphere of a stack in world space: placed, moved and resized without its other values being rounded on the way through world
    /// space. Its centre is kept where the sphere can still touch the volume, its radius between a millimetre and what covers the whole volume.
    /// </summary>
    public readonly struct WorldSphere
    {
        /// <summary>A new sphere's diameter, as a share of the volume's longest side.</summary>
        public const double FirstDiameter = 1.0 / 3.0;

        /// <summary>The smallest radius, in millimetres of the patient.</summary>
        public const double SmallestRadiusMm = 1;

        readonly CarvingStack carving;
        readonly VolumeGeometry geometry;
        readonly Matrix4x4 localToWorld;

        WorldSphere(CarvingStack carving, VolumeGeometry geometry, Matrix4x4 localToWorld)
        {
            this.carving = carving;
            this.geometry = geometry;
            this.localToWorld = localToWorld;
        }

        /// <summary>The sphere of a stack's volume.</summary>
        /// <param name="stack">The stack; may be null.</param>
        /// <param name="sphere">The sphere, which need not exist yet.</param>
        /// <returns>False while no volume is loaded, or its transform has a scale of 0.</returns>
        public static bool TryGet(ClipSphereStack stack, out WorldSphere sphere)
        {
            sphere = default;
            CarvingStack carving = stack != null ? stack.Carving : null;
            if (carving == null)
                return false;
            Matrix4x4 localToWorld = stack.Loader.transform.localToWorldMatrix;
            if (VolumeSpace.WorldScale(localToWorld) == 0)
                return false;
            sphere = new WorldSphere(carving, stack.Loader.Volume.Geometry, localToWorld);
            return true;
        }

        /// <summary>The carving that the sphere belongs to.</summary>
        public CarvingStack Carving => carving;

        /// <summary>Whether there is a sphere.</summary>
        public bool Exists => carving.Active is object;

        /// <summary>Its centre in world space; the volume's while there is no sphere.</summary>
        public Vector3 Centre => localToWorld.MultiplyPoint3x4(Exists ? VolumeSpace.LpsToLocal(geometry, carving.Active.CentreLps) : Vector3.zero);

        /// <summary>Its radius in world units; a new one's while there is no sphere.</summary>
        public float Radius => (float)(RadiusMm * VolumeSpace.MetresPerMm * VolumeSpace.WorldScale(localToWorld));

        double RadiusMm => Exists ? carving.Active.RadiusMm : 0.5 * FirstDiameter * LongestSideMm;

        double LongestSideMm => Math.Max(Sides.X, Math.Max(Sides.Y, Sides.Z));

        VectorMm Sides => new VectorMm(
            geometry.SizeI * geometry.SpacingMm.X, geometry.SizeJ * geometry.SpacingMm.Y, geometry.SizeK * geometry.SpacingMm.Z);

        /// <summary>Moves the sphere; one that does not exist yet is made there, with a third of the volume's extent as its diameter.</summary>
        /// <param name="world">The centre in world space.</param>
        public void MoveTo(Vector3 world)
        {
            PointMm centre = VolumeSpace.WorldToLps(geometry, localToWorld).TransformPoint(new PointMm(world.x, world.y, world.z));
            carving.SetActive(Kept(centre, RadiusMm), RadiusMm);
        }

        /// <summary>Changes the radius by a factor; a sphere that does not exist yet is made in the volume's centre.</summary>
        /// <param name="factor">Above 0.</param>
        public void Scale(double factor)
        {
            double radius = Math.Max(SmallestRadiusMm, Math.Min(Sides.Length, RadiusMm * factor));
            PointMm centre = Exists ? carving.Active.CentreLps : geometry.CentreLps;
            carving.SetActive(Kept(centre, radius), radius);
        }

        /// <summary>Where a ray enters the sphere, in world units from its origin; 0 if it begins inside.</summary>
        /// <returns>False if it misses the sphere, or there is none.</returns>
        public bool TryEnter(Ray ray, out float distance)
        {
            distance = 0f;
            if (!Exists)
                return false;
            // In a volume that is scaled unevenly the sphere is an egg in the world; there the mean radius decides, which is what Radius is.
            Vector3 from = ray.origin - Centre;
            float towards = -Vector3.Dot(from, ray.direction), outside = from.sqrMagnitude - Radius * Radius;
            if (outside <= 0f)
                return true;
            float inside = towards * towards - outside;
            distance = towards - Mathf.Sqrt(Mathf.Max(0f, inside));
            return towards > 0f && inside >= 0f;
        }

        /// <summary>The nearest place from which the sphere still touches the volume's box: further out it could only get lost.</summary>
        PointMm Kept(PointMm centre, double radius)
        {
            PointMm ijk = geometry.LpsToIjk.TransformPoint(centre);
            VectorMm spacing = geometry.SpacingMm;
            var kept = new PointMm(
                Kept(ijk.X, geometry.SizeI, radius / spacing.X),
                Kept(ijk.Y, geometry.SizeJ, radius / spacing.Y),
                Kept(ijk.Z, geometry.SizeK, radius / spacing.Z));
            // A centre that may stay is not rounded on the way through the grid.
            return kept.Equals(ijk) ? centre : geometry.IjkToLps.TransformPoint(kept);
        }

        static double Kept(double index, int size, double reach) => Math.Max(-0.5 - reach, Math.Min(size - 0.5 + reach, index));
    }
}
