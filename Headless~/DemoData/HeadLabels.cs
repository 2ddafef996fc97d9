using System;

namespace AnatomyCarve.Headless.DemoData
{
    /// <summary>The label of each voxel of the head: atlas regions where there are any, "brain, other" in the rest of the brain, "head" around it.</summary>
    static class HeadLabels
    {
        public const byte BrainOther = 117;
        public const byte Head = 118;

        /// <summary>Brighter voxels are tissue. Air is 0 nearly everywhere; the dark compact bone of the skull reaches down to 15.</summary>
        const byte HeadThreshold = 12;

        /// <summary>Strands of the brain mask that are thinner than twice this many voxels are meninges and vessels at the skull's base, not brain.</summary>
        const int StrandRadius = 2;

        /// <param name="grid">the common grid of the three images</param>
        /// <param name="intensities">T1 intensities of the whole head</param>
        /// <param name="brain">the same with everything but the brain set to 0</param>
        /// <param name="regions">atlas regions 1 to 116, 0 elsewhere</param>
        public static byte[] Make(Grid grid, byte[] intensities, byte[] brain, byte[] regions)
        {
            var isBrain = BrainMask(grid, brain, regions);
            var isHead = HeadMask(grid, intensities);
            var labels = new byte[grid.Count];
            for (var index = 0; index < labels.Length; index++)
            {
                labels[index] = regions[index] != 0 ? regions[index] : isBrain[index] ? BrainOther : isHead[index] ? Head : (byte)0;
            }

            return labels;
        }

        static bool[] BrainMask(Grid grid, byte[] brain, byte[] regions)
        {
            var mask = Array.ConvertAll(brain, value => value > 0);
            var core = Morphology.LargestPart(grid, Morphology.Erode(grid, mask, StrandRadius));
            var grown = Morphology.Dilate(grid, core, StrandRadius + 1);
            for (var index = 0; index < mask.Length; index++)
            {
                mask[index] = (mask[index] && grown[index]) || regions[index] != 0;
            }

            return Morphology.FillCavities(grid, mask);
        }

        static bool[] HeadMask(Grid grid, byte[] intensities)
        {
            var tissue = Array.ConvertAll(intensities, value => value > HeadThreshold);
            var head = Morphology.LargestPart(grid, tissue);
            return Morphology.FillCavitiesOfSlices(grid, Morphology.FillCavities(grid, head));
        }
    }
}
