using System;
using System.Collections;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>How volumes look: saved with the renderer, by label.</summary>
    sealed class AppearanceTests : PlayModeScene
    {
        const long LeftLabel = 10 * Phantoms.Left;

        [Test]
        public void Segment_ThatIsSet_IsShownSo_AndTheOthersAsTheVolumeSays()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers(20));
            Segment right = renderer.Segments[Phantoms.Right];
            renderer.Appearance.SetSegment(new SegmentAppearance(LeftLabel, Color.red, 0.25f));
            Assert.That(renderer.Segments[Phantoms.Left].Color, Is.EqualTo(new SegmentColor(255, 0, 0)));
            Assert.That(renderer.Segments[Phantoms.Left].Opacity, Is.EqualTo(0.25f));
            Assert.That(renderer.Segments[Phantoms.Left].Name, Is.EqualTo("Left"));
            Assert.That(renderer.Segments[Phantoms.Right], Is.SameAs(right));
            renderer.Appearance.SetSegment(new SegmentAppearance(LeftLabel, Color.green, 1f));
            Assert.That(renderer.Appearance.Segments, Has.Count.EqualTo(1), "a label looks one way");
            Assert.That(renderer.Appearance.ResetSegment(LeftLabel), Is.True);
            Assert.That(renderer.Appearance.ResetSegment(LeftLabel), Is.False);
            Assert.That(renderer.Segments, Is.SameAs(renderer.Volume.Segments));
        }

        [Test]
        public void Segment_Invisible_IsNotInThePicture()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers(20));
            Assert.That(Count(renderer.Render(FrontView(renderer.Volume)).Read(), Phantoms.Left), Is.GreaterThan(0));
            renderer.Appearance.SetSegment(new SegmentAppearance(LeftLabel, Color.red, 0f));
            Assert.That(Count(renderer.Render(FrontView(renderer.Volume)).Read(), Phantoms.Left), Is.Zero);
            renderer.Appearance.ResetSegments();
            Assert.That(Count(renderer.Render(FrontView(renderer.Volume)).Read(), Phantoms.Left), Is.GreaterThan(0));
        }

        [Test]
        public void Segment_OfALabelThatTheVolumeLacks_ChangesNothing()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers(20));
            renderer.Appearance.SetSegment(new SegmentAppearance(4711, Color.red, 0f));
            Assert.That(renderer.Segments, Is.EqualTo(renderer.Volume.Segments));
        }

        [Test]
        public void Segments_WithoutAChange_AreTheSameObject()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers(20));
            renderer.Appearance.SetSegment(new SegmentAppearance(LeftLabel, Color.red, 0.25f));
            SegmentTable first = renderer.Segments;
            Assert.That(renderer.Segments, Is.SameAs(first));
        }

        [Test]
        public void Appearance_ToldOfChangesThatThereAreNot_StaysTheSameObjects()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers(20));
            renderer.Appearance.SetSegment(new SegmentAppearance(LeftLabel, Color.red, 0.25f));
            SegmentTable segments = renderer.Segments;
            OpacityTransferFunction function = renderer.TransferFunction;
            renderer.Render(FrontView(renderer.Volume));
            renderer.Appearance.Clamp(); // as the Inspector and undo do
            Assert.That(renderer.Segments, Is.SameAs(segments));
            Assert.That(renderer.TransferFunction, Is.SameAs(function));
            int dispatches = renderer.Statistics.VolumeDispatches;
            renderer.Render(FrontView(renderer.Volume));
            Assert.That(renderer.Statistics.VolumeDispatches, Is.EqualTo(dispatches));
        }

        [Test]
        public void Opacity_OutsideItsRange_IsRefused([Values(-0.1f, 1.1f, float.NaN)] float opacity) =>
            Assert.That(() => new SegmentAppearance(1, Color.red, opacity), Throws.InstanceOf<ArgumentOutOfRangeException>());

        [Test]
        public void Appearance_OfAnotherVolume_IsKept_WhileATableOfAScriptIsNot()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers(20));
            renderer.Appearance.SetSegment(new SegmentAppearance(LeftLabel, Color.red, 0.25f));
            renderer.Segments = renderer.Volume.Segments.With(new[] { (LeftLabel, new SegmentColor(1, 2, 3), 1f) });
            Assert.That(renderer.Segments[Phantoms.Left].Color, Is.EqualTo(new SegmentColor(1, 2, 3)), "the script's table counts");
            renderer.Loader.SetVolume(Phantoms.Markers(24));
            Assert.That(renderer.Segments[Phantoms.Left].Color, Is.EqualTo(new SegmentColor(255, 0, 0)), "by label");
            Assert.That(renderer.TransferFunction.ToString(), Is.EqualTo(Opaque().ToString()));
        }

        [Test]
        public void TransferFunction_SetToNull_IsTheVolumesOwn()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers(20));
            renderer.TransferFunction = null;
            Assert.That(renderer.Appearance.TransferFunction, Is.Null);
            Assert.That(renderer.TransferFunction, Is.SameAs(renderer.Volume.AutomaticTransferFunction));
        }

        [UnityTest]
        public IEnumerator Copy_OfARenderer_LooksTheSame()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers(20));
            renderer.Appearance.SetSegment(new SegmentAppearance(LeftLabel, Color.red, 0.25f));
            renderer.Layout = TextureLayout.Portable;
            GameObject copy = Own(Object.Instantiate(renderer.gameObject));
            copy.GetComponent<VolumeLoader>().SetVolume(renderer.Volume);
            yield return null;
            var other = copy.GetComponent<CarvedVolumeRenderer>();
            Assert.That(other.TransferFunction.ToString(), Is.EqualTo(Opaque().ToString()));
            Assert.That(other.Segments[Phantoms.Left].Opacity, Is.EqualTo(0.25f));
            Assert.That(other.Layout, Is.EqualTo(TextureLayout.Portable));
            other.Appearance.ResetSegments();
            Assert.That(renderer.Appearance.Segments, Has.Count.EqualTo(1), "a copy of its own");
        }
    }
}
