using System;
using System.Globalization;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text;
using System.Threading.Tasks;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench
{
    /// <summary>The half axes of a body in the volume's middle, as parts of the volume's sides.</summary>
    readonly record struct BodyShape(double I, double J, double K)
    {
        /// <summary>1 on the skin, less inside. Places are parts of the volume's sides.</summary>
        public double Distance(double x, double y, double z) => Square((x - 0.5) / I) + Square((y - 0.5) / J) + Square((z - 0.5) / K);

        static double Square(double value) => value * value;
    }

    /// <summary>
    /// A made-up CT of any size: a body of fat and soft tissue in air, organs (some of bone, some of air) as segments, forty in files, and noise as a reconstruction leaves
    /// it, correlated in the slice. As a volume, or as gzipped NRRD in memory. The same size gives the same bytes.
    /// </summary>
    static class CtPhantom
    {
        const int Organs = 40;

        const short LeastHu = -1024, MostHu = 3071;

        /// <summary>A body without ends, which fills 0.6 of the volume.</summary>
        public static readonly BodyShape Torso = new(0.46, 0.42, double.PositiveInfinity);

        /// <summary>Before it is smoothed, HU; about 10 of it are left.</summary>
        const double NoiseHu = 28;

        const int Air = -1000, Fat = -100, SoftTissue = 40, Bone = 500, Lung = -800;

        readonly record struct Organ(double X, double Y, double Z, double RadiusX, double RadiusY, double RadiusZ, double Hu)
        {
            public bool Holds(double x, double y, double z) => Square((x - X) / RadiusX) + Square((y - Y) / RadiusY) + Square((z - Z) / RadiusZ) < 1;
        }

        /// <summary>Makes both files of a pair.</summary>
        public static (byte[] Scan, byte[] Labels) Make(int sizeI, int sizeJ, int sizeK)
        {
            var (values, labels) = Voxels(sizeI, sizeJ, sizeK, Organs, Torso);
            return (Nrrd("int16", sizeI, sizeJ, sizeK, MemoryMarshal.AsBytes(values.AsSpan())), Nrrd("uint8", sizeI, sizeJ, sizeK, labels));
        }

        /// <summary>The volume itself.</summary>
        /// <param name="spacingMm">of the voxels along i, j, k; the axes are L, P, S and the volume's centre is the origin</param>
        /// <param name="organs">0 to 255</param>
        /// <param name="body">the body's shape</param>
        public static SegmentedVolume Volume(int sizeI, int sizeJ, int sizeK, VectorMm spacingMm, int organs, BodyShape body)
        {
            var (values, labels) = Voxels(sizeI, sizeJ, sizeK, organs, body);
            var origin = new PointMm(-0.5 * (sizeI - 1) * spacingMm.X, -0.5 * (sizeJ - 1) * spacingMm.Y, -0.5 * (sizeK - 1) * spacingMm.Z);
            var geometry = new VolumeGeometry(sizeI, sizeJ, sizeK, Affine.FromColumns(
                new VectorMm(spacingMm.X, 0, 0), new VectorMm(0, spacingMm.Y, 0), new VectorMm(0, 0, spacingMm.Z), origin));
            var codes = Array.ConvertAll(values, value => (ushort)(value - LeastHu));
            var segments = Enumerable.Range(0, organs + 1).Select(number => new Segment(
                number, number, number == 0 ? "body" : string.Create(CultureInfo.InvariantCulture, $"organ {number}"), Color(number)));
            return new SegmentedVolume(
                new IntensityVolume(geometry, codes, LeastHu, 1, MostHu), new LabelMap(geometry, Array.ConvertAll(labels, label => (ushort)label), new SegmentTable(segments)));
        }

        static SegmentColor Color(int number) =>
            number == 0 ? new SegmentColor(212, 176, 150) : new SegmentColor((byte)(60 + number * 97 % 180), (byte)(60 + number * 61 % 180), (byte)(60 + number * 31 % 180));

        static (short[] Values, byte[] Labels) Voxels(int sizeI, int sizeJ, int sizeK, int organCount, BodyShape body)
        {
            var random = new Random(5);
            var organs = Enumerable.Range(0, organCount).Select(number => MakeOrgan(number, random)).ToArray();
            var values = new short[(long)sizeI * sizeJ * sizeK];
            var labels = new byte[values.Length];
            Parallel.For(0, sizeK, k =>
            {
                var noise = Noise(sizeI, sizeJ, new Random(1000 + k));
                var (x0, y0, z0) = (0.5 / sizeI, 0.5 / sizeJ, (k + 0.5) / sizeK);
                for (var j = 0; j < sizeJ; j++)
                {
                    var y = y0 + (double)j / sizeJ;
                    var near = Enumerable.Range(0, organs.Length).Where(number => organs[number].Holds(organs[number].X, y, z0)).ToArray();
                    for (var i = 0; i < sizeI; i++)
                    {
                        var x = x0 + (double)i / sizeI;
                        var depth = body.Distance(x, y, z0);
                        var label = LabelAt(organs, near, depth, x, y, z0);
                        var voxel = i + sizeI * (j + (long)sizeJ * k);
                        labels[voxel] = (byte)label;
                        values[voxel] = (short)Math.Clamp(Math.Round(Hu(organs, label, depth) + noise[i + sizeI * j]), LeastHu, MostHu);
                    }
                }
            });
            return (values, labels);
        }

        static Organ MakeOrgan(int number, Random random)
        {
            double Between(double low, double high) => low + (high - low) * random.NextDouble();
            return new Organ(
                Between(0.25, 0.75), Between(0.25, 0.75), Between(0.1, 0.9), Between(0.03, 0.13), Between(0.03, 0.13), Between(0.04, 0.19),
                number % 5 == 0 ? Bone : number % 5 == 1 ? Lung : Between(SoftTissue, SoftTissue + 60));
        }

        // 0 is not claimed: the body around the organs, and the air around the body.
        static int LabelAt(Organ[] organs, int[] near, double depth, double x, double y, double z)
        {
            if (depth >= 1) return 0;
            for (var n = near.Length; n > 0; n--)
            {
                if (organs[near[n - 1]].Holds(x, y, z)) return near[n - 1] + 1;
            }

            return 0;
        }

        static double Hu(Organ[] organs, int label, double depth) =>
            label > 0 ? organs[label - 1].Hu : depth < 0.85 ? SoftTissue : depth < 1 ? Fat : Air;

        static double Square(double value) => value * value;

        /// <summary>A slice of noise, smoothed over 3 x 3 voxels.</summary>
        static double[] Noise(int sizeI, int sizeJ, Random random)
        {
            // Four uniform numbers are near enough to normal; their sum's deviation is 1 / sqrt(3).
            var white = new double[sizeI * sizeJ];
            for (var n = 0; n < white.Length; n++)
            {
                white[n] = NoiseHu * Math.Sqrt(3) * (random.NextDouble() + random.NextDouble() + random.NextDouble() + random.NextDouble() - 2);
            }

            var smooth = new double[white.Length];
            for (var j = 0; j < sizeJ; j++)
            {
                for (var i = 0; i < sizeI; i++)
                {
                    double sum = 0;
                    for (var dj = -1; dj <= 1; dj++)
                    {
                        for (var di = -1; di <= 1; di++)
                        {
                            var weight = (di == 0 ? 2 : 1) * (dj == 0 ? 2 : 1);
                            sum += weight * white[Math.Clamp(i + di, 0, sizeI - 1) + sizeI * Math.Clamp(j + dj, 0, sizeJ - 1)];
                        }
                    }

                    smooth[i + sizeI * j] = sum / 16;
                }
            }

            return smooth;
        }

        static byte[] Nrrd(string type, int sizeI, int sizeJ, int sizeK, ReadOnlySpan<byte> voxels)
        {
            using var file = new MemoryStream();
            file.Write(Encoding.ASCII.GetBytes(string.Create(CultureInfo.InvariantCulture,
                $"NRRD0004\ntype: {type}\ndimension: 3\nspace: left-posterior-superior\nsizes: {sizeI} {sizeJ} {sizeK}\n")
                + "space directions: (0.8,0,0) (0,0.8,0) (0,0,1.5)\nkinds: domain domain domain\nendian: little\nencoding: gzip\nspace origin: (0,0,0)\n\n"));
            using (var gzip = new GZipStream(file, CompressionLevel.Optimal, leaveOpen: true)) gzip.Write(voxels);
            return file.ToArray();
        }
    }
}
