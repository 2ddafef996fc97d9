using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>Packs one volume: the blocks of both planes, then the header that lists them.</summary>
    sealed class PackedVolumeWriter
    {
        /// <summary>The most bytes that one array holds.</summary>
        const long LargestArray = 0x7FFFFFC7;

        /// <summary>What transfer function, histogram and counts take of the whole.</summary>
        const float PreparationShare = 0.1f;

        readonly SegmentedVolume volume;
        readonly CancellationToken cancellation;
        readonly IProgress<float> progress;
        readonly byte[][] coded;
        readonly BlockMethod[] methods;
        readonly int blocks;

        internal PackedVolumeWriter(SegmentedVolume volume, CancellationToken cancellation, IProgress<float> progress)
        {
            this.volume = volume;
            this.cancellation = cancellation;
            this.progress = progress;
            blocks = PackedBlocks.Count(volume.Geometry.VoxelCount);
            coded = new byte[2 * blocks][];
            methods = new BlockMethod[2 * blocks];
        }

        internal byte[] Write()
        {
            cancellation.ThrowIfCancellationRequested();
            _ = volume.AutomaticTransferFunction;
            _ = volume.Histogram;
            cancellation.ThrowIfCancellationRequested();
            _ = volume.Labels.VoxelCounts;
            progress?.Report(PreparationShare);
            IProgress<float> rest = progress == null ? null : new Rest(progress);
            BlockWorkers.Run(2 * blocks, BlockWorkers.DefaultThreads, MakeWorker, cancellation, rest);
            byte[] header = PackedHeaderWriter.Write(volume, Directory(0), Directory(blocks));
            byte[] packed = Join(header);
            progress?.Report(1);
            return packed;
        }

        Action<int> MakeWorker()
        {
            int row = volume.Geometry.SizeI;
            var coder = new BlockCoder(row, (long)row * volume.Geometry.SizeJ);
            return piece =>
            {
                ushort[] plane = piece < blocks ? volume.Intensity.Codes : volume.Labels.Indices;
                coded[piece] = coder.Encode(PackedBlocks.Of(plane, piece % blocks), out methods[piece]);
            };
        }

        /// <summary>The blocks of one plane.</summary>
        IReadOnlyList<PackedBlock> Directory(int first) =>
            Enumerable.Range(first, blocks).Select(n => new PackedBlock(methods[n], 0, coded[n].Length, Checksum64.Of(coded[n]))).ToArray();

        byte[] Join(byte[] header)
        {
            long length = header.Length + coded.Sum(block => (long)block.Length);
            if (length > LargestArray)
                throw new AnatomyCarveException(FormattableString.Invariant($"The volume takes {length} bytes when it is packed; at most {LargestArray} can be held."));
            var packed = new byte[length];
            header.CopyTo(packed, 0);
            int place = header.Length;
            for (int n = 0; n < coded.Length; n++)
            {
                coded[n].CopyTo(packed, place);
                place += coded[n].Length;
                coded[n] = null;
            }

            return packed;
        }

        sealed class Rest : IProgress<float>
        {
            readonly IProgress<float> whole;

            internal Rest(IProgress<float> whole) => this.whole = whole;

            public void Report(float value) => whole.Report(PreparationShare + ((1 - PreparationShare) * value));
        }
    }
}
