using System;
using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Phantoms
{
    /// <summary>
    /// A body of translucent matter with denser organs in it and an opaque bone, on a grid of 0.8 x 0.8 x 1.2 mm. Intensities are blurred as a
    /// scanner's are: they follow the balls' true share of each voxel. The carving of a scene may clip its segments apart.
    /// </summary>
    static class TranslucentOrgans
    {
        /// <summary>Segments.</summary>
        public const int Body = 1, Liver = 2, Kidney = 3, Bone = 4;

        const int Samples = 4;

        static readonly (int Segment, Ball Ball, int Intensity)[] Parts =
        [
            (Bone, new Ball(new PointMm(-9, -6, 5), 8.4), 900), (Kidney, new Ball(new PointMm(15, -8, -6), 9.1), 420),
            (Liver, new Ball(new PointMm(-5, 6, -8), 15.7), 300), (Body, new Ball(new PointMm(0, 0, 0), 33.3), 120),
        ];

        /// <summary>Opacity per 0.8 mm: thin for the body, some for organs, 1 for bone.</summary>
        public static OpacityTransferFunction TransferFunction { get; } =
            OpacityTransferFunction.Parse("0:0,60:0,120:0.015,300:0.05,420:0.2,600:0.5,850:1,1000:1");

        public static SegmentedVolume Make()
        {
            var geometry = Grids.Centred(96, 96, 64, 0.8, 0.8, 1.2);
            var codes = new ushort[geometry.VoxelCount];
            var indices = new ushort[geometry.VoxelCount];
            Grids.ForEach(geometry, (i, j, k, voxel) =>
            {
                // From the outside in: each part takes its share from what is around it.
                double intensity = 0;
                foreach (var (segment, ball, own) in Parts.Reverse())
                {
                    var share = ball.Coverage(geometry, i, j, k, Samples);
                    intensity += share * (own - intensity);
                    if (share > 0.5) indices[voxel] = (ushort)segment;
                }

                codes[voxel] = (ushort)Math.Round(intensity);
            });
            Segment[] segments =
            [
                new(0, 0, SegmentTable.UnlabelledName, new SegmentColor(200, 200, 200)),
                new(Body, Body, "body", new SegmentColor(235, 200, 180)), new(Liver, Liver, "liver", new SegmentColor(160, 70, 50)),
                new(Kidney, Kidney, "kidney", new SegmentColor(220, 120, 60)), new(Bone, Bone, "bone", new SegmentColor(255, 255, 240)),
            ];
            return new SegmentedVolume(new IntensityVolume(geometry, codes, 0, 1, codes.Max()), new LabelMap(geometry, indices, new SegmentTable(segments)));
        }
    }
}
