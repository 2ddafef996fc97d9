using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using AnatomyCarve.Carving;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// A carving on the GPU: by slot of its <see cref="SphereIndex"/> a row per sphere and the words of its mask. Buffers grow and are never made smaller; an
    /// edit uploads the slots that it filled.
    /// </summary>
    sealed class SphereBuffers : IDisposable
    {
        const string SpheresName = "AnatomyCarve clip spheres";
        const string MaskWordsName = "AnatomyCarve clip masks";

        /// <summary>Spheres that there is room for at first.</summary>
        const int FirstRows = 16;

        readonly SphereIndex index;
        readonly int wordsPerMask;
        SphereRow[] rows = new SphereRow[FirstRows];
        uint[] words;

        public SphereBuffers(SphereIndex index, int segmentCount)
        {
            this.index = index;
            wordsPerMask = WordsFor(segmentCount);
            words = new uint[FirstRows * wordsPerMask];
        }

        /// <summary>The bytes of both buffers while there are no more spheres than there is room for at first.</summary>
        public static long FirstBytesOf(int segmentCount) => (long)FirstRows * (Marshal.SizeOf<SphereRow>() + sizeof(uint) * WordsFor(segmentCount));

        public GraphicsBuffer Spheres { get; private set; }

        public GraphicsBuffer MaskWords { get; private set; }

        public int WordsPerMask => wordsPerMask;

        public bool IsValid => Spheres != null && Spheres.IsValid() && MaskWords != null && MaskWords.IsValid();

        /// <summary>Uploads the slots that changed last, or all of them where the buffers had to be made.</summary>
        /// <exception cref="Volumes.AnatomyCarveException">The device could not make the buffers.</exception>
        public void Upload()
        {
            if (Reserve(index.SlotCount))
            {
                for (int slot = 0; slot < index.SlotCount; slot++)
                    Fill(slot);
                if (index.SlotCount > 0)
                {
                    Spheres.SetData(rows, 0, 0, index.SlotCount);
                    MaskWords.SetData(words, 0, 0, index.SlotCount * wordsPerMask);
                }
                return;
            }
            IReadOnlyList<int> changed = index.ChangedSlots;
            for (int n = 0; n < changed.Count; n++)
            {
                Fill(changed[n]);
                Spheres.SetData(rows, changed[n], changed[n], 1);
                MaskWords.SetData(words, changed[n] * wordsPerMask, changed[n] * wordsPerMask, wordsPerMask);
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

        void Fill(int slot)
        {
            SphereF place = index.PlaceOf(slot);
            rows[slot].CentreRadius = new Vector4(place.X, place.Y, place.Z, place.Radius);
            int first = slot * wordsPerMask;
            index.MaskOf(slot).CopyWordsTo(words, first);
            rows[slot].MaskOffset = (uint)first;
            rows[slot].MaskWord0 = words[first];
            rows[slot].MaskWord1 = wordsPerMask > 1 ? words[first + 1] : 0;
            rows[slot].MaskWord2 = wordsPerMask > 2 ? words[first + 2] : 0;
        }

        static int WordsFor(int segmentCount) => (segmentCount + 31) / 32;

        /// <returns>Whether the buffers are new and empty.</returns>
        bool Reserve(int count)
        {
            int capacity = rows.Length;
            while (capacity < count)
                capacity *= 2;
            if (IsValid && capacity == rows.Length)
                return false;
            if (capacity > rows.Length)
            {
                Array.Resize(ref rows, capacity);
                Array.Resize(ref words, capacity * wordsPerMask);
            }
            Dispose();
            Spheres = GpuObjects.CreateBuffer(SpheresName, rows.Length, Marshal.SizeOf<SphereRow>());
            MaskWords = GpuObjects.CreateBuffer(MaskWordsName, words.Length, sizeof(uint));
            return true;
        }

        /// <summary><c>SphereRow</c> of <c>Shaders/VolumeLayout.hlsl</c>, 32 bytes.</summary>
        [StructLayout(LayoutKind.Sequential)]
        struct SphereRow
        {
            public Vector4 CentreRadius;
            public uint MaskOffset;
            public uint MaskWord0;
            public uint MaskWord1;
            public uint MaskWord2;
        }
    }
}
