using System.Text.Json.Nodes;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>A camera in patient space (LPS).</summary>
    sealed record PerspectiveCamera(PointMm EyeLps, PointMm TargetLps, VectorMm UpLps, double VerticalFovDegrees)
    {
        /// <summary>A camera on an orbit, for a picture of this size.</summary>
        public static PerspectiveCamera Around(VolumeGeometry volume, OrbitCamera orbit, PictureSize size) =>
            new(orbit.EyeAround(volume, (double)size.Width / size.Height), volume.CentreLps, orbit.UpLps, orbit.VerticalFovDegrees);

        public PictureRays Rays(PictureSize size) =>
            PictureRays.Perspective(EyeLps, TargetLps, UpLps, VerticalFovDegrees, size.Width, size.Height);

        /// <summary>The camera as a file for --camera holds it.</summary>
        public JsonObject ToJson() => new()
        {
            ["space"] = "LPS",
            ["eyeMm"] = new JsonArray(EyeLps.X, EyeLps.Y, EyeLps.Z),
            ["targetMm"] = new JsonArray(TargetLps.X, TargetLps.Y, TargetLps.Z),
            ["up"] = new JsonArray(UpLps.X, UpLps.Y, UpLps.Z),
            ["verticalFovDegrees"] = VerticalFovDegrees,
        };
    }
}
