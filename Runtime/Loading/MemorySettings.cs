using System;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>What a loader does with large volumes.</summary>
    [Serializable]
    public sealed class MemorySettings
    {
        /// <summary>Voxels above which volumes are shown coarse first, unless it is set: 256 slices of 512 x 512.</summary>
        public const int DefaultCoarseAboveVoxels = 1 << 26;

        [SerializeField, Tooltip("What to do with a volume that the device cannot hold: make it coarser, with a warning, or refuse it")]
        WhenTooLarge whenTooLarge = WhenTooLarge.Downsample;

        [SerializeField, Min(0)]
        [Tooltip("What a volume may take on the GPU, MiB; 0 = three quarters of graphics memory, or a quarter of main memory where the two are one")]
        int budgetMiB;

        [SerializeField, Min(0), Tooltip("Volumes of more voxels are shown coarse first, while the rest loads; 0 = none is")]
        int coarseAboveVoxels = DefaultCoarseAboveVoxels;

        /// <summary>What happens to a volume that the device cannot hold. At first it is made coarser: it is seen, and a warning says how coarse it is.</summary>
        public WhenTooLarge WhenTooLarge { get => whenTooLarge; set => whenTooLarge = value; }

        /// <summary>
        /// What a volume may take on the GPU, MiB. 0 = what the device says: three quarters of graphics memory; a quarter of main memory where the two are one
        /// (mobile devices, and devices that say to have less than 1 GiB of their own); no limit where neither is known. The limits of 3D textures hold anyway.
        /// </summary>
        /// <exception cref="ArgumentOutOfRangeException">The value is negative.</exception>
        public int BudgetMiB { get => budgetMiB; set => budgetMiB = NotNegative(value, nameof(BudgetMiB)); }

        /// <summary>Volumes of more voxels are shown coarse first, while the rest loads; 0 = none is.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The value is negative.</exception>
        public int CoarseAboveVoxels { get => coarseAboveVoxels; set => coarseAboveVoxels = NotNegative(value, nameof(CoarseAboveVoxels)); }

        internal void Clamp()
        {
            budgetMiB = Mathf.Max(0, budgetMiB);
            coarseAboveVoxels = Mathf.Max(0, coarseAboveVoxels);
        }

        static int NotNegative(int value, string name) =>
            value >= 0 ? value : throw new ArgumentOutOfRangeException(name, value, name + " is 0 or more.");
    }
}
