using System;
using System.IO;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Formats;
using AnatomyCarve.Headless.Cli.Commands;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>The demo sample as it is committed: complete, in the right place, and a carving that protects what it says.</summary>
    sealed class DemoDataTests
    {
        const long LargestFile = 5 << 20;
        static readonly string[] Protected = ["Hippocampus_L", "Amygdala_L", "Thalamus_L", "Caudate_L", "Putamen_L", "Pallidum_L", "Insula_L"];

        VolumeData labels;
        VolumeData intensity;
        LabelMap map;
        CarvingBinding carving;
        PointMm[] centroids;

        [OneTimeSetUp]
        public void ReadSample()
        {
            labels = VolumeReader.Read(RepositoryFiles.Demo("Colin27.seg.nrrd"));
            intensity = VolumeReader.Read(RepositoryFiles.Demo("Colin27.nrrd"));
            map = LabelMap.FromVolumeData(labels);
            centroids = Centroids();
            carving = CarvingBinding.Bind(CarvingFile.Read(RepositoryFiles.Demo("demo.carving.json")), map.Segments);
        }

        [Test]
        public void Demo_Files_AreSmallEnoughForARepository()
        {
            foreach (var file in Directory.EnumerateFiles(Path.GetDirectoryName(RepositoryFiles.Demo("README.md"))!))
                Assert.That(new FileInfo(file).Length, Is.LessThan(LargestFile), file);
        }

        [Test]
        public void Demo_Volumes_LieOnTheSameGrid()
        {
            Assert.That(intensity.Geometry.Matches(labels.Geometry, out var difference), Is.True, difference);
            Assert.That(intensity.Geometry.OrientationCode, Is.EqualTo("RAS"));
            Assert.That(intensity.Geometry.SpacingMm, Is.EqualTo(new VectorMm(1, 1, 1)));
            Assert.That(intensity.Warnings.Concat(labels.Warnings).Concat(map.Warnings), Is.Empty);
        }

        [Test]
        public void Demo_Labels_AreTheAtlasAndTwoMore()
        {
            Assert.That(labels.Segments.Select(segment => segment.LabelValue), Is.EqualTo(Enumerable.Range(1, 118).Select(label => (long)label)));
            Assert.That(labels.Segments.Select(segment => segment.Name), Is.Unique);
            Assert.That(labels.Segments.Select(segment => segment.Color), Is.Unique.And.All.Not.Null);
            Assert.That(map.Segments.FindByName("brain, other").Label, Is.EqualTo(117));
            Assert.That(map.Segments.FindByName("head").Label, Is.EqualTo(118));
        }

        [Test]
        public void Demo_EverySegment_HasVoxels()
        {
            var counts = VoxelCounts(_ => true);

            Assert.That(map.Segments.Skip(1).Where(segment => counts[segment.Index] < 100).Select(segment => segment.Name), Is.Empty);
            Assert.That(counts[map.Segments.FindByName("head").Index], Is.InRange(2_000_000, 2_500_000));
        }

        [Test]
        public void Demo_LeftAndRight_AreThePatients()
        {
            foreach (var pair in map.Segments.Where(segment => segment.Name.EndsWith("_L", StringComparison.Ordinal)))
            {
                var other = map.Segments.FindByName(pair.Name[..^2] + "_R");
                Assert.That(centroids[pair.Index].X, Is.GreaterThan(centroids[other.Index].X), $"{pair.Name}: LPS +x is the patient's left");
            }
        }

        [Test]
        public void Demo_Head_StandsUprightLookingForward()
        {
            var cerebellum = centroids[map.Segments.FindByName("Cerebelum_Crus1_L").Index];
            var forehead = centroids[map.Segments.FindByName("Frontal_Sup_L").Index];

            Assert.That(forehead.Y, Is.LessThan(cerebellum.Y - 50), "LPS -y is anterior");
            Assert.That(forehead.Z, Is.GreaterThan(cerebellum.Z + 30), "LPS +z is superior");
        }

        [Test]
        public void Demo_Tissue_HasALabel()
        {
            var values = (byte[])intensity.Voxels;

            Assert.That(Enumerable.Range(0, values.Length).Count(index => values[index] > 40 && map.Indices[index] == 0), Is.Zero);
        }

        [Test]
        public void Demo_Carving_HasSpheresOfDifferentMasks()
        {
            Assert.That(carving.Fixed, Has.Count.GreaterThanOrEqualTo(3));
            Assert.That(carving.Warnings, Is.Empty);
            Assert.That(carving.Fixed.Select(sphere => sphere.Mask).Distinct().Count(), Is.GreaterThanOrEqualTo(3));
        }

        [Test]
        public void Demo_Carving_LeavesProtectedSegmentsWholeInsideTheCut()
        {
            var cut = carving.Fixed[1];
            var whole = VoxelCounts(_ => true);
            var clipped = VoxelCounts(index => carving.Fixed.Any(sphere => sphere.Mask[map.Indices[index]] && Contains(sphere, index)));
            var inside = VoxelCounts(index => Contains(cut, index));

            foreach (var name in Protected)
            {
                var segment = map.Segments.FindByName(name).Index;
                Assert.That(clipped[segment], Is.Zero, name);
                Assert.That(inside[segment], Is.GreaterThan(whole[segment] / 4), $"{name} stands in the cut");
            }

            foreach (var name in new[] { "head", "brain, other", "Postcentral_L", "Temporal_Sup_L", "Cerebelum_Crus1_L" })
                Assert.That(clipped[map.Segments.FindByName(name).Index], Is.GreaterThan(500), name);
            Assert.That(map.Segments.Where(segment => segment.Name.EndsWith("_R", StringComparison.Ordinal) && clipped[segment.Index] > 0), Is.Empty);
        }

        [Test]
        public void Demo_TransferFunction_HidesAirAndBoneAndShowsSkinAndBrain()
        {
            var transfer = TransferFunctionFile.Read(RepositoryFiles.Demo("Colin27.vp"));

            Assert.That(transfer.OpacityAt(0), Is.Zero);
            Assert.That(transfer.OpacityAt(30), Is.Zero);
            Assert.That(transfer.OpacityAt(70), Is.EqualTo(1));
            Assert.That(transfer.OpacityAt(254), Is.EqualTo(1));
        }

        [Test]
        public void Demo_Camera_LooksAtTheHeadFromOutside()
        {
            var camera = CameraFile.Read(RepositoryFiles.Demo("demo.camera.json"));
            var geometry = intensity.Geometry;
            var ijk = geometry.LpsToIjk.TransformPoint(camera.TargetLps);

            Assert.That(ijk.X, Is.InRange(0, geometry.SizeI));
            Assert.That(ijk.Y, Is.InRange(0, geometry.SizeJ));
            Assert.That(ijk.Z, Is.InRange(0, geometry.SizeK));
            Assert.That(camera.EyeLps.DistanceTo(geometry.CentreLps), Is.GreaterThan(300));
        }

        long[] VoxelCounts(Func<int, bool> counts)
        {
            var result = new long[map.Segments.Count];
            for (var index = 0; index < map.Indices.Length; index++)
                if (counts(index)) result[map.Indices[index]]++;
            return result;
        }

        bool Contains(ClipSphere sphere, int index) => Position(index).DistanceTo(sphere.CentreLps) <= sphere.RadiusMm;

        PointMm Position(int index)
        {
            var geometry = map.Geometry;
            return geometry.IjkToLps.TransformPoint(
                new PointMm(index % geometry.SizeI, index / geometry.SizeI % geometry.SizeJ, index / (geometry.SizeI * geometry.SizeJ)));
        }

        PointMm[] Centroids()
        {
            var sums = new VectorMm[map.Segments.Count];
            for (var index = 0; index < map.Indices.Length; index++) sums[map.Indices[index]] += Position(index) - default(PointMm);
            var counts = VoxelCounts(_ => true);
            return sums.Select((sum, segment) => default(PointMm) + (sum / counts[segment])).ToArray();
        }
    }
}
