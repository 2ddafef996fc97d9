using System;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Formats;
using AnatomyCarve.Volumes;

namespace AnatomyCarve
{
    /// <summary>A volume out of an asset. Where it has to get coarser, the whole of it is never in memory.</summary>
    sealed class AssetOpening : VolumeOpening
    {
        readonly VolumeAsset asset;

        public AssetOpening(VolumeAsset asset) => this.asset = asset;

        public override Task<MemoryForecast> ForecastAsync(VolumeLimits limits, CancellationToken cancellationToken, IProgress<float> progress) =>
            Task.FromResult(MemoryForecast.Of(asset, limits));

        public override Task<SegmentedVolume> ReadAsync(LoadPlan plan, CancellationToken cancellationToken, IProgress<float> progress)
        {
            ReadOnlyMemory<byte> packed = asset.Open();
            string name = asset.name;
            return Task.Run(() => Read(packed, name, plan, cancellationToken, progress), cancellationToken);
        }

        static SegmentedVolume Read(ReadOnlyMemory<byte> packed, string name, LoadPlan plan, CancellationToken cancellationToken, IProgress<float> progress)
        {
            PackedVolumeReader reader = PackedVolume.Open(packed, name);
            VolumeGeometry grid = reader.Info.Geometry;
            VoxelFactors factors = plan.Factors(grid, reader.Info.SegmentCount, name);
            VolumeGeometry loaded = factors.Apply(grid);
            plan.ShowCoarse(loaded, grid, coarse => reader.ReadCoarse(coarse, CellSlices.Middle, cancellationToken));
            SegmentedVolume volume = reader.ReadCoarse(factors, CellSlices.All, cancellationToken, progress);
            _ = volume.Blocks; // here, so that the main thread need not wait for it
            return factors.AreOne ? volume : volume.WithWarning(plan.Warning(grid, reader.Info.SegmentCount, loaded, name));
        }
    }
}
