using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using AnatomyCarve.Formats;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.DemoData
{
    /// <summary>demo-data TEMPLATES OUTPUT: makes the sample's files from mricron-data's folder of templates.</summary>
    static class Program
    {
        static readonly string[] Comments =
        [
            "Colin27: McConnell Brain Imaging Centre, Montreal Neurological Institute; Holmes et al. 1998",
            "as distributed in Debian's package mricron-data; cropped",
        ];

        static readonly string[] LabelComments =
        [
            "AAL: Tzourio-Mazoyer et al. 2002; brain mask of Colin27: McConnell Brain Imaging Centre, Montreal Neurological Institute",
            "as distributed in Debian's package mricron-data; cropped, \"brain, other\" and \"head\" added",
        ];

        static int Main(string[] arguments)
        {
            if (arguments.Length != 2)
            {
                Console.Error.WriteLine("usage: demo-data TEMPLATES OUTPUT");
                return 2;
            }

            Make(arguments[0], arguments[1]);
            return 0;
        }

        static void Make(string templates, string output)
        {
            var intensity = VolumeReader.Read(Path.Combine(templates, "ch2.nii.gz"));
            var geometry = intensity.Geometry;
            var grid = new Grid(geometry.SizeI, geometry.SizeJ, geometry.SizeK);
            var intensities = BytesOn(geometry, intensity);
            var brain = BytesOn(geometry, VolumeReader.Read(Path.Combine(templates, "ch2bet.nii.gz")));
            var regions = BytesOn(geometry, VolumeReader.Read(Path.Combine(templates, "aal.nii.gz")));
            var names = Atlas.ReadNames(Path.Combine(templates, "aal.nii.txt"));

            var labels = HeadLabels.Make(grid, intensities, brain, regions);
            var box = VoxelBox.Around(grid, index => labels[index] != 0, margin: 1);
            var cropped = Cropped(geometry, box);
            var croppedLabels = box.Cut(grid, labels);

            Directory.CreateDirectory(output);
            var labelsPath = Path.Combine(output, "Colin27.seg.nrrd");
            NrrdWriter.Write(Path.Combine(output, "Colin27.nrrd"), box.Grid, cropped, box.Cut(grid, intensities), Comments);
            NrrdWriter.Write(labelsPath, box.Grid, cropped, croppedLabels, LabelComments, Segments(box.Grid, croppedLabels, names));

            DemoScene.Write(output, LabelMap.FromVolumeData(VolumeReader.Read(labelsPath)).Segments);
            foreach (var file in new DirectoryInfo(output).GetFiles().OrderBy(file => file.Name, StringComparer.Ordinal))
            {
                Console.WriteLine($"{file.Length,10:N0} bytes  {file.FullName}");
            }
        }

        static byte[] BytesOn(VolumeGeometry expected, VolumeData volume)
        {
            if (volume.Voxels is not byte[] bytes) throw new InvalidDataException($"{volume.Source}: {volume.VoxelType} voxels instead of bytes.");
            if (!expected.Matches(volume.Geometry, out var difference)) throw new InvalidDataException($"{volume.Source}: {difference}");
            return bytes;
        }

        static Affine Cropped(VolumeGeometry geometry, VoxelBox box)
        {
            VectorMm Column(int column) => new(geometry.IjkToLps[0, column], geometry.IjkToLps[1, column], geometry.IjkToLps[2, column]);
            return Affine.FromColumns(Column(0), Column(1), Column(2),
                geometry.IjkToLps.TransformPoint(new PointMm(box.MinI, box.MinJ, box.MinK)));
        }

        static List<SegmentEntry> Segments(Grid grid, byte[] labels, SortedDictionary<byte, string> names)
        {
            var palette = new Palette(names.Values);
            return names.Select(entry => new SegmentEntry(
                entry.Key, entry.Value, palette.ColorOf(entry.Value),
                VoxelBox.Around(grid, index => labels[index] == entry.Key, margin: 0))).ToList();
        }
    }
}
