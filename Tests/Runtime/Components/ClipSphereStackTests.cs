using System;
using System.Collections.Generic;
using System.IO;
using System.Text.RegularExpressions;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>The carving in world space.</summary>
    sealed class ClipSphereStackTests : PlayModeScene
    {
        const double ToleranceMm = 1e-4;

        [Test]
        public void SetActive_InAnUntransformedVolume_LiesInThePatient()
        {
            ClipSphereStack stack = MakeVolume(Phantoms.Markers(20)).Stack;
            stack.SetActive(new Vector3(0.014f, 0.002f, -0.003f), 0.005f);
            AssertPoint(stack.Carving.Active.CentreLps, Centre(stack) + new VectorMm(14, -3, 2));
            Assert.That(stack.Carving.Active.RadiusMm, Is.EqualTo(5).Within(ToleranceMm));
        }

        [Test]
        public void SetActive_InAMovedRotatedScaledVolume_FollowsTheTransform()
        {
            ClipSphereStack stack = MakeVolume(Phantoms.Markers(20)).Stack;
            Transform volume = stack.transform;
            volume.position = new Vector3(1f, 2f, 3f);
            volume.rotation = Quaternion.Euler(20f, 130f, -40f);
            volume.localScale = new Vector3(4f, 4f, 4f);
            stack.SetActive(volume.TransformPoint(new Vector3(0.01f, 0f, 0f)), 0.02f);
            AssertPoint(stack.Carving.Active.CentreLps, Centre(stack) + new VectorMm(10, 0, 0));
            Assert.That(stack.Carving.Active.RadiusMm, Is.EqualTo(5).Within(ToleranceMm));
        }

        [Test]
        public void SetActive_InAnUnevenlyScaledVolume_KeepsTheSpheresVolume()
        {
            ClipSphereStack stack = MakeVolume(Phantoms.Markers(20)).Stack;
            stack.transform.localScale = new Vector3(1f, 2f, 4f);
            stack.SetActive(Vector3.zero, 0.01f);
            Assert.That(stack.Carving.Active.RadiusMm, Is.EqualTo(5).Within(ToleranceMm));
        }

        [Test]
        public void SetActive_NotFinite_IsRefusedAndChangesNothing([Values(float.NaN, float.PositiveInfinity, -1f)] float radius)
        {
            ClipSphereStack stack = MakeVolume(Phantoms.Markers(20)).Stack;
            Assert.That(() => stack.SetActive(Vector3.zero, radius), Throws.InstanceOf<ArgumentException>());
            Assert.That(stack.Carving.Active, Is.Null);
        }

        [Test]
        public void Edits_WithoutAVolume_AreRefused()
        {
            var stack = Make("Volume", typeof(VolumeLoader), typeof(ClipSphereStack)).GetComponent<ClipSphereStack>();
            Assert.That(stack.Carving, Is.Null);
            Assert.That(() => stack.SetActive(Vector3.zero, 1f), Throws.InvalidOperationException);
            Assert.That(() => stack.Undo(), Throws.InvalidOperationException);
        }

        [Test]
        public void Changed_EachEdit_IsRaisedWithWhatChanged()
        {
            ClipSphereStack stack = MakeVolume(Phantoms.Markers(20)).Stack;
            var kinds = new List<CarvingChangeKind>();
            stack.Changed += change => kinds.Add(change.Kind);
            stack.SetActive(Vector3.zero, 0.01f);
            stack.ToggleSegment(2);
            stack.FixActive();
            stack.RemoveLast();
            stack.Clear();
            Assert.That(kinds, Is.EqualTo(new[]
            {
                CarvingChangeKind.ActiveSet, CarvingChangeKind.MaskChanged, CarvingChangeKind.ActiveFixed, CarvingChangeKind.LastRemoved,
                CarvingChangeKind.Cleared,
            }));
        }

        [Test]
        public void FixActive_TheNewSphere_HasTheSetShareOfTheRadius()
        {
            ClipSphereStack stack = MakeVolume(Phantoms.Markers(20)).Stack;
            stack.ActiveRadiusFactor = 0.5f;
            stack.SetActive(Vector3.zero, 0.01f);
            stack.FixActive();
            Assert.That(stack.Carving.Active.RadiusMm, Is.EqualTo(5).Within(ToleranceMm));
        }

        [Test]
        public void Volume_Replaced_StartsWithAnEmptyCarving()
        {
            ClipSphereStack stack = MakeVolume(Phantoms.Markers(20)).Stack;
            stack.SetActive(Vector3.zero, 0.01f);
            stack.Loader.SetVolume(Phantoms.Cube(8, "Cube"));
            Assert.That(stack.Carving.Active, Is.Null);
            Assert.That(stack.Carving.SegmentCount, Is.EqualTo(2));
        }

        [Test]
        public void SaveAndLoad_RoundTrip_RestoresTheCarving()
        {
            ClipSphereStack stack = MakeVolume(Phantoms.Markers(20)).Stack;
            stack.SetActive(new Vector3(0.001f, 0.002f, 0.003f), 0.01f);
            stack.ToggleSegment(Phantoms.Superior);
            stack.FixActive();
            ClipSphere[] before = { stack.Carving.Fixed[0], stack.Carving.Active };
            using (var files = new NrrdFiles())
            {
                stack.Save(files.PathOf("carving.json"));
                stack.Clear();
                Assert.That(stack.Load(files.PathOf("carving.json")), Is.Empty);
            }
            Assert.That(new[] { stack.Carving.Fixed[0], stack.Carving.Active }, Is.EqualTo(before));
            Assert.That(stack.Undo(), Is.True, "loading can be undone");
            Assert.That(stack.Carving.Fixed, Is.Empty);
        }

        [Test]
        public void Load_WhatDoesNotFit_IsLoggedAndSavedAgainByAListener()
        {
            ClipSphereStack stack = MakeVolume(Phantoms.Cube(8, "Cube")).Stack;
            ClipSphereStack other = MakeVolume(Phantoms.Markers(20)).Stack;
            other.SetActive(Vector3.zero, 0.01f);
            using (var files = new NrrdFiles())
            {
                other.Save(files.PathOf("carving.json"));
                stack.Changed += change => stack.Save(files.PathOf("again.json"));
                LogAssert.Expect(LogType.Warning, new Regex("Superior"));
                Assert.That(stack.Load(files.PathOf("carving.json")), Is.Not.Empty);
                Assert.That(File.ReadAllText(files.PathOf("again.json")), Does.Contain("Superior"), "segments that this volume lacks are kept");
            }
        }

        [Test]
        public void Load_OfABadFile_KeepsTheCarving()
        {
            ClipSphereStack stack = MakeVolume(Phantoms.Markers(20)).Stack;
            stack.SetActive(Vector3.zero, 0.01f);
            int version = stack.Carving.Version;
            using (var files = new NrrdFiles())
            {
                string path = files.WriteText("carving.json", "{\"version\": 99}");
                Assert.That(() => stack.Load(path), Throws.InstanceOf<CarvingFileException>());
            }
            Assert.That(stack.Carving.Version, Is.EqualTo(version));
        }

        static PointMm Centre(ClipSphereStack stack) => stack.Loader.Volume.Geometry.CentreLps;

        static void AssertPoint(PointMm actual, PointMm expected) =>
            Assert.That(actual.DistanceTo(expected), Is.LessThan(ToleranceMm), $"{actual} instead of {expected}");
    }
}
