using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>The two bytes of a stored normal (Shaders/Octahedral.hlsl), in double precision.</summary>
    static class Octahedral
    {
        const double HalfRange = 127;

        /// <summary>A unit vector; (0, 0, 0) for the codes 0, 0.</summary>
        public static VectorMm Decode(byte first, byte second)
        {
            if (first + second == 0) return default;
            var (x, y) = ((first - HalfRange) / HalfRange, (second - HalfRange) / HalfRange);
            var z = 1 - Math.Abs(x) - Math.Abs(y);
            if (z < 0) (x, y) = ((1 - Math.Abs(y)) * Sign(x), (1 - Math.Abs(x)) * Sign(y));
            return new VectorMm(x, y, z).Normalized();
        }

        /// <summary>The codes nearest in the map to a unit vector.</summary>
        public static (byte First, byte Second) Encode(VectorMm direction)
        {
            var sum = Math.Abs(direction.X) + Math.Abs(direction.Y) + Math.Abs(direction.Z);
            var (x, y) = (direction.X / sum, direction.Y / sum);
            if (direction.Z < 0) (x, y) = ((1 - Math.Abs(y)) * Sign(x), (1 - Math.Abs(x)) * Sign(y));
            var (first, second) = (Code(x), Code(y));
            return first + second == 0 ? ((byte)254, (byte)254) : (first, second);
        }

        static byte Code(double coordinate) => (byte)(Math.Floor(coordinate * HalfRange + 0.5) + HalfRange);

        static double Sign(double value) => value < 0 ? -1 : 1;
    }
}
