using System;
using System.Collections.Generic;
using System.Threading.Tasks;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// Which segments, with which intensities, lie in each block of 8 x 8 x 8 voxels: what tells, without looking at voxels, where a transfer function shows
    /// nothing and which edits of a carving cannot matter. Blocks are counted with x fastest; the last of an axis may be partly outside the volume. Immutable.
    /// </summary>
    public sealed class BlockContents
    {
        /// <summary>Voxels along a block's edge.</summary>
        public const int BlockSize = 8;

        readonly int[] firstEntry;
        readonly Entry[] entries;

        BlockContents(int[] firstEntry, Entry[] entries)
        {
            this.firstEntry = firstEntry;
            this.entries = entries;
        }

        /// <summary>One segment in one block.</summary>
        public readonly struct Entry
        {
            /// <summary>Makes an entry.</summary>
            public Entry(ushort segment, ushort lowestCode, ushort highestCode)
            {
                Segment = segment;
                LowestCode = lowestCode;
                HighestCode = highestCode;
            }

            /// <summary>Dense segment index.</summary>
            public ushort Segment { get; }

            /// <summary>The smallest intensity code of the segment's voxels in the block.</summary>
            public ushort LowestCode { get; }

            /// <summary>The largest intensity code of the segment's voxels in the block.</summary>
            public ushort HighestCode { get; }
        }

        /// <summary>The number of blocks.</summary>
        public int Count => firstEntry.Length - 1;

        /// <summary>The number of entries of all blocks.</summary>
        public int EntryCount => entries.Length;

        /// <summary>The segments of a block, each once.</summary>
        /// <param name="block">The block's number, 0 to Count - 1.</param>
        /// <exception cref="IndexOutOfRangeException">There is no such block.</exception>
        public ReadOnlySpan<Entry> this[int block] => new ReadOnlySpan<Entry>(entries, firstEntry[block], firstEntry[block + 1] - firstEntry[block]);

        /// <summary>The index of a block's first entry among those of all blocks.</summary>
        internal int FirstEntry(int block) => firstEntry[block];

        /// <summary>Looks at every voxel once, on several threads.</summary>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        /// <exception cref="ArgumentException">The two have different numbers of voxels.</exception>
        public static BlockContents Of(IntensityVolume intensity, LabelMap labels)
        {
            if (intensity == null)
                throw new ArgumentNullException(nameof(intensity));
            if (labels == null)
                throw new ArgumentNullException(nameof(labels));
            if (intensity.Codes.Length != labels.Indices.Length)
                throw new ArgumentException("Intensities and labels have different numbers of voxels.", nameof(labels));
            VolumeGeometry geometry = intensity.Geometry;
            int blocksX = Blocks(geometry.SizeI), blocksY = Blocks(geometry.SizeJ), blocksZ = Blocks(geometry.SizeK);
            var layers = new List<Entry>[blocksZ];
            var first = new int[blocksX * blocksY * blocksZ + 1];
            Parallel.For(0, blocksZ, z =>
            {
                var layer = new List<Entry>(4 * blocksX * blocksY);
                var scan = new BlockScan(geometry, intensity.Codes, labels.Indices, labels.Segments.Count);
                for (int y = 0; y < blocksY; y++)
                    for (int x = 0; x < blocksX; x++)
                        first[x + blocksX * (y + blocksY * z) + 1] = scan.AddTo(layer, x, y, z);
                layers[z] = layer;
            });
            int total = 0;
            for (int block = 1; block < first.Length; block++)
                first[block] = total += first[block];
            var entries = new Entry[total];
            int next = 0;
            foreach (List<Entry> layer in layers)
            {
                layer.CopyTo(entries, next);
                next += layer.Count;
            }
            return new BlockContents(first, entries);
        }

        static int Blocks(int size) => (size + BlockSize - 1) / BlockSize;

        /// <summary>One thread's pass over blocks.</summary>
        sealed class BlockScan
        {
            readonly VolumeGeometry geometry;
            readonly ushort[] codes, labels;
            readonly int[] place; // of each segment among the block's entries, if the stamp is the block's
            readonly int[] stamp;
            readonly List<ushort> segments = new List<ushort>(), lowest = new List<ushort>(), highest = new List<ushort>();
            int block;

            public BlockScan(VolumeGeometry geometry, ushort[] codes, ushort[] labels, int segmentCount)
            {
                this.geometry = geometry;
                this.codes = codes;
                this.labels = labels;
                place = new int[segmentCount];
                stamp = new int[segmentCount];
            }

            /// <returns>The number of entries that were added.</returns>
            public int AddTo(List<Entry> layer, int x, int y, int z)
            {
                block++;
                segments.Clear();
                lowest.Clear();
                highest.Clear();
                int lastI = Math.Min((x + 1) * BlockSize, geometry.SizeI), lastJ = Math.Min((y + 1) * BlockSize, geometry.SizeJ);
                int lastK = Math.Min((z + 1) * BlockSize, geometry.SizeK);
                for (int k = z * BlockSize; k < lastK; k++)
                    for (int j = y * BlockSize; j < lastJ; j++)
                    {
                        long row = (long)geometry.SizeI * (j + (long)geometry.SizeJ * k);
                        for (int i = x * BlockSize; i < lastI; i++)
                            Include(labels[row + i], codes[row + i]);
                    }
                for (int n = 0; n < segments.Count; n++)
                    layer.Add(new Entry(segments[n], lowest[n], highest[n]));
                return segments.Count;
            }

            void Include(ushort segment, ushort code)
            {
                if (stamp[segment] != block)
                {
                    stamp[segment] = block;
                    place[segment] = segments.Count;
                    segments.Add(segment);
                    lowest.Add(code);
                    highest.Add(code);
                    return;
                }
                int n = place[segment];
                if (code < lowest[n])
                    lowest[n] = code;
                if (code > highest[n])
                    highest[n] = code;
            }
        }
    }
}
