using System;
using System.Threading;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Picking
{
    /// <summary>
    /// A small picture of a volume, made on the CPU: the segments' surfaces from the patient's front, left and above, in their colours. It is for lists and
    /// file browsers, where no GPU may be at hand; <c>CarvedVolumeRenderer</c> makes pictures of what is carved.
    /// </summary>
    public static class VolumeThumbnail
    {
        /// <summary>The largest side, in pixels.</summary>
        public const int MaximumSize = 1024;

        const double AzimuthDegrees = 35;
        const double ElevationDegrees = 20;

        /// <summary>Rays along each side of a pixel.</summary>
        const int RaysPerPixel = 2;

        const int Channels = 4;

        /// <summary>
        /// Makes the picture. Where there are segments they are shown, whatever their intensities, and tissue that none of them claims is left out. Where that
        /// would leave nothing, and where there are no segments, the scan is shown by its automatic transfer function.
        /// </summary>
        /// <param name="volume">The volume.</param>
        /// <param name="size">The picture's sides, 1 to <see cref="MaximumSize"/> pixels.</param>
        /// <param name="cancellation">Cancels the work.</param>
        /// <returns>Red, green, blue and alpha of each pixel, a byte each, the bottom row first: sRGB, not premultiplied, alpha 0 behind the volume.</returns>
        /// <exception cref="ArgumentNullException"><paramref name="volume"/> is null.</exception>
        /// <exception cref="ArgumentOutOfRangeException"><paramref name="size"/> lies outside its range, or the volume is longer than 8,192 voxels.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public static byte[] Render(SegmentedVolume volume, int size, CancellationToken cancellation = default)
        {
            if (volume == null)
                throw new ArgumentNullException(nameof(volume));
            if (size < 1 || size > MaximumSize)
                throw new ArgumentOutOfRangeException(nameof(size), size, FormattableString.Invariant($"A thumbnail's sides are 1 to {MaximumSize} pixels."));
            var view = new ThumbnailView(new OrbitCamera(AzimuthDegrees, ElevationDegrees), size * RaysPerPixel);
            SurfaceMap surface = null;
            if (ThumbnailView.TryFindSegments(volume, out VoxelBox box))
                surface = SurfaceOf(SegmentsOf(volume), view, box, cancellation);
            if (surface == null || surface.Hits == 0)
                surface = SurfaceOf(ScanOf(volume), view, ThumbnailView.BoxOf(volume.Geometry), cancellation);
            return Colors(volume.Segments, surface, size);
        }

        /// <summary>Segments are solid, whatever their intensities: lungs and bowel hold air.</summary>
        static CarvedField SegmentsOf(SegmentedVolume volume) =>
            FieldOf(volume, OpacityTransferFunction.Constant(1), volume.Segments.WithOpacity(0, 0));

        static CarvedField ScanOf(SegmentedVolume volume) => FieldOf(volume, volume.AutomaticTransferFunction, volume.Segments);

        static CarvedField FieldOf(SegmentedVolume volume, OpacityTransferFunction function, SegmentTable segments)
        {
            var field = new CarvedField(volume);
            field.Update(Array.Empty<ClipSphere>(), function, segments, CutMode.Binary, AntiAliasSettings.Off);
            return field;
        }

        /// <summary>Looks twice: where there is anything, and then closer.</summary>
        static SurfaceMap SurfaceOf(CarvedField field, ThumbnailView view, VoxelBox box, CancellationToken cancellation)
        {
            var settings = new RaySettings();
            PictureRays coarse = view.Around(field.Volume.Geometry, box, ThumbnailView.FramingSize);
            SurfaceMap found = SurfaceMap.Of(field, coarse, settings, cancellation);

            // What is too small for the coarse rays may still meet one of the others.
            PictureRays rays = found.Hits > 0 ? view.Framed(found) : view.Around(field.Volume.Geometry, box, view.Size);
            return SurfaceMap.Of(field, rays, settings, cancellation);
        }

        static byte[] Colors(SegmentTable segments, SurfaceMap surface, int size)
        {
            double pixelMm = surface.Rays.OriginDx.Length;
            var colors = new byte[size * size * Channels];
            for (int row = 0; row < size; row++)
            {
                for (int column = 0; column < size; column++)
                {
                    VectorMm sum = default;
                    int hits = 0;
                    for (int sub = 0; sub < RaysPerPixel * RaysPerPixel; sub++)
                    {
                        int x = (column * RaysPerPixel) + (sub % RaysPerPixel), y = (row * RaysPerPixel) + (sub / RaysPerPixel);
                        int segment = surface.SegmentAt(x, y);
                        if (segment < 0)
                            continue;
                        sum += SurfaceShading.BrightnessAt(surface, x, y, pixelMm) * SrgbChannel.ToLinear(segments[segment].Color);
                        hits++;
                    }

                    if (hits == 0)
                        continue;
                    int place = Channels * (column + (size * row));
                    colors[place] = SrgbChannel.FromLinear(sum.X / hits);
                    colors[place + 1] = SrgbChannel.FromLinear(sum.Y / hits);
                    colors[place + 2] = SrgbChannel.FromLinear(sum.Z / hits);
                    colors[place + 3] = (byte)(255 * hits / (RaysPerPixel * RaysPerPixel));
                }
            }

            return colors;
        }
    }
}
