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
            NrrdHeader header = NrrdHeader.Read(stream, context);
            VoxelType type = NrrdType.Of(header, context);
            List<VectorMm?> directions = NrrdGeometry.Directions(header, context);
            NrrdAxes axes = NrrdAxes.Of(header, directions, context);
            VolumeGeometry geometry = NrrdGeometry.Of(header, axes, directions, context);
            Array voxels = NrrdVoxels.Read(stream, header, type, axes.Count, context);
            SlicerSegments.AddTo(context, axes.Components);
            return new VolumeData(geometry, voxels, (int)axes.Components, axes.Order, description: context.Description);
        }
    }
}
