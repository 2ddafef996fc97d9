using System;
using System.IO;
using UnityEngine;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Editor
{
    /// <summary>The two pictures of the verification: what a camera draws, and what the kernel renders for the same camera.</summary>
    static class VerificationPictures
    {
        const int Width = 1280, Height = 720, DepthBits = 24;

        /// <summary>The smallest mean difference from the background that counts as something drawn.</summary>
        const float SmallestDifference = 0.02f;

        /// <summary>The largest mean difference of two pictures of the same thing. Lights, fog and effects of the scene do not touch the volume.</summary>
        const float LargestDifference = 0.05f;

        /// <summary>Writes game.png and kernel.png and fills the report in.</summary>
        public static void Take(Camera camera, CarvedVolumeRenderer renderer, string folder, VerificationReport report)
        {
            RenderTexture before = camera.targetTexture;
            RenderTexture target = RenderTexture.GetTemporary(Width, Height, DepthBits, RenderTextureFormat.ARGB32, RenderTextureReadWrite.Default);
            try
            {
                camera.targetTexture = target; // both pictures have its aspect
                camera.Render();
                Color32[] game = Save(target, Path.Combine(folder, "game.png"));
                CarvedPicture picture = renderer.Render(camera, Width, Height);
                if (picture == null)
                    report.failures.Add("The kernel rendered no picture: " + (renderer.Problem ?? "there is nothing to show."));
                else
                    Compare(game, picture.Read(), camera.backgroundColor, folder, report);
            }
            finally
            {
                camera.targetTexture = before;
                RenderTexture.ReleaseTemporary(target);
            }
        }

        static void Compare(Color32[] game, PictureData kernel, Color background, string folder, VerificationReport report)
        {
            File.WriteAllBytes(Path.Combine(folder, "kernel.png"), kernel.EncodeToPng(background));
            var check = new PictureCheck(game, Pixels(kernel.ToSrgb(background)), kernel.Segments, background);
            report.pictureWidth = Width;
            report.pictureHeight = Height;
            report.pixelsWithSegment = check.Covered;
            report.differenceFromKernel = check.DifferenceFromKernel;
            report.differenceFromBackground = check.DifferenceFromBackground;
            if (check.Covered == 0)
                report.failures.Add("The kernel's picture shows no segment: the camera does not look at the volume.");
            else if (check.DifferenceFromBackground < SmallestDifference)
                report.failures.Add("The camera drew only its background where the kernel's picture shows the volume.");
            else if (check.DifferenceFromKernel > LargestDifference)
                report.failures.Add($"game.png and kernel.png differ by {check.DifferenceFromKernel:0.000} where the volume is; at most {LargestDifference} is expected.");
        }

        static Color32[] Save(RenderTexture target, string path)
        {
            RenderTexture before = RenderTexture.active;
            var image = new Texture2D(Width, Height, TextureFormat.RGBA32, false);
            try
            {
                RenderTexture.active = target;
                image.ReadPixels(new Rect(0f, 0f, Width, Height), 0, 0);
                image.Apply();
                File.WriteAllBytes(path, image.EncodeToPNG());
                return image.GetPixels32();
            }
            finally
            {
                RenderTexture.active = before;
                Object.DestroyImmediate(image);
            }
        }

        static Color32[] Pixels(byte[] rgba)
        {
            var pixels = new Color32[rgba.Length / 4];
            for (int p = 0; p < pixels.Length; p++)
                pixels[p] = new Color32(rgba[4 * p], rgba[4 * p + 1], rgba[4 * p + 2], rgba[4 * p + 3]);
            return pixels;
        }
    }
}
