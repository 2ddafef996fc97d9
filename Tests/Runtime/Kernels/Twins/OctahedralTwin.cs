using System;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>Reads the kernels' two-byte directions, in double precision.</summary>
    static class OctahedralTwin
    {
        /// <summary>The unit vector of two codes; null for (0, 0), "no direction".</summary>
        public static double[] Decode(byte x, byte y)
        {
            if (x == 0 && y == 0)
                return null;
            double u = (x - 127) / 127.0, v = (y - 127) / 127.0, z = 1 - Math.Abs(u) - Math.Abs(v);
            double[] direction = z >= 0
                ? new[] { u, v, z }
                : new[] { (1 - Math.Abs(v)) * (u < 0 ? -1 : 1), (1 - Math.Abs(u)) * (v < 0 ? -1 : 1), z };
            return Normalized(direction);
        }

        public static double[] Normalized(double[] v)
        {
            double length = Math.Sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            return new[] { v[0] / length, v[1] / length, v[2] / length };
        }

        /// <summary>The angle between two unit vectors, degrees; exact for small angles too.</summary>
        public static double DegreesBetween(double[] a, double[] b)
        {
            double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
            return Math.Atan2(Math.Sqrt(x * x + y * y + z * z), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 180 / Math.PI;
        }
    }
}
