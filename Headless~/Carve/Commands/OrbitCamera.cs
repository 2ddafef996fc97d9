using System;
using System.Globalization;
using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Commands;

/// <summary>
/// A camera on an orbit around a volume's centre, as far away as it takes to see the whole volume. Azimuth 0, elevation 0 looks
/// into the patient's face; a growing azimuth goes round to the patient's left (90: seen from the left), a growing elevation up.
/// </summary>
internal sealed record OrbitCamera(double AzimuthDegrees, double ElevationDegrees, double VerticalFovDegrees)
{
    public const double DefaultFovDegrees = 30;
    private const double Margin = 1.02;

    /// <summary>Parses "AZIMUTH,ELEVATION[,FOV]"; null if the text is something else.</summary>
    public static OrbitCamera TryParse(string text)
    {
        var numbers = text.Split(',').Select(word => double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out var number)
            ? number : double.NaN).ToArray();
        if (numbers.Length is not (2 or 3) || !numbers.All(double.IsFinite)) return null;
        return new OrbitCamera(numbers[0], numbers[1], numbers.Length == 3 ? numbers[2] : DefaultFovDegrees);
    }

    /// <summary>What is wrong with the angles, or null.</summary>
    public string Problem => ElevationDegrees is < -90 or > 90 ? "the elevation must lie between -90 and 90 degrees"
        : VerticalFovDegrees is not (> 0 and < 180) ? "the field of view must lie between 0 and 180 degrees"
        : null;

    /// <summary>The place on the orbit from which a picture of this size shows all of the volume.</summary>
    public PerspectiveCamera Around(VolumeGeometry volume, PictureSize size)
    {
        double azimuth = AzimuthDegrees * Math.PI / 180, elevation = ElevationDegrees * Math.PI / 180;
        var (sinA, cosA) = Math.SinCos(azimuth);
        var (sinE, cosE) = Math.SinCos(elevation);
        // LPS: the patient's face looks to -y, the left is +x, the top of the head +z.
        var towardsEye = new VectorMm(sinA * cosE, -cosA * cosE, sinE);
        var up = new VectorMm(-sinA * sinE, cosA * sinE, cosE);
        var right = up.Cross(towardsEye);
        var tanY = Math.Tan(VerticalFovDegrees * Math.PI / 360);
        var tanX = tanY * size.Width / size.Height;

        var distance = 0.0;
        for (var corner = 0; corner < 8; corner++)
        {
            var offset = volume.IjkToLps.TransformPoint(new PointMm(
                (corner & 1) == 0 ? -0.5 : volume.SizeI - 0.5,
                (corner & 2) == 0 ? -0.5 : volume.SizeJ - 0.5,
                (corner & 4) == 0 ? -0.5 : volume.SizeK - 0.5)) - volume.CentreLps;
            var needed = Math.Max(Math.Abs(offset.Dot(right)) / tanX, Math.Abs(offset.Dot(up)) / tanY);
            distance = Math.Max(distance, needed * Margin + offset.Dot(towardsEye));
        }

        return new PerspectiveCamera(volume.CentreLps + towardsEye * distance, volume.CentreLps, up, VerticalFovDegrees);
    }
}
