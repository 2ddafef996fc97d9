using System;

namespace AnatomyCarve.Headless.Cli.Bench.Error.Reference
{
    /// <summary>IEC 61966-2-1 in double precision.</summary>
    static class SrgbCurve
    {
        public static double ToLinear(double encoded) => encoded <= 0.04045 ? encoded / 12.92 : Math.Pow((encoded + 0.055) / 1.055, 2.4);

        /// <summary>What is beyond 0..1 is cut off.</summary>
        public static double ToEncoded(double linear)
        {
            var c = Math.Clamp(linear, 0, 1);
            return c <= 0.0031308 ? 12.92 * c : 1.055 * Math.Pow(c, 1 / 2.4) - 0.055;
        }
    }
}
