using System;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>What a loader is to load by itself. An asset that was imported anew is another one.</summary>
    readonly struct StartSource : IEquatable<StartSource>
    {
        readonly long checksum;

        public StartSource(VolumeAsset asset, string intensityPath, string labelsPath, bool wanted)
        {
            IsSet = true;
            Asset = wanted ? asset : null;
            checksum = Asset != null ? Asset.Checksum : 0;
            IntensityPath = wanted ? intensityPath : "";
            LabelsPath = wanted ? labelsPath : "";
        }

        /// <summary>False for the default: nobody has looked yet.</summary>
        public bool IsSet { get; }

        /// <summary>Comes before files.</summary>
        public VolumeAsset Asset { get; }

        public string IntensityPath { get; }

        public string LabelsPath { get; }

        /// <summary>Whether there is something to load.</summary>
        public bool HasSource => Asset != null || IntensityPath.Length > 0;

        /// <summary>Has a loader load it. What goes wrong is logged.</summary>
        public async void LoadInto(VolumeLoader loader)
        {
            try
            {
                await (Asset != null ? loader.LoadAsync(Asset) : loader.LoadAsync(IntensityPath, LabelsPath));
            }
            catch (OperationCanceledException)
            {
                // Another load took its place, or the scene ended.
            }
            catch (Exception e)
            {
                Debug.LogException(e, loader);
            }
        }

        public bool Equals(StartSource other) =>
            IsSet == other.IsSet && Asset == other.Asset && checksum == other.checksum && IntensityPath == other.IntensityPath && LabelsPath == other.LabelsPath;

        public override bool Equals(object obj) => obj is StartSource other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(IntensityPath, LabelsPath);
    }
}
