using System;
using UnityEngine;

namespace AnatomyCarve.Headless
{
    /// <summary>What a camera leaves in its depth buffer.</summary>
    public static class DepthBuffer
    {
        const double MmPerMetre = 1000;

        /// <summary>
        /// From stored values of a perspective camera, 1 at the near plane and 0 at the far one, to millimetres along each pixel's ray from the eye; a unit of
        /// the scene is a metre.
        /// </summary>
        /// <param name="stored">the values, the bottom row first</param>
        /// <param name="width">pixels of a row</param>
        /// <param name="projection">the camera's projection, as Unity's cameras have it</param>
        /// <param name="near">the distance of the near plane</param>
        /// <param name="far">the distance of the far plane</param>
        /// <returns>as many distances; infinity where nothing was drawn</returns>
        public static float[] ToMillimetres(float[] stored, int width, Matrix4x4 projection, float near, float far)
        {
            ArgumentNullException.ThrowIfNull(stored);
            double height = stored.Length / width, ofNear = 1.0 / near, ofFar = 1.0 / far;
            var distances = new float[stored.Length];
            for (var pixel = 0; pixel < stored.Length; pixel++)
            {
                var x = ((pixel % width + 0.5) / width * 2 - 1 + projection.m02) / projection.m00;
                var y = ((pixel / width + 0.5) / height * 2 - 1 + projection.m12) / projection.m11;
                distances[pixel] = stored[pixel] == 0
                    ? float.PositiveInfinity
                    : (float)(MmPerMetre * Math.Sqrt(1 + x * x + y * y) / (stored[pixel] * (ofNear - ofFar) + ofFar));
            }

            return distances;
        }
    }
}
