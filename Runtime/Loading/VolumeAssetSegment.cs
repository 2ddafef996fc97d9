using System;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>A segment as an asset lists it: label, name, colour, voxels.</summary>
    [Serializable]
    public struct VolumeAssetSegment
    {
        [SerializeField, Tooltip("The segment's value in the label map; 0 = tissue that no segment claims")]
        long label;

        [SerializeField, Tooltip("The segment's name")]
        string name;

        [SerializeField, Tooltip("The segment's colour")]
        Color32 color;

        [SerializeField, Tooltip("How many voxels have this label")]
        long voxels;

        /// <summary>Sets all of it.</summary>
        /// <param name="label">The segment's value in the label map; 0 = tissue that no segment claims.</param>
        /// <param name="name">Its name; null counts as empty.</param>
        /// <param name="color">Its colour, sRGB as in all of Unity's colour fields.</param>
        /// <param name="voxels">How many voxels have the label.</param>
        public VolumeAssetSegment(long label, string name, Color32 color, long voxels)
        {
            this.label = label;
            this.name = name ?? "";
            this.color = color;
            this.voxels = voxels;
        }

        /// <summary>The segment's value in the label map; 0 = tissue that no segment claims.</summary>
        public long Label => label;

        /// <summary>The segment's name.</summary>
        public string Name => name ?? "";

        /// <summary>Its colour, sRGB.</summary>
        public Color32 Color => color;

        /// <summary>How many voxels have this label.</summary>
        public long Voxels => voxels;
    }
}
