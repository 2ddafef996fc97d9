using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Picking
{
    /// <summary>
    /// A camera on an orbit around a volume's centre, as far away as it takes to see the whole volume. Azimuth 0, elevation 0 looks into the patient's
    /// face; a growing azimuth goes round to the patient's left (90: seen from the left), a growing elevation up. Immutable.
    /// </summary>
    public sealed class OrbitCamera
    {
        /// <summary>The vertical field of view where none is asked for, degrees.</summary>
        public const double DefaultFovDegrees = 30;

        /// <summary>How much further away than a volume's corners need.</summary>
        const double Margin = 1.02;

        /// <summary>Takes the angles.</summary>
        /// <param name="azimuthDegrees">Around the body's long axis, any finite number: 0 from the front, 90 from the patient's left.</param>
        /// <param name="elevationDegrees">Above the axial plane, -90 (from below) to 90 (from above).</param>
        /// <param name="verticalFovDegrees">Angle from the picture's lower to its upper edge: above 0, below 180.</param>
        /// <exception cref="ArgumentOutOfRangeException">An angle lies outside its range.</exception>
        public OrbitCamera(double azimuthDegrees, double elevationDegrees, double verticalFovDegrees = DefaultFovDegrees)
        {
            if (double.IsNaN(azimuthDegrees) || double.IsInfinity(azimuthDegrees))
                throw new ArgumentOutOfRangeException(nameof(azimuthDegrees), azimuthDegrees, "The azimuth must be finite.");
            if (!(elevationDegrees >= -90 && elevationDegrees <= 90))
                throw new ArgumentOutOfRangeException(nameof(elevationDegrees), elevationDegrees, "The elevation must lie between -90 and 90 degrees.");
            if (!(verticalFovDegrees > 0 && verticalFovDegrees < 180))
                throw new ArgumentOutOfRangeException(
                    nameof(verticalFovDegrees), verticalFovDegrees, "The field of view must lie between 0 and 180 degrees.");
            AzimuthDegrees = azimuthDegrees;
            ElevationDegrees = elevationDegrees;
            VerticalFovDegrees = verticalFovDegrees;

            double azimuth = azimuthDegrees * Math.PI / 180, elevation = elevationDegrees * Math.PI / 180;
            double sinA = Math.Sin(azimuth), cosA = Math.Cos(azimuth), sinE = Math.Sin(elevation), cosE = Math.Cos(elevation);
            // LPS: the patient's face looks to -y, the left is +x, the top of the head +z.
            TowardsEyeLps = new VectorMm(sinA * cosE, -cosA * cosE, sinE);
            UpLps = new VectorMm(-sinA * sinE, cosA * sinE, cosE);
        }

        /// <summary>Around the body's long axis, degrees: 0 from the front, 90 from the patient's left.</summary>
        public double AzimuthDegrees { get; }

        /// <summary>Above the axial plane, degrees, -90 to 90.</summary>
        public double ElevationDegrees { get; }

        /// <summary>Angle from the picture's lower to its upper edge, degrees.</summary>
        public double VerticalFovDegrees { get; }

        /// <summary>From the volume's centre to the eye, of length 1, LPS.</summary>
        public VectorMm TowardsEyeLps { get; }

        /// <summary>What is up in the picture, of length 1, LPS.</summary>
        public VectorMm UpLps { get; }

        /// <summary>The place on the orbit from which a picture shows all of a volume, LPS millimetres.</summary>
        /// <param name="volume">What is to be seen; its outermost voxels count to their outer faces.</param>
        /// <param name="aspect">The picture's width over its height: above 0 and finite.</param>
        /// <exception cref="ArgumentNullException"><paramref name="volume"/> is null.</exception>
        /// <exception cref="ArgumentOutOfRangeException"><paramref name="aspect"/> lies outside its range.</exception>
        public PointMm EyeAround(VolumeGeometry volume, double aspect)
        {
            if (volume == null)
                throw new ArgumentNullException(nameof(volume));
            if (!(aspect > 0) || double.IsInfinity(aspect))
                throw new ArgumentOutOfRangeException(nameof(aspect), aspect, "The picture's aspect is above 0 and finite.");
            VectorMm right = UpLps.Cross(TowardsEyeLps);
            double tanY = Math.Tan(VerticalFovDegrees * (Math.PI / 360));
            double tanX = tanY * aspect;
            double distance = 0;
            for (int corner = 0; corner < VolumeGeometry.Corners; corner++)
            {
                VectorMm offset = volume.CornerOffset(corner);
                double needed = Math.Max(Math.Abs(offset.Dot(right)) / tanX, Math.Abs(offset.Dot(UpLps)) / tanY);
                distance = Math.Max(distance, needed * Margin + offset.Dot(TowardsEyeLps));
            }
            return volume.CentreLps + TowardsEyeLps * distance;
        }

        /// <summary>The rays of a picture that shows all of a volume.</summary>
        /// <param name="volume">What is to be seen.</param>
        /// <param name="width">Pixels, 1 to <see cref="PictureRays.MaxSize"/>.</param>
        /// <param name="height">Pixels, 1 to <see cref="PictureRays.MaxSize"/>.</param>
        /// <exception cref="ArgumentNullException"><paramref name="volume"/> is null.</exception>
        /// <exception cref="ArgumentException">A size lies outside its range.</exception>
        public PictureRays RaysAround(VolumeGeometry volume, int width, int height) => PictureRays.Perspective(
            EyeAround(volume, (double)width / height), volume.CentreLps, UpLps, VerticalFovDegrees, width, height);
    }
}
