using System;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>A point of a transfer function in the Inspector.</summary>
    [Serializable]
    struct TransferFunctionPoint
    {
        [Tooltip("Intensity, in the scan's unit (Hounsfield units for CT)")]
        public float value;

        [Range(0f, 1f), Tooltip("Opacity of a path of one reference length, the smallest voxel spacing")]
        public float opacity;
    }
}
