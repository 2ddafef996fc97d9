using System;
using System.Collections.Generic;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve
{
    /// <summary>
    /// The two tables that kernels look up: the opacity transfer function (R32_SFloat, 4096 x 1) and the segments' linear colours with their
    /// opacities (R32G32B32A32_SFloat, 1024 segments a row).
    /// </summary>
    sealed class LookupTextures : IDisposable
    {
        /// <summary>Segments in a row of the colour table, as <c>Shaders/VolumeLayout.hlsl</c> has it.</summary>
        public const int SegmentsPerRow = 1024;

        readonly Color[] colors;

        public LookupTextures(int segmentCount)
        {
            int rows = Rows(segmentCount);
            try
            {
                TransferFunction = Create("transfer function", OpacityLookup.LastEntry + 1, 1, GraphicsFormat.R32_SFloat);
                SegmentColors = Create("segment colours", SegmentsPerRow, rows, GraphicsFormat.R32G32B32A32_SFloat);
                colors = new Color[rows * SegmentsPerRow];
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>The bytes of both tables for so many segments.</summary>
        public static long BytesOf(int segmentCount) => 4L * (OpacityLookup.LastEntry + 1) + 16L * SegmentsPerRow * Rows(segmentCount);

        public Texture2D TransferFunction { get; }

        public Texture2D SegmentColors { get; }

        public bool Exist => TransferFunction != null && SegmentColors != null;

        public void Upload(OpacityTransferFunction transferFunction)
        {
            TransferFunction.SetPixelData(transferFunction.Lookup(), 0);
            TransferFunction.Apply(false, false);
        }

        /// <summary>Colours are sRGB in the table and linear on the GPU.</summary>
        public void Upload(SegmentTable segments)
        {
            for (int s = 0; s < segments.Count; s++)
            {
                SegmentColor color = segments[s].Color;
                Color linear = new Color(color.RedFloat, color.GreenFloat, color.BlueFloat).linear;
                linear.a = segments[s].Opacity;
                colors[s] = linear;
            }
            SegmentColors.SetPixelData(colors, 0);
            SegmentColors.Apply(false, false);
        }

        public void AddSizes(List<ResourceSize> sizes)
        {
            sizes.Add(new ResourceSize(TransferFunction.name, 4L * TransferFunction.width * TransferFunction.height));
            sizes.Add(new ResourceSize(SegmentColors.name, 16L * SegmentColors.width * SegmentColors.height));
        }

        public void Dispose()
        {
            GpuObjects.Destroy(TransferFunction);
            GpuObjects.Destroy(SegmentColors);
        }

        static int Rows(int segmentCount) => (segmentCount + SegmentsPerRow - 1) / SegmentsPerRow;

        static Texture2D Create(string name, int width, int height, GraphicsFormat format)
        {
            var texture = new Texture2D(width, height, format, TextureCreationFlags.None);
            if (texture == null)
                throw new AnatomyCarveException($"The device could not make the {name} texture ({width} x {height}, {format}).");
            texture.name = "AnatomyCarve " + name;
            texture.filterMode = FilterMode.Point;
            texture.wrapMode = TextureWrapMode.Clamp;
            texture.hideFlags = HideFlags.HideAndDontSave;
            return texture;
        }
    }
}
