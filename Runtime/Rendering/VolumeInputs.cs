using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>Everything that decides what a volume looks like at a moment, but for who looks at it.</summary>
    readonly struct VolumeInputs
    {
        public VolumeInputs(
            SegmentedVolume volume, in Matrix4x4 toWorld, CarvingSnapshot carving, OpacityTransferFunction transferFunction, SegmentTable segments,
            RenderQuality quality, LightSettings light)
        {
            Volume = volume;
            ToWorld = toWorld;
            Carving = carving;
            TransferFunction = transferFunction;
            Segments = segments;
            Quality = quality;
            Light = light;
        }

        /// <summary>Null = there is nothing to show.</summary>
        public SegmentedVolume Volume { get; }

        /// <summary>From the volume's local space.</summary>
        public Matrix4x4 ToWorld { get; }

        /// <summary>Null = nothing is carved.</summary>
        public CarvingSnapshot Carving { get; }

        public OpacityTransferFunction TransferFunction { get; }

        public SegmentTable Segments { get; }

        public RenderQuality Quality { get; }

        public LightSettings Light { get; }

        /// <summary>A volume without extent is seen by nobody.</summary>
        public bool HasExtent => VolumeSpace.WorldScale(ToWorld) != 0;
    }
}
