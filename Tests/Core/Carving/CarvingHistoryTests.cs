using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Carving
{
    /// <summary>Undo, redo and gestures, as laws over random scripts of edits and by example.</summary>
    public sealed class CarvingHistoryTests
    {
        const int SegmentCount = 40;

        [Test]
        public void UndoThenRedo_AnyScript_GoesThroughTheSameStatesBackAndForth()
        {
            var scenes = new RandomScenes(31);
            for (int script = 0; script < 300; script++)
            {
                var stack = new CarvingStack(SegmentCount);
                var states = new List<CarvingSnapshot> { stack.State };
                stack.Changed += change => states.Add(change.AfterState);
                for (int n = 0; n < 30; n++)
                    Edit(stack, scenes);
                CarvingSnapshot[] forth = states.ToArray();

                for (int n = forth.Length - 1; n > 0; n--)
                {
                    Assert.That(stack.Undo());
                    AssertSame(stack.State, forth[n - 1]);
                }
                Assert.That(stack.CanUndo, Is.False);
                Assert.That(stack.Undo(), Is.False);
                for (int n = 1; n < forth.Length; n++)
                {
                    Assert.That(stack.Redo());
                    AssertSame(stack.State, forth[n]);
                }
                Assert.That(stack.Redo(), Is.False);
                Assert.That(stack.Version, Is.EqualTo(3 * (forth.Length - 1)));
            }
        }

        [Test]
        public void UndoAndRedo_MixedWithEdits_FollowAListOfStates()
        {
            var scenes = new RandomScenes(32);
            for (int script = 0; script < 200; script++)
            {
                var stack = new CarvingStack(SegmentCount);
                var model = new List<CarvingSnapshot> { stack.State };
                int place = 0;
                for (int n = 0; n < 60; n++)
                {
                    if (scenes.Chance(0.3))
                    {
                        Assert.That(stack.Undo(), Is.EqualTo(place > 0));
                        place = Math.Max(0, place - 1);
                    }
                    else if (scenes.Chance(0.3))
                    {
                        Assert.That(stack.Redo(), Is.EqualTo(place < model.Count - 1));
                        place = Math.Min(model.Count - 1, place + 1);
                    }
                    else
                    {
                        int version = stack.Version;
                        Edit(stack, scenes);
                        if (stack.Version > version)
                        {
                            model.RemoveRange(place + 1, model.Count - place - 1);
                            model.Add(stack.State);
                            place++;
                        }
                    }
                    AssertSame(stack.State, model[place]);
                }
            }
        }

        [Test]
        public void Gesture_ManyMoves_AreOneStep()
        {
            var stack = new CarvingStack(SegmentCount);
            stack.SetActive(default, 5);
            stack.BeginGesture();
            for (int n = 1; n <= 50; n++)
                stack.SetActive(new PointMm(n, 0, 0), 5);
            stack.EndGesture();
            stack.SetActive(new PointMm(99, 0, 0), 5);

            stack.Undo();
            Assert.That(stack.Active.CentreLps.X, Is.EqualTo(50));
            stack.Undo();
            Assert.That(stack.Active.CentreLps.X, Is.EqualTo(0));
            stack.Redo();
            Assert.That(stack.Active.CentreLps.X, Is.EqualTo(50));
        }

        [Test]
        public void Gesture_FixInItsMiddle_IsAStepOfItsOwn()
        {
            var stack = new CarvingStack(SegmentCount);
            stack.BeginGesture();
            stack.SetActive(new PointMm(1, 0, 0), 8);
            stack.SetActive(new PointMm(2, 0, 0), 8);
            stack.FixActive();
            stack.SetActive(new PointMm(3, 0, 0), 8);
            stack.EndGesture();

            stack.Undo();
            Assert.That(stack.Active.RadiusMm, Is.EqualTo(6));
            stack.Undo();
            Assert.That(stack.Fixed, Is.Empty);
            Assert.That(stack.Active.CentreLps.X, Is.EqualTo(2));
            stack.Undo();
            Assert.That(stack.Active, Is.Null);
        }

        [Test]
        public void Gesture_BackToItsBeginning_LeavesNoStep()
        {
            var stack = new CarvingStack(SegmentCount);
            stack.SetActive(default, 5);
            stack.BeginGesture();
            stack.SetActive(new PointMm(1, 0, 0), 5);
            stack.SetActive(default, 5);
            stack.EndGesture();

            stack.Undo();

            Assert.That(stack.Active, Is.Null);
        }

        [Test]
        public void TwoGestures_OneAfterTheOther_AreTwoSteps()
        {
            var stack = new CarvingStack(SegmentCount);
            for (int gesture = 1; gesture <= 2; gesture++)
            {
                stack.BeginGesture();
                stack.BeginGesture();
                stack.SetActive(new PointMm(gesture, 0, 0), 5);
                stack.EndGesture();
                stack.SetActive(new PointMm(gesture, 1, 0), 5);
                stack.EndGesture();
            }

            stack.Undo();

            Assert.That(stack.Active.CentreLps, Is.EqualTo(new PointMm(1, 1, 0)));
        }

        [Test]
        public void EndGesture_WithoutBegin_Throws() =>
            Assert.That(() => new CarvingStack(1).EndGesture(), Throws.InstanceOf<InvalidOperationException>());

        [Test]
        public void HistoryLimit_Reached_ForgetsTheOldest()
        {
            var stack = new CarvingStack(SegmentCount) { HistoryLimit = 3 };
            for (int n = 1; n <= 10; n++)
                stack.SetActive(default, n);

            int undone = 0;
            while (stack.Undo())
                undone++;

            Assert.That(undone, Is.EqualTo(3));
            Assert.That(stack.Active.RadiusMm, Is.EqualTo(7));
            stack.HistoryLimit = 0;
            Assert.That(stack.CanRedo, Is.False);
        }

        [Test]
        public void Undo_RaisesTheChangeBackwards()
        {
            var stack = new CarvingStack(SegmentCount);
            stack.SetActive(default, 4);
            var changes = new List<CarvingChange>();
            stack.Changed += changes.Add;

            stack.Undo();
            stack.Redo();

            Assert.That(changes.Select(change => change.Cause), Is.EqualTo(new[] { CarvingCause.Undone, CarvingCause.Redone }));
            Assert.That(changes[0].Before.RadiusMm, Is.EqualTo(4));
            Assert.That(changes[0].After, Is.Null);
            Assert.That(changes[1].After.RadiusMm, Is.EqualTo(4));
        }

        static void Edit(CarvingStack stack, RandomScenes scenes)
        {
            var geometry = new VolumeGeometry(20, 20, 20, Affine.Identity);
            switch (scenes.Next(10))
            {
                case 0 when stack.Active != null:
                case 1 when stack.Active != null:
                    stack.FixActive();
                    break;
                case 2:
                    stack.RemoveLast();
                    break;
                case 3:
                    stack.ToggleSegment(scenes.Next(SegmentCount));
                    break;
                case 4 when stack.Spheres.Count > 0:
                    stack.SetSegment(scenes.Next(stack.Spheres.Count), scenes.Next(SegmentCount), scenes.Chance(0.5));
                    break;
                case 5:
                    stack.ResetMask();
                    break;
                case 6 when scenes.Chance(0.2):
                    stack.Clear();
                    break;
                case 7 when scenes.Chance(0.3):
                    stack.Replace(scenes.Spheres(geometry, SegmentCount, 4), scenes.Chance(0.5) ? scenes.Sphere(geometry, SegmentCount) : null);
                    break;
                case 8:
                    stack.RemoveActive();
                    break;
                default:
                    ClipSphere place = scenes.Sphere(geometry, SegmentCount);
                    stack.SetActive(place.CentreLps, place.RadiusMm);
                    break;
            }
        }

        static void AssertSame(CarvingSnapshot actual, CarvingSnapshot expected)
        {
            Assert.That(actual, Is.EqualTo(expected));
            Assert.That(actual.Active, Is.EqualTo(expected.Active));
            Assert.That(actual.ActiveMask, Is.EqualTo(expected.ActiveMask));
        }
    }
}
