using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using AnatomyCarve.Picking;
using AnatomyCarve.Tests.Carving;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Picking
{
    public sealed class VolumeThumbnailTests
    {
        const int Size = 48;

        static readonly SegmentColor Red = new SegmentColor(230, 20, 20), Green = new SegmentColor(20, 230, 20), Grey = new SegmentColor(120, 120, 120);

        [Test]
        public void Ball_IsSeenInTheMiddle_WithNothingBehindIt()
        {
            byte[] picture = VolumeThumbnail.Render(Balls(hidden: 0), Size);
            Assert.That(picture, Has.Length.EqualTo(Size * Size * 4));
            Assert.That(Alpha(picture, Size / 2, Size / 2), Is.EqualTo(255));
            Assert.That(new[] { Alpha(picture, 0, 0), Alpha(picture, Size - 1, 0), Alpha(picture, 0, Size - 1), Alpha(picture, Size - 1, Size - 1) }, Is.All.EqualTo(0));
        }

        [Test]
        public void Picture_IsFilled_HoweverSmallWhatItShowsIs()
        {
            // A ball of a twelfth of the volume's length, in a corner.
            SegmentedVolume volume = Volume(48, (i, j, k) => Distance(i, j, k, 8, 39, 9) <= 4 ? 1 : 0, Red);
            byte[] picture = VolumeThumbnail.Render(volume, Size);
            int[] columns = Enumerable.Range(0, Size).Where(x => Enumerable.Range(0, Size).Any(y => Alpha(picture, x, y) > 0)).ToArray();
            int[] rows = Enumerable.Range(0, Size).Where(y => Enumerable.Range(0, Size).Any(x => Alpha(picture, x, y) > 0)).ToArray();
            Assert.That(Math.Max(columns.Length, rows.Length), Is.GreaterThan(Size * 2 / 3));
            Assert.That(columns.First() > 0 && columns.Last() < Size - 1 && rows.First() > 0 && rows.Last() < Size - 1, "nothing is cut off");
        }

        [Test]
        public void SmallSegments_InALargeScan_AreFound()
        {
            // Eight voxels of a quarter of a million, and one.
            SegmentedVolume volume = Volume(64, (i, j, k) => i / 2 == 12 && j / 2 == 20 && k / 2 == 7 ? 1 : 0, (i, j, k) => 1000, Red);
            byte[] picture = VolumeThumbnail.Render(volume, Size);
            Assert.That(Alpha(picture, Size / 2, Size / 2), Is.EqualTo(255));
            Assert.That(Colors(picture), Is.All.Matches<SegmentColor>(color => color.R > 2 * color.G));
            SegmentedVolume single = Volume(64, (i, j, k) => i == 12 && j == 20 && k == 7 ? 1 : 0, (i, j, k) => 1000, Red);
            Assert.That(Colors(VolumeThumbnail.Render(single, Size)), Is.Not.Empty.And.All.Matches<SegmentColor>(color => color.R > 2 * color.G));
        }

        [Test]
        public void InvisibleSegments_PlayNoPartInTheFrame()
        {
            SegmentedVolume volume = Volume(40, (i, j, k) => Distance(i, j, k, 9, 9, 9) < 6 ? 1 : Distance(i, j, k, 35, 35, 35) < 4 ? 2 : 0, Red, Green);
            SegmentedVolume alone = Volume(40, (i, j, k) => Distance(i, j, k, 9, 9, 9) < 6 ? 1 : 0, Red, Green);
            var table = new SegmentTable(volume.Segments.Select(segment => segment.Index == 2 ? segment.WithOpacity(0) : segment));
            var hidden = new SegmentedVolume(volume.Intensity, new LabelMap(volume.Geometry, volume.Labels.Indices, table));
            Assert.That(VolumeThumbnail.Render(hidden, Size), Is.EqualTo(VolumeThumbnail.Render(alone, Size)));
        }

        [Test]
        public void Patient_IsSeenFromFrontLeftAndAbove_TheBottomRowFirst()
        {
            // A red ball at the patient's left, a green one at the right: from the front the left is on the viewer's right.
            SegmentedVolume sides = Volume(40, (i, j, k) => Distance(i, j, k, 32, 20, 20) < 7 ? 1 : Distance(i, j, k, 8, 20, 20) < 7 ? 2 : 0, Red, Green);
            Assert.That(Centre(sides, Red).x, Is.GreaterThan(Centre(sides, Green).x + (Size / 4)));

            // Red above green.
            SegmentedVolume heights = Volume(40, (i, j, k) => Distance(i, j, k, 20, 20, 32) < 7 ? 1 : Distance(i, j, k, 20, 20, 8) < 7 ? 2 : 0, Red, Green);
            Assert.That(Centre(heights, Red).y, Is.GreaterThan(Centre(heights, Green).y + (Size / 4)));

            // Red in front (anterior, -y) of green: seen from front and above, what is in front lies lower.
            SegmentedVolume depths = Volume(40, (i, j, k) => Distance(i, j, k, 20, 8, 20) < 7 ? 1 : Distance(i, j, k, 20, 32, 20) < 7 ? 2 : 0, Red, Green);
            Assert.That(Centre(depths, Red).y, Is.LessThan(Centre(depths, Green).y));
            Assert.That(Centre(depths, Red).x, Is.LessThan(Centre(depths, Green).x), "the left of the picture is the front, seen from the patient's left");
        }

        [Test]
        public void Light_ComesFromAbove()
        {
            byte[] picture = VolumeThumbnail.Render(Balls(hidden: 0), Size);
            int[] lit = Enumerable.Range(0, Size).Where(y => Alpha(picture, Size / 2, y) == 255).ToArray();
            int upper = lit[lit.Length * 3 / 4], lower = lit[lit.Length / 8];
            Assert.That(picture[Place(Size / 2, upper)], Is.GreaterThan(picture[Place(Size / 2, lower)]));
        }

        [Test]
        public void UnlabelledTissue_IsLeftOutWhereThereAreSegments()
        {
            byte[] picture = VolumeThumbnail.Render(Balls(hidden: 1000), Size);
            Assert.That(Colors(picture), Is.All.Matches<SegmentColor>(color => color.R > 2 * color.G), "all of it is red");
        }

        [Test]
        public void Segments_AreShownWhateverTheirIntensity()
        {
            // The segment holds air, which the automatic transfer function hides.
            SegmentedVolume volume = Volume(24, (i, j, k) => Distance(i, j, k, 12, 12, 12) < 8 ? 1 : 0, (i, j, k) => i == 0 ? 3000 : 0, Red);
            Assert.That(Colors(VolumeThumbnail.Render(volume, Size)).Count(), Is.GreaterThan(Size));
        }

        [Test]
        public void UnlabelledTissue_IsShownWhereThereIsNothingElse()
        {
            // A segment is in the table, but no voxel has it.
            SegmentedVolume volume = Volume(24, (i, j, k) => 0, (i, j, k) => Distance(i, j, k, 12, 12, 12) < 8 ? 1000 : 0, Red);
            byte[] picture = VolumeThumbnail.Render(volume, Size);
            Assert.That(Alpha(picture, Size / 2, Size / 2), Is.EqualTo(255));
            Assert.That(Alpha(picture, 0, 0), Is.EqualTo(0));
        }

        [Test]
        public void ScanWithoutSegments_IsShownByItsTransferFunction()
        {
            SegmentedVolume labelled = Volume(24, (i, j, k) => 0, (i, j, k) => Distance(i, j, k, 12, 12, 12) < 8 ? 1000 : 0);
            byte[] picture = VolumeThumbnail.Render(SegmentedVolume.Unsegmented(labelled.Intensity), Size);
            Assert.That(Alpha(picture, Size / 2, Size / 2), Is.EqualTo(255));
            Assert.That(Alpha(picture, 0, 0), Is.EqualTo(0));
        }

        [Test]
        public void InvisibleSegments_AllOfThem_GiveAnEmptyPicture()
        {
            SegmentedVolume volume = Balls(hidden: 0);
            var table = new SegmentTable(volume.Segments.Select(segment => segment.WithOpacity(0)));
            var invisible = new SegmentedVolume(volume.Intensity, new LabelMap(volume.Geometry, volume.Labels.Indices, table));
            Assert.That(VolumeThumbnail.Render(invisible, Size), Is.All.EqualTo(0));
        }

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(7)]
        public void Size_MayBeAny(int size)
        {
            byte[] picture = VolumeThumbnail.Render(Balls(hidden: 0), size);
            Assert.That(picture, Has.Length.EqualTo(size * size * 4));
            Assert.That(Enumerable.Range(0, size * size).Max(pixel => picture[(4 * pixel) + 3]), Is.GreaterThan(0));
        }

        [Test]
        public void Volume_OfAnyGeometry_HasAPicture([Range(1, 12)] int seed)
        {
            SegmentedVolume volume = new RandomScenes(seed).Volume(9, 4);
            Assert.That(VolumeThumbnail.Render(volume, 16), Has.Length.EqualTo(16 * 16 * 4));
        }

        [Test]
        public void Picture_IsTheSameEachTime()
        {
            byte[] first = VolumeThumbnail.Render(Balls(hidden: 0), Size);
            Assert.That(VolumeThumbnail.Render(Balls(hidden: 0), Size), Is.EqualTo(first));
        }

        [Test]
        public void Arguments_OutOfRange_AreRefused()
        {
            SegmentedVolume volume = Balls(hidden: 0);
            Assert.That(() => VolumeThumbnail.Render(null, 16), Throws.ArgumentNullException);
            Assert.That(() => VolumeThumbnail.Render(volume, 0), Throws.TypeOf<ArgumentOutOfRangeException>());
            Assert.That(() => VolumeThumbnail.Render(volume, VolumeThumbnail.MaximumSize + 1), Throws.TypeOf<ArgumentOutOfRangeException>());
            Assert.That(() => VolumeThumbnail.Render(volume, 16, new CancellationToken(true)), Throws.InstanceOf<OperationCanceledException>());
        }

        /// <summary>A red ball in a block of unlabelled tissue.</summary>
        static SegmentedVolume Balls(int hidden) =>
            Volume(32, (i, j, k) => Distance(i, j, k, 16, 16, 16) < 11 ? 1 : 0, (i, j, k) => Distance(i, j, k, 16, 16, 16) < 11 ? 500 : hidden, Red);

        static SegmentedVolume Volume(int size, Func<int, int, int, int> index, params SegmentColor[] colors) => Volume(size, index, (i, j, k) => 100, colors);

        static SegmentedVolume Volume(int size, Func<int, int, int, int> index, Func<int, int, int, int> code, params SegmentColor[] colors)
        {
            var geometry = new VolumeGeometry(size, size, size, Affine.Identity);
            ushort[] codes = Phantoms.Map(geometry, (i, j, k) => (ushort)code(i, j, k));
            ushort[] indices = Phantoms.Map(geometry, (i, j, k) => (ushort)index(i, j, k));
            IEnumerable<Segment> segments = new[] { Grey }.Concat(colors).Select((color, n) => new Segment(n, n, "segment " + n, color));
            return new SegmentedVolume(new IntensityVolume(geometry, codes, 0, 1, 3000), new LabelMap(geometry, indices, new SegmentTable(segments)));
        }

        static double Distance(int i, int j, int k, int x, int y, int z) => Math.Sqrt(((i - x) * (i - x)) + ((j - y) * (j - y)) + ((k - z) * (k - z)));

        static int Place(int x, int y) => 4 * (x + (Size * y));

        static byte Alpha(byte[] picture, int x, int y) => picture[Place(x, y) + 3];

        static IEnumerable<SegmentColor> Colors(byte[] picture) => Enumerable.Range(0, picture.Length / 4)
            .Where(pixel => picture[(4 * pixel) + 3] == 255)
            .Select(pixel => new SegmentColor(picture[4 * pixel], picture[(4 * pixel) + 1], picture[(4 * pixel) + 2]));

        /// <summary>The middle of the pixels that are more of a colour than of the other.</summary>
        static (double x, double y) Centre(SegmentedVolume volume, SegmentColor color)
        {
            byte[] picture = VolumeThumbnail.Render(volume, Size);
            int[] pixels = Enumerable.Range(0, Size * Size)
                .Where(pixel => picture[(4 * pixel) + 3] == 255 && (picture[4 * pixel] > picture[(4 * pixel) + 1]) == (color.R > color.G)).ToArray();
            Assert.That(pixels.Length, Is.GreaterThan(20), color.ToString());
            return (pixels.Average(pixel => pixel % Size), pixels.Average(pixel => pixel / Size));
        }
    }
}
