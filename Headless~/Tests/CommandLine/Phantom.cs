using System;
using System.Buffers.Binary;
using System.Globalization;
using System.IO;
using System.Text;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>
    /// A block of three parts in air, axes as LPS, 2 mm: "left" (label 1, green) and "right" (2, blue) of the patient, "top" (5, red) above both.
    /// </summary>
    static class Phantom
    {
        public const int SizeI = 24, SizeJ = 20, SizeK = 16;
        public const double Spacing = 2;
        const int Margin = 3;

        public static string WriteVolume(TestFolder folder, string name = "volume.nrrd") =>
            Write(folder[name], (i, j, k) => IsIn(i, j, k) ? (byte)100 : (byte)0, "");

        public static string WriteLabels(TestFolder folder, string name = "labels.seg.nrrd", double originMm = 0) => Write(
            folder[name],
            (i, j, k) => !IsIn(i, j, k) ? (byte)0 : k >= SizeK / 2 + 2 ? (byte)5 : i >= SizeI / 2 ? (byte)1 : (byte)2,
            Segment(0, 1, "left", "0 1 0") + Segment(1, 2, "right", "0 0 1") + Segment(2, 5, "top", "1 0 0"),
            originMm);

        /// <summary>The same as NIfTI-1 that does not say how it lies: neither qform nor sform.</summary>
        public static string WriteUnorientedVolume(TestFolder folder, string name = "unoriented.nii")
        {
            var header = new byte[352];
            void Short(int at, short value) => BinaryPrimitives.WriteInt16LittleEndian(header.AsSpan(at), value);
            void Float(int at, float value) => BinaryPrimitives.WriteSingleLittleEndian(header.AsSpan(at), value);
            BinaryPrimitives.WriteInt32LittleEndian(header, 348);
            short[] dim = [3, SizeI, SizeJ, SizeK, 1, 1, 1, 1];
            for (var d = 0; d < dim.Length; d++) Short(40 + 2 * d, dim[d]);
            Short(70, 2); // unsigned bytes
            Short(72, 8);
            for (var axis = 1; axis <= 3; axis++) Float(76 + 4 * axis, (float)Spacing);
            Float(108, header.Length);
            Encoding.ASCII.GetBytes("n+1\0").CopyTo(header, 344);
            using var file = File.Create(folder[name]);
            file.Write(header);
            WriteVoxels(file, (i, j, k) => IsIn(i, j, k) ? (byte)100 : (byte)0);
            return folder[name];
        }

        static bool IsIn(int i, int j, int k) =>
            i is >= Margin and < SizeI - Margin && j is >= Margin and < SizeJ - Margin && k is >= Margin and < SizeK - Margin;

        static string Segment(int number, int label, string name, string color) =>
            $"Segment{number}_ID:=Segment_{label}\nSegment{number}_Name:={name}\nSegment{number}_Color:={color}\n"
            + $"Segment{number}_LabelValue:={label}\nSegment{number}_Layer:=0\n";

        static string Write(string path, Func<int, int, int, byte> voxel, string fields, double originMm = 0)
        {
            using var file = File.Create(path);
            var origin = originMm.ToString(CultureInfo.InvariantCulture);
            file.Write(Encoding.ASCII.GetBytes(
                "NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\n"
                + $"sizes: {SizeI} {SizeJ} {SizeK}\nspace directions: (2,0,0) (0,2,0) (0,0,2)\nkinds: domain domain domain\nencoding: raw\n"
                + $"space origin: ({origin},{origin},{origin})\n{fields}\n"));
            WriteVoxels(file, voxel);
            return path;
        }

        static void WriteVoxels(Stream file, Func<int, int, int, byte> voxel)
        {
            for (var k = 0; k < SizeK; k++)
                for (var j = 0; j < SizeJ; j++)
                    for (var i = 0; i < SizeI; i++) file.WriteByte(voxel(i, j, k));
        }
    }
}
