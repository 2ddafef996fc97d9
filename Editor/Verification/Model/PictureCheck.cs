using System;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>What a camera's picture says where the kernel shows a segment: the volume, or only the background.</summary>
    readonly struct PictureCheck
    {
        const float Largest = 3f * 255f;

        /// <param name="game">The camera's picture.</param>
        /// <param name="kernel">What the kernel made of the same view, of the same size.</param>
        /// <param name="segments">First visible segment of each pixel of the kernel's picture.</param>
        /// <param name="background">What the camera cleared its picture with.</param>
        /// <exception cref="ArgumentException">The pictures differ in size.</exception>
        public PictureCheck(Color32[] game, Color32[] kernel, ushort[] segments, Color32 background)
        {
            if (game.Length != kernel.Length || kernel.Length != segments.Length)
                throw new ArgumentException($"Pictures of {game.Length}, {kernel.Length} and {segments.Length} pixels can't be compared.", nameof(kernel));
            double fromKernel = 0, fromBackground = 0;
            int covered = 0;
            for (int p = 0; p < segments.Length; p++)
            {
                if (segments[p] == PictureData.NoSegment)
                    continue;
                covered++;
                fromKernel += Difference(game[p], kernel[p]);
                fromBackground += Difference(game[p], background);
            }
            Covered = covered;
            DifferenceFromKernel = covered == 0 ? 0f : (float)(fromKernel / covered);
            DifferenceFromBackground = covered == 0 ? 0f : (float)(fromBackground / covered);
        }

        /// <summary>Pixels where the kernel shows a segment.</summary>
        public int Covered { get; }

        /// <summary>Mean difference of the two pictures there: 0 (the same) to 1 (black and white).</summary>
        public float DifferenceFromKernel { get; }

        /// <summary>Mean difference of the camera's picture there from its background: 0 = the camera drew nothing.</summary>
        public float DifferenceFromBackground { get; }

        static float Difference(Color32 a, Color32 b) => (Math.Abs(a.r - b.r) + Math.Abs(a.g - b.g) + Math.Abs(a.b - b.b)) / Largest;
    }
}
