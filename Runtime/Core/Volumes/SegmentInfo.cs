using System;
using System.Collections.Generic;

namespace AnatomyCarve.Volumes
{
    /// <summary>A segment as a file names it: which value in which layer means it. Immutable.</summary>
    public sealed class SegmentInfo
    {
        /// <summary>Makes a segment's description.</summary>
        /// <param name="id">The file's identifier, unique in the file; may be empty.</param>
        /// <param name="name">The name to show; may be empty.</param>
        /// <param name="labelValue">The value of its voxels; 0 is never a segment in 3D Slicer.</param>
        /// <param name="layer">The component that holds it, from 0.</param>
        /// <param name="color">Its colour, or null when the file has none.</param>
        /// <param name="tags">Further facts as the file writes them ("key:value|key:value"); may be empty.</param>
        /// <param name="extent">First and last index along i, j, k ("i0 i1 j0 j1 k0 k1"), or null when the file has none.</param>
        public SegmentInfo(
            string id, string name, long labelValue, int layer = 0, SegmentColor? color = null, string tags = "", int[] extent = null)
        {
            if (layer < 0)
                throw new ArgumentOutOfRangeException(nameof(layer), layer, "A layer is 0 or more.");
            Id = id ?? string.Empty;
            Name = name ?? string.Empty;
            LabelValue = labelValue;
            Layer = layer;
            Color = color;
            Tags = tags ?? string.Empty;
            Extent = extent == null ? Array.AsReadOnly(Array.Empty<int>()) : Array.AsReadOnly((int[])extent.Clone());
        }

        /// <summary>The file's identifier; may be empty.</summary>
        public string Id { get; }

        /// <summary>The name to show; may be empty.</summary>
        public string Name { get; }

        /// <summary>The value of its voxels.</summary>
        public long LabelValue { get; }

        /// <summary>The component that holds it, from 0.</summary>
        public int Layer { get; }

        /// <summary>Its colour, or null when the file has none (or one that can't be read).</summary>
        public SegmentColor? Color { get; }

        /// <summary>3D Slicer's tags ("key:value|key:value", among them its terminology); may be empty.</summary>
        public string Tags { get; }

        /// <summary>First and last index along i, j, k (six numbers, inclusive), as the file says; empty when it says none.</summary>
        public IReadOnlyList<int> Extent { get; }

        /// <summary>Name, value and layer.</summary>
        public override string ToString() => FormattableString.Invariant($"{Name} (value {LabelValue}, layer {Layer})");
    }
}
