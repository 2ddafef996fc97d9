using System.Collections.Generic;
using System.IO;
using AnatomyCarve.Formats;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Volumes
{
    /// <summary>The same asymmetric patient, stored in each of the 48 orientations: what is left stays left.</summary>
    public sealed class LateralityTests
    {
        /// <summary>Places of four structures, LPS mm, on the lattice of the phantom's voxels; no symmetry maps them onto each other.</summary>
        static readonly PointMm[] Places =
        {
            new PointMm(-6, -6, -9), new PointMm(6, -6, -9), new PointMm(-6, 4, -9), new PointMm(-6, -6, 6),
        };

        static readonly VectorMm Spacing = new VectorMm(2, 2, 3);

        static IEnumerable<string> Codes() => Orientations.Codes();

        [TestCaseSource(nameof(Codes))]
        public void Nifti_InAnyOrientation_KeepsEveryStructureInPlace(string code)
        {
            byte[] voxels = Phantom(code, out Affine ijkToLps, out int[] sizes);
            byte[] file = new NiftiFile(sizes[0], sizes[1], sizes[2], voxels) { Sform = ijkToLps }.ToBytes();
            CheckPlaces(file, code);
        }

        [TestCaseSource(nameof(Codes))]
        public void Nrrd_InAnyOrientation_KeepsEveryStructureInPlace(string code)
        {
            byte[] voxels = Phantom(code, out Affine ijkToLps, out int[] sizes);
            var file = new NrrdFile(voxels, sizes);
            file.Place(ijkToLps);
            CheckPlaces(file.ToBytes(), code);
        }

        [TestCaseSource(nameof(Codes))]
        public void NrrdInRas_InAnyOrientation_KeepsEveryStructureInPlace(string code)
        {
            byte[] voxels = Phantom(code, out Affine ijkToLps, out int[] sizes);
            Affine lpsToRas = Affine.FromColumns(new VectorMm(-1, 0, 0), new VectorMm(0, -1, 0), new VectorMm(0, 0, 1), new PointMm(0, 0, 0));
            var file = new NrrdFile(voxels, sizes) { ["space"] = "right-anterior-superior" };
            file.Place(lpsToRas * ijkToLps);
            CheckPlaces(file.ToBytes(), code);
        }

        static void CheckPlaces(byte[] file, string code)
        {
            LabelMap map = LabelMap.FromVolumeData(VolumeReader.Read(new MemoryStream(file), code));
            Assert.That(map.Geometry.OrientationCode, Is.EqualTo(code));
            for (int n = 0; n < Places.Length; n++)
            {
                PointMm ijk = map.Geometry.LpsToIjk.TransformPoint(Places[n]);
                int index = (int)(ijk.X + 0.5) + (map.Geometry.SizeI * ((int)(ijk.Y + 0.5) + (map.Geometry.SizeJ * (int)(ijk.Z + 0.5))));
                Assert.That(map.Segments[map.Indices[index]].Label, Is.EqualTo(n + 1), "structure " + n);
            }

            Assert.That(map.CountVoxels(), Is.EqualTo(new long[] { map.Geometry.VoxelCount - Places.Length, 1, 1, 1, 1 }));
        }

        /// <summary>A box from -10 to 10, -8 to 8, -12 to 12 mm with one voxel per structure, in the order that an orientation asks for.</summary>
        static byte[] Phantom(string code, out Affine ijkToLps, out int[] sizes)
        {
            sizes = new int[3];
            VectorMm toOrigin = new VectorMm(0, 0, 0);
            for (int axis = 0; axis < 3; axis++)
            {
                VectorMm unit = Orientations.Direction(code[axis]);
                sizes[axis] = unit.X != 0 ? 11 : 9;
                var extent = new VectorMm(unit.X * 10, unit.Y * 8, unit.Z * 12);
                toOrigin -= extent;
            }

            ijkToLps = Orientations.Grid(code, Spacing, new PointMm(0, 0, 0) + toOrigin);
            Affine lpsToIjk = ijkToLps.Inverse();
            var voxels = new byte[sizes[0] * sizes[1] * sizes[2]];
            for (int n = 0; n < Places.Length; n++)
            {
                PointMm ijk = lpsToIjk.TransformPoint(Places[n]);
                voxels[(int)(ijk.X + 0.5) + (sizes[0] * ((int)(ijk.Y + 0.5) + (sizes[1] * (int)(ijk.Z + 0.5))))] = (byte)(n + 1);
            }

            return voxels;
        }
    }
}
