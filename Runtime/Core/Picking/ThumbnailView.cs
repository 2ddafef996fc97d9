using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Picking
{
    /// <summary>Parallel projections from one direction that show a box of voxels, or what is seen of it, as large as a square picture permits.</summary>
    sealed class ThumbnailView
    {
        /// <summary>Pixels along each side of the picture that finds out where there is anything.</summary>
        internal const int FramingSize = 64;

        /// <summary>How much more than what is seen the picture shows.</summary>
        const double Margin = 1.04;

        readonly OrbitCamera orbit;

        /// <param name="orbit">Where it is looked from.</param>
        /// <param name="size">The picture's sides, pixels.</param>
        internal ThumbnailView(OrbitCamera orbit, int size)
        {
            this.orbit = orbit;
            Size = size;
        }

        /// <summary>The picture's sides, pixels.</summary>
        internal int Size { get; }

        /// <summary>All voxels of a grid.</summary>
        internal static VoxelBox BoxOf(VolumeGeometry geometry) =>
            new VoxelBox { MaxI = geometry.SizeI - 1, MaxJ = geometry.SizeJ - 1, MaxK = geometry.SizeK - 1 };

        /// <summary>The smallest box of all voxels whose segment is visible and not label 0; false where there are none.</summary>
        internal static bool TryFindSegments(SegmentedVolume volume, out VoxelBox box)
        {
            VolumeGeometry geometry = volume.Geometry;
            box = new VoxelBox { MinI = int.MaxValue, MinJ = int.MaxValue, MinK = int.MaxValue, MaxI = -1, MaxJ = -1, MaxK = -1 };
            var isVisible = new bool[volume.Segments.Count];
            for (int index = 1; index < isVisible.Length; index++)
                isVisible[index] = volume.Segments[index].Opacity > 0;
            for (int k = 0; k < geometry.SizeK; k++)
            {
                for (int j = 0; j < geometry.SizeJ; j++)
                {
                    ReadOnlySpan<ushort> row = volume.Labels.Indices.AsSpan((int)(geometry.SizeI * (j + ((long)geometry.SizeJ * k))), geometry.SizeI);
                    int first = 0;
                    while (first < row.Length && !isVisible[row[first]])
                        first++;
                    if (first == row.Length)
                        continue;
                    int last = row.Length - 1;
                    while (!isVisible[row[last]])
                        last--;
                    Include(ref box, first, last, j, k);
                }
            }

            return box.MaxI >= 0;
        }

        /// <summary>A projection that shows all of a box.</summary>
        /// <param name="pixels">The picture's sides.</param>
        internal PictureRays Around(VolumeGeometry geometry, VoxelBox box, int pixels)
        {
            PointMm centre = geometry.IjkToLps.TransformPoint(new PointMm(
                0.5 * (box.MinI + box.MaxI), 0.5 * (box.MinJ + box.MaxJ), 0.5 * (box.MinK + box.MaxK)));
            double radiusMm = 0;
            for (int corner = 0; corner < 8; corner++)
            {
                PointMm place = geometry.IjkToLps.TransformPoint(new PointMm(
                    (corner & 1) == 0 ? box.MinI - 0.5 : box.MaxI + 0.5,
                    (corner & 2) == 0 ? box.MinJ - 0.5 : box.MaxJ + 0.5,
                    (corner & 4) == 0 ? box.MinK - 0.5 : box.MaxK + 0.5));
                radiusMm = Math.Max(radiusMm, place.DistanceTo(centre));
            }

            return PictureRays.Orthographic(centre + (radiusMm * orbit.TowardsEyeLps), centre, orbit.UpLps, 2 * radiusMm, pixels, pixels);
        }

        /// <summary>A projection that shows what another one met, and little more.</summary>
        internal PictureRays Framed(SurfaceMap found)
        {
            int left = found.Width, right = -1, bottom = found.Height, top = -1;
            for (int row = 0; row < found.Height; row++)
            {
                for (int column = 0; column < found.Width; column++)
                {
                    if (found.SegmentAt(column, row) < 0)
                        continue;
                    left = Math.Min(left, column);
                    right = Math.Max(right, column);
                    bottom = Math.Min(bottom, row);
                    top = Math.Max(top, row);
                }
            }

            PictureRays rays = found.Rays;
            PointMm eye = rays.Origin + ((0.5 * (left + right + 1) * rays.OriginDx) + (0.5 * (bottom + top + 1) * rays.OriginDy));

            // What lies between two rays of the coarse picture may reach a pixel further.
            double sideMm = Margin * (Math.Max(right - left, top - bottom) + 2) * rays.OriginDx.Length;
            return PictureRays.Orthographic(eye, eye + rays.Direction, orbit.UpLps, sideMm, Size, Size);
        }

        static void Include(ref VoxelBox box, int first, int last, int j, int k)
        {
            box.MinI = Math.Min(box.MinI, first);
            box.MaxI = Math.Max(box.MaxI, last);
            box.MinJ = Math.Min(box.MinJ, j);
            box.MaxJ = Math.Max(box.MaxJ, j);
            box.MinK = Math.Min(box.MinK, k);
            box.MaxK = Math.Max(box.MaxK, k);
        }
    }
}
