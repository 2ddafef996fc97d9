using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Runtime.InteropServices;
using System.Threading;
using AnatomyCarve.Formats;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench
{
    /// <summary>A file's content under its name.</summary>
    sealed record NamedContent(string Name, byte[] Bytes);

    /// <summary>One way to load: milliseconds of each run, and the bytes that one run allocated.</summary>
    sealed record LoadTimes(string Way, double[] Milliseconds, long AllocatedBytes)
    {
        public double Median
        {
            get
            {
                var sorted = Milliseconds.Order().ToArray();
                return (sorted[(sorted.Length - 1) / 2] + sorted[sorted.Length / 2]) / 2;
            }
        }
    }

    /// <summary>What a comparison found.</summary>
    /// <param name="Volume">the volume</param>
    /// <param name="Info">what the packed volume says of itself</param>
    /// <param name="FileBytes">the bytes of the files</param>
    /// <param name="GzipBytes">codes and label indices, 16 bits each, as gzip makes them at level 6</param>
    /// <param name="PackMilliseconds">how long packing took, once</param>
    /// <param name="Files">loading the files</param>
    /// <param name="Packed">loading the packed volume, by threads</param>
    sealed record LoadComparison(
        SegmentedVolume Volume, PackedVolumeInfo Info, long FileBytes, long GzipBytes, double PackMilliseconds, LoadTimes Files, LoadTimes[] Packed);

    /// <summary>
    /// Loads the same volume from its files and from a packed volume, by turns, so that what else the machine does meets both. All bytes are in memory
    /// before; a load ends with everything that a loader prepares: codes, label indices, transfer function.
    /// </summary>
    static class LoadBench
    {
        /// <summary>.NET compiles methods anew, and better, once they have been called often.</summary>
        const int WarmUps = 5;

        public static LoadComparison Run(
            NamedContent scan, NamedContent labels, int runs, IReadOnlyList<int> threads, IProgress<float> progress, CancellationToken cancellation)
        {
            var volume = ReadFiles(scan, labels, cancellation);
            var clock = Stopwatch.StartNew();
            var packed = PackedVolume.Write(volume, cancellation);
            var packMilliseconds = clock.Elapsed.TotalMilliseconds;
            CheckEqual(volume, PackedVolume.Read(packed, scan.Name, cancellation));

            var ways = new List<(string Name, Func<SegmentedVolume> Load)> { ("files", () => ReadFiles(scan, labels, cancellation)) };
            ways.AddRange(threads.Select(count => (
                count == 1 ? "packed, 1 thread" : $"packed, {count} threads", (Func<SegmentedVolume>)(() => PackedVolume.Read(packed, scan.Name, count, cancellation)))));
            var times = ways.Select(_ => new double[runs]).ToArray();
            var allocated = new long[ways.Count];

            // The first runs are not counted: they compile.
            for (var run = -WarmUps; run < runs; run++)
            {
                for (var way = 0; way < ways.Count; way++)
                {
                    cancellation.ThrowIfCancellationRequested();
                    var milliseconds = Measure(ways[way].Load, out allocated[way]);
                    if (run >= 0) times[way][run] = milliseconds;
                }

                progress.Report((run + 1f + WarmUps) / (runs + WarmUps));
            }

            var loads = ways.Select((way, number) => new LoadTimes(way.Name, times[number], allocated[number])).ToArray();
            return new LoadComparison(
                volume, PackedVolume.ReadInfo(packed, scan.Name), scan.Bytes.LongLength + (labels?.Bytes.LongLength ?? 0),
                GzipBytes(volume.Intensity.Codes) + GzipBytes(volume.Labels.Indices), packMilliseconds, loads[0], loads[1..]);
        }

        /// <summary>What the package's loader does with a pair of files.</summary>
        static SegmentedVolume ReadFiles(NamedContent scan, NamedContent labels, CancellationToken cancellation) =>
            SegmentedVolumeReader.Read(Source(scan), labels == null ? null : Source(labels), cancellation, null);

        static VolumeSource Source(NamedContent content) => VolumeSource.OfContent(content.Bytes, content.Name);

        static double Measure(Func<SegmentedVolume> load, out long allocated)
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
            var before = GC.GetTotalAllocatedBytes(precise: true);
            var clock = Stopwatch.StartNew();
            var volume = load();
            var milliseconds = clock.Elapsed.TotalMilliseconds;
            allocated = GC.GetTotalAllocatedBytes(precise: true) - before;
            GC.KeepAlive(volume);
            return milliseconds;
        }

        // What is compared has to be the same.
        static void CheckEqual(SegmentedVolume a, SegmentedVolume b)
        {
            if (!a.Intensity.Codes.AsSpan().SequenceEqual(b.Intensity.Codes) || !a.Labels.Indices.AsSpan().SequenceEqual(b.Labels.Indices))
            {
                throw new CommandException("the packed volume is not the one of the files; this is a fault of the package.");
            }
        }

        static long GzipBytes(ushort[] plane)
        {
            using var counted = new MemoryStream();
            using (var gzip = new GZipStream(counted, CompressionLevel.Optimal, leaveOpen: true)) gzip.Write(MemoryMarshal.AsBytes(plane.AsSpan()));
            return counted.Length;
        }
    }
}
