using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using AnatomyCarve.Carving;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// A carving on the GPU: one row per sphere, and the words of the masks. Buffers grow and are never made smaller; what cannot clip anything
    /// (radius 0, empty mask) is left out.
    /// </summary>
    sealed class SphereBuffers : IDisposable
    {
        /// <summary>Spheres that there is room for at first.</summary>
        const int FirstRows = 16;

        readonly CentredGrid grid;
        readonly int wordsPerMask;
        SphereRow[] rows = new SphereRow[FirstRows];
        uint[] words;

        public SphereBuffers(CentredGrid grid, int segmentCount)
        {
            this.grid = grid;
            wordsPerMask = WordsFor(segmentCount);
            words = new uint[FirstRows * wordsPerMask];
        }

        /// <summary>The bytes of both buffers while there are no more spheres than there is room for at first.</summary>
        public static long FirstBytesOf(int segmentCount) => (long)FirstRows * (Marshal.SizeOf<SphereRow>() + sizeof(uint) * WordsFor(segmentCount));

        public GraphicsBuffer Spheres { get; private set; }

        public GraphicsBuffer MaskWords { get; private set; }

        /// <summary>The number of rows in use.</summary>
        public int Count { get; private set; }

        public int WordsPerMask => wordsPerMask;

        public bool IsValid => Spheres != null && Spheres.IsValid() && MaskWords != null && MaskWords.IsValid();

        public void Upload(IReadOnlyList<ClipSphere> spheres)
        {
            Reserve(spheres.Count);
            int count = 0;
            for (int s = 0; s < spheres.Count; s++)
            {
                ClipSphere sphere = spheres[s];
                if (!sphere.CanClip)
                    continue;
                SphereF centred = grid.ToCentred(sphere);
                rows[count].CentreRadius = new Vector4(centred.X, centred.Y, centred.Z, centred.Radius);
                rows[count].MaskOffset = (uint)(count * wordsPerMask);
                sphere.Mask.CopyWordsTo(words, count * wordsPerMask);
                count++;
            }
            Count = count;
            if (count > 0)
            {
                Spheres.SetData(rows, 0, 0, count);
                MaskWords.SetData(words, 0, 0, count * wordsPerMask);
            }
        }

        public void AddSizes(List<ResourceSize> sizes)
        {
            if (Spheres == null)
                return;
            sizes.Add(new ResourceSize(SpheresName, (long)Spheres.count * Spheres.stride));
            sizes.Add(new ResourceSize(MaskWordsName, (long)MaskWords.count * MaskWords.stride));
        }

        public void Dispose()
        {
            Spheres?.Release();
            MaskWords?.Release();
            Spheres = null;
            MaskWords = null;
        }

        const string SpheresName = "AnatomyCarve clip spheres";
        const string MaskWordsName = "AnatomyCarve clip masks";

        static int WordsFor(int segmentCount) => (segmentCount + 31) / 32;

        void Reserve(int count)
        {
            int capacity = rows.Length;
            while (capacity < count)
                capacity *= 2;
            if (IsValid && capacity == rows.Length)
                return;
            if (capacity > rows.Length)
            {
                rows = new SphereRow[capacity];
                words = new uint[capacity * wordsPerMask];
            }
            Dispose();
            Spheres = GpuObjects.CreateBuffer(SpheresName, rows.Length, Marshal.SizeOf<SphereRow>());
            MaskWords = GpuObjects.CreateBuffer(MaskWordsName, words.Length, sizeof(uint));
        }

        /// <summary><c>SphereRow</c> of <c>Shaders/VolumeLayout.hlsl</c>, 32 bytes.</summary>
        [StructLayout(LayoutKind.Sequential)]
        struct SphereRow
        {
            public Vector4 CentreRadius;
            public uint MaskOffset;
            public uint Unused1;
            public uint Unused2;
            public uint Unused3;
        }
    }
}
