using System.Collections.Generic;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Desktop.Tests
{
    /// <summary>A block of matter, 36 mm wide in a volume of 40 mm: the patient's left half is one segment, the right half another.</summary>
    static class Block
    {
        public const int Left = 1, Right = 2;

        /// <summary>Half the matter's width, in metres.</summary>
        public const float HalfWidth = 0.018f;

        const int Size = 40, Margin = 2, Matter = 1000;

        public static SegmentedVolume Make()
        {
            // The volume's centre lies elsewhere than at the origin, so that nothing works by accident.
            var geometry = new VolumeGeometry(Size, Size, Size, new Affine(1, 0, 0, 10, 0, 1, 0, -20, 0, 0, 1, 30));
            var codes = new ushort[geometry.VoxelCount];
            var indices = new ushort[geometry.VoxelCount];
            for (int k = Margin; k < Size - Margin; k++)
                for (int j = Margin; j < Size - Margin; j++)
                    for (int i = Margin; i < Size - Margin; i++)
                    {
                        int v = i + Size * (j + Size * k);
                        indices[v] = i >= Size / 2 ? (ushort)Left : (ushort)Right;
                        codes[v] = Matter;
                    }
            var segments = new List<Segment>
            {
                new Segment(0, 0, "Unlabelled", new SegmentColor(128, 128, 128)),
                new Segment(Left, 10, "Left", new SegmentColor(200, 60, 60)),
                new Segment(Right, 20, "Right", new SegmentColor(60, 60, 200)),
            };
            return new SegmentedVolume(new IntensityVolume(geometry, codes, 0, 1, Matter), new LabelMap(geometry, indices, new SegmentTable(segments)));
        }
    }
}
