using AnatomyCarve.Carving;
using AnatomyCarve.Editor;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>Edits of a carving outside Play: saved with the scene, undone by Unity.</summary>
    sealed class CarvingEditsTests
    {
        static readonly PointMm Centre = new PointMm(1.25, 2.5, 0.1);

        GameObject made;
        ClipSphereStack stack;

        [SetUp]
        public void MakeVolume()
        {
            made = new GameObject("Volume", typeof(VolumeLoader), typeof(ClipSphereStack));
            stack = made.GetComponent<ClipSphereStack>();
            made.GetComponent<VolumeLoader>().SetVolume(Volumes.Small());
            Undo.IncrementCurrentGroup();
        }

        [TearDown]
        public void DestroyVolume() => Object.DestroyImmediate(made);

        [Test]
        public void Edit_OutsidePlay_DoesNotStartTheCarvingAnew()
        {
            CarvingStack carving = stack.Carving;
            Place(12.5);
            Assert.That(stack.Carving, Is.SameAs(carving));
            Assert.That(carving.Active.RadiusMm, Is.EqualTo(12.5));
        }

        [Test]
        public void Edit_ThatIsUndone_IsTakenBackAndMadeAgain()
        {
            Place(12.5);
            Undo.IncrementCurrentGroup();
            CarvingEdits.Do(stack, "Fix Clip Sphere", carving => carving.FixActive());
            Undo.FlushUndoRecordObjects();
            Undo.PerformUndo();
            Assert.That(stack.Carving.Fixed, Is.Empty);
            Assert.That(stack.Carving.Active, Is.EqualTo(new ClipSphere(Centre, 12.5, SegmentMask.All(5))));
            Undo.PerformUndo();
            Assert.That(stack.Carving.Spheres, Is.Empty);
            Undo.PerformRedo();
            Undo.PerformRedo();
            Assert.That(stack.Carving.Fixed, Is.EqualTo(new[] { new ClipSphere(Centre, 12.5, SegmentMask.All(5)) }));
        }

        [Test]
        public void Edits_OfOneGroup_AreOneStep()
        {
            Place(10);
            Place(11);
            Place(12.5);
            Undo.FlushUndoRecordObjects();
            Undo.PerformUndo();
            Assert.That(stack.Carving.Spheres, Is.Empty);
        }

        [Test]
        public void Mask_OfManySegments_IsSavedWithItsSphere()
        {
            Place(12.5);
            CarvingEdits.Do(stack, "Edit Mask", carving => carving.SetActiveMask(MaskEdits.Apply(carving.ActiveMask, MaskEdit.Keep, new[] { 1, 4 })));
            made.GetComponent<VolumeLoader>().SetVolume(Volumes.Small());
            Assert.That(stack.Carving.Active.Mask, Is.EqualTo(SegmentMask.FromIndices(5, new[] { 0, 2, 3 })));
        }

        [Test]
        public void Mask_WithoutASphere_CannotBeEdited()
        {
            Assert.That(CarvingEdits.IsPossible(stack), Is.True);
            Assert.That(CarvingEdits.IsMaskPossible(stack), Is.False);
            Place(1);
            Assert.That(CarvingEdits.IsMaskPossible(stack), Is.True);
        }

        [Test]
        public void Edit_WithoutAVolume_DoesNothing()
        {
            made.GetComponent<VolumeLoader>().Unload();
            bool ran = false;
            CarvingEdits.Do(stack, "Edit", carving => ran = true);
            Assert.That(ran, Is.False);
            Assert.That(CarvingEdits.IsPossible(stack), Is.False);
        }

        void Place(double radiusMm) => CarvingEdits.Do(stack, "Place Clip Sphere", carving => carving.SetActive(Centre, radiusMm));
    }
}
