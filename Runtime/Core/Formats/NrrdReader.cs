using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>
    /// Reads NRRD with its voxels in the same file (.nrrd, 3D Slicer's .seg.nrrd): raw, gzip, ascii and hex, every integer and
    /// floating-point type, both byte orders, values of a voxel first or last, the segments that Slicer writes. Detached headers
    /// (.nhdr) and bzip2 are refused by name.
    /// </summary>
    public static class NrrdReader
    {
        /// <summary>Reads a file.</summary>
        /// <param name="path">The file.</param>
        /// <param name="cancellation">Cancels the work.</param>
        /// <param name="progress">Told the share done, 0 to 1; may be null.</param>
        /// <exception cref="VolumeFormatException">The file can't be read; says what stands where, and what was expected.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public static VolumeData Read(string path, CancellationToken cancellation = default, IProgress<float> progress = null) =>
            VolumeFile.Read(path, stream => Read(stream, path, cancellation, progress));

        /// <summary>Reads from a stream, from its position on.</summary>
        /// <param name="stream">Can be read and positioned; stays open.</param>
        /// <param name="name">What messages call it.</param>
        /// <param name="cancellation">Cancels the work.</param>
        /// <param name="progress">Told the share done, 0 to 1; may be null.</param>
        /// <exception cref="VolumeFormatException">The data can't be read; says what stands where, and what was expected.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public static VolumeData Read(Stream stream, string name, CancellationToken cancellation = default, IProgress<float> progress = null)
        {
            VolumeFile.CheckStream(stream);
            var context = new ReadContext(name, "NRRD", cancellation, progress);
            Grid grid = ReadGrid(stream, context);
            Array voxels = NrrdVoxels.Read(stream, grid.Header, grid.Type, grid.Axes.Count, context);
            SlicerSegments.AddTo(context, grid.Axes.Components);
            return new VolumeData(grid.Geometry, voxels, (int)grid.Axes.Components, grid.Axes.Order, description: context.Description);
        }

        /// <summary>What the header says, whether or not the voxels are there.</summary>
        internal static VolumeFileInfo ReadInfo(Stream stream, ReadContext context)
        {
            Grid grid = ReadGrid(stream, context);
            SlicerSegments.AddTo(context, grid.Axes.Components);
            string encoding = grid.Header.Require("encoding");
            return new VolumeFileInfo(
                grid.Geometry, grid.Type, grid.Axes.Components, !encoding.Equals("raw", StringComparison.OrdinalIgnoreCase), context.Description);
        }

        static Grid ReadGrid(Stream stream, ReadContext context)
        {
            NrrdHeader header = NrrdHeader.Read(stream, context);
            VoxelType type = NrrdType.Of(header, context);
            List<VectorMm?> directions = NrrdGeometry.Directions(header, context);
            NrrdAxes axes = NrrdAxes.Of(header, directions, context);
            return new Grid { Header = header, Type = type, Axes = axes, Geometry = NrrdGeometry.Of(header, axes, directions, context) };
        }

        struct Grid
        {
            internal NrrdHeader Header;
            internal VoxelType Type;
            internal NrrdAxes Axes;
            internal VolumeGeometry Geometry;
        }
    }
}
