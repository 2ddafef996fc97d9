using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Work
{
    /// <summary>The box that a volume fills, for counting the rays that meet it.</summary>
    static class VolumeBox
    {
        /// <summary>How many pixels' rays of a picture meet a volume's box.</summary>
        public static long CountRays(PictureRays rays, VolumeGeometry volume)
        {
            long count = 0;
            for (var row = 0; row < rays.Height; row++)
            {
                for (var column = 0; column < rays.Width; column++)
                {
                    if (Meets(rays.RayThroughPixel(column, row), volume)) count++;
                }
            }

            return count;
        }

        static bool Meets(RayMm ray, VolumeGeometry volume)
        {
            var start = volume.LpsToIjk.TransformPoint(ray.Origin);
            var velocity = volume.LpsToIjk.TransformVector(ray.Direction);
            double near = 0, far = double.PositiveInfinity;
            return Narrow(start.X, velocity.X, volume.SizeI, ref near, ref far) && Narrow(start.Y, velocity.Y, volume.SizeJ, ref near, ref far)
                && Narrow(start.Z, velocity.Z, volume.SizeK, ref near, ref far);
        }

        static bool Narrow(double start, double velocity, int size, ref double near, ref double far)
        {
            var (a, b) = ((-0.5 - start) / velocity, (size - 0.5 - start) / velocity);
            near = Math.Max(near, Math.Min(a, b));
            far = Math.Min(far, Math.Max(a, b));
            return near < far;
        }
    }
}
