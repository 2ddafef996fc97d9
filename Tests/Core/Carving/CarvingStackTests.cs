using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Carving
{
    /// <summary>What each edit of a carving does.</summary>
    public sealed class CarvingStackTests
    {
        const int SegmentCount = 6;

        static readonly PointMm Here = new PointMm(1, 2, 3);
        static readonly PointMm There = new PointMm(-4, 5.5, 6);

        CarvingStack stack;
        List<CarvingChange> changes;

        [SetUp]
        public void MakeStack()
        {
            stack = new CarvingStack(SegmentCount);
            changes = new List<CarvingChange>();
            stack.Changed += changes.Add;
        }

        [Test]
        public void New_Stack_IsEmptyAndItsFirstSphereClipsAll()
        {
            Assert.That(stack.Spheres, Is.Empty);
            Assert.That(stack.Active, Is.Null);

            stack.SetActive(Here, 10);

            Assert.That(stack.Active, Is.EqualTo(new ClipSphere(Here, 10, SegmentMask.All(SegmentCount))));
        }

        [Test]
        public void FixActive_AfterToggle_KeepsTheMaskAndLeavesASmallerActiveSphereWithACopy()
        {
            stack.SetActive(Here, 10);
            stack.ToggleSegment(2);
            SegmentMask mask = stack.ActiveMask;

            stack.FixActive();
            stack.ToggleSegment(3);

            Assert.That(stack.Fixed, Is.EqualTo(new[] { new ClipSphere(Here, 10, mask) }));
            Assert.That(stack.Active, Is.EqualTo(new ClipSphere(Here, 7.5, mask.Toggled(3))));
            Assert.That(stack.Spheres, Is.EqualTo(new[] { stack.Fixed[0], stack.Active }));
        }

        [Test]
        public void FixActive_OtherFactor_IsApplied()
        {
            stack.ActiveRadiusFactor = 0.5f;
            stack.SetActive(Here, 8);
            stack.FixActive();
            Assert.That(stack.Active.RadiusMm, Is.EqualTo(4));
        }

        [Test]
        public void FixActive_NoActiveSphere_Throws() =>
            Assert.That(() => stack.FixActive(), Throws.InstanceOf<InvalidOperationException>());

        [Test]
        public void RemoveLast_AfterMaskChange_LeavesTheActiveSphereAndItsMaskAlone()
        {
            stack.SetActive(Here, 10);
            stack.FixActive();
            stack.ToggleSegment(1);
            ClipSphere active = stack.Active;

            Assert.That(stack.RemoveLast());

            Assert.That(stack.Fixed, Is.Empty);
            Assert.That(stack.Active, Is.EqualTo(active));
            Assert.That(stack.RemoveLast(), Is.False);
        }

        [Test]
        public void ResetMask_Repeatedly_GoesAllOffThenAllOn()
        {
            stack.SetActive(Here, 10);
            stack.ResetMask();
            Assert.That(stack.ActiveMask.IsNone);
            stack.ToggleSegment(4);
            stack.ResetMask();
            Assert.That(stack.ActiveMask.IsAll);
        }

        [Test]
        public void SetSegment_OfAFixedSphere_ChangesThatSphereOnly()
        {
            stack.SetActive(Here, 10);
            stack.FixActive();
            stack.FixActive();

            stack.SetSegment(0, 5, false);

            Assert.That(stack.Spheres.Select(sphere => sphere.Mask[5]), Is.EqualTo(new[] { false, true, true }));
            Assert.That(changes.Last().SphereIndex, Is.EqualTo(0));
            Assert.That(changes.Last().Before.Mask[5], Is.True);
            Assert.That(changes.Last().After.Mask[5], Is.False);
        }

        [Test]
        public void RemoveActive_ThenSetActive_KeepsTheMask()
        {
            stack.SetActive(Here, 10);
            stack.ToggleSegment(0);
            stack.RemoveActive();
            Assert.That(stack.Spheres, Is.Empty);

            stack.SetActive(There, 3);

            Assert.That(stack.ActiveMask.ClippedSegments(), Is.EqualTo(new[] { 1, 2, 3, 4, 5 }));
        }

        [Test]
        public void Clear_Stack_GoesBackToTheBeginning()
        {
            stack.SetActive(Here, 10);
            stack.ToggleSegment(0);
            stack.FixActive();

            stack.Clear();

            Assert.That(stack.Spheres, Is.Empty);
            Assert.That(stack.ActiveMask.IsAll);
            stack.Undo();
            Assert.That(stack.Spheres, Has.Count.EqualTo(2));
        }

        [Test]
        public void Replace_WithSpheres_TakesThemInOrder()
        {
            var first = new ClipSphere(Here, 1, SegmentMask.All(SegmentCount));
            var second = new ClipSphere(There, 2, SegmentMask.None(SegmentCount));

            stack.Replace(new[] { first, second }, first);

            Assert.That(stack.Spheres, Is.EqualTo(new[] { first, second, first }));
        }

        [Test]
        public void Replace_MaskOfAnotherSize_ThrowsAndChangesNothing()
        {
            stack.SetActive(Here, 10);
            Assert.That(
                () => stack.Replace(new[] { new ClipSphere(Here, 1, SegmentMask.All(SegmentCount + 1)) }),
                Throws.InstanceOf<ArgumentException>());
            Assert.That(stack.Active.RadiusMm, Is.EqualTo(10));
            Assert.That(stack.Version, Is.EqualTo(1));
        }

        [Test]
        public void Changed_EveryEdit_CarriesBeforeAndAfterAndTheVersion()
        {
            stack.SetActive(Here, 10);
            stack.SetActive(There, 10);
            stack.FixActive();
            stack.RemoveLast();

            Assert.That(changes.Select(change => change.Kind), Is.EqualTo(new[]
            {
                CarvingChangeKind.ActiveSet, CarvingChangeKind.ActiveSet, CarvingChangeKind.ActiveFixed, CarvingChangeKind.LastRemoved,
            }));
            Assert.That(changes.Select(change => change.Version), Is.EqualTo(new[] { 1, 2, 3, 4 }));
            Assert.That(changes[0].Before, Is.Null);
            Assert.That(changes[1].Before.CentreLps, Is.EqualTo(Here));
            Assert.That(changes[1].After.CentreLps, Is.EqualTo(There));
            Assert.That(changes[3].After, Is.EqualTo(stack.Active));
            for (int n = 1; n < changes.Count; n++)
                Assert.That(changes[n].BeforeState, Is.SameAs(changes[n - 1].AfterState));
        }

        [Test]
        public void Edit_ThatChangesNothing_IsNoChange()
        {
            stack.SetActive(Here, 10);
            stack.SetActive(Here, 10);
            stack.SetActiveMask(SegmentMask.All(SegmentCount));
            stack.SetSegment(0, 3, true);
            Assert.That(stack.Version, Is.EqualTo(1));
            Assert.That(changes, Has.Count.EqualTo(1));
        }

        [Test]
        public void SetActive_NotFinite_ThrowsAndChangesNothing()
        {
            Assert.That(() => stack.SetActive(new PointMm(double.NaN, 0, 0), 1), Throws.InstanceOf<ArgumentException>());
            Assert.That(() => stack.SetActive(Here, -1), Throws.InstanceOf<ArgumentException>());
            Assert.That(stack.Version, Is.EqualTo(0));
        }

        [TestCase(0f)]
        [TestCase(-1f)]
        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        public void ActiveRadiusFactor_OutsideItsRange_Throws(float factor) =>
            Assert.That(() => stack.ActiveRadiusFactor = factor, Throws.InstanceOf<ArgumentOutOfRangeException>());
    }
}
