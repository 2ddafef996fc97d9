using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Editor;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>Edits of many segments' looks, and hiding and showing.</summary>
    sealed class SegmentLooksTests
    {
        static readonly SegmentTable Table = SegmentTables.Some.WithOpacity(3, 0.25f);
        static readonly int[] Kidneys = { 2, 3 };

        [Test]
        public void Result_WithoutAnEdit_IsWhatWasThere()
        {
            var overrides = new[] { new SegmentAppearance(5, Color.red, 0.5f), new SegmentAppearance(11, Color.blue, 1f) };
            Assert.That(new SegmentLooks(Table, overrides).Result(), Is.EqualTo(overrides));
        }

        [Test]
        public void Segments_ThatLookAsTheVolumeSays_AreNotListed()
        {
            SegmentLooks looks = None();
            looks.SetOpacity(1, 0.5f);
            looks.SetOpacity(2, 0.5f);
            looks.SetOpacity(1, 1f);
            Assert.That(looks.Result().Select(l => l.Label), Is.EqualTo(new[] { 11L }));
        }

        [Test]
        public void Segments_ThatTheVolumeDoesNotHave_AreKept()
        {
            var looks = new SegmentLooks(Table, new[] { new SegmentAppearance(4711, Color.red, 0.5f) });
            looks.SetOpacity(1, 0.5f);
            Assert.That(looks.Result().Select(l => l.Label), Is.EqualTo(new[] { 4711L, 5L }));
        }

        [Test]
        public void Overrides_OfOneLabelTwice_CountAsTheLast()
        {
            var looks = new SegmentLooks(Table, new[] { new SegmentAppearance(5, Color.red, 0.5f), new SegmentAppearance(5, Color.blue, 0.75f) });
            Assert.That(looks.Result(), Is.EqualTo(new[] { new SegmentAppearance(5, Color.blue, 0.75f) }));
        }

        [Test]
        public void Color_OfASegment_KeepsItsOpacity()
        {
            SegmentLooks looks = None();
            looks.SetColor(3, Color.green);
            Assert.That(looks.Result(), Is.EqualTo(new[] { new SegmentAppearance(12, Color.green, 0.25f) }));
        }

        [Test]
        public void Reset_OfASegment_TakesItFromTheList()
        {
            var looks = new SegmentLooks(Table, new[] { new SegmentAppearance(5, Color.red, 0.5f) });
            looks.Reset(1);
            Assert.That(looks.Result(), Is.Empty);
        }

        [Test]
        public void Looks_OfAnUntouchedSegment_AreTheVolumes()
        {
            SegmentAppearance look = None()[3];
            Assert.That(look.Label, Is.EqualTo(12));
            Assert.That(look.Opacity, Is.EqualTo(0.25f));
            Assert.That((Color32)look.Color, Is.EqualTo(new Color32(30, 100, 200, 255)));
        }

        [Test]
        public void Show_AfterHide_GivesTheOpacityBack()
        {
            var visibility = new SegmentVisibility();
            SegmentLooks looks = None();
            looks.SetOpacity(1, 0.6f);
            visibility.Hide(looks, 1);
            Assert.That(looks[1].Opacity, Is.Zero);
            visibility.Hide(looks, 1);
            visibility.Show(looks, 1, Table[1]);
            Assert.That(looks[1].Opacity, Is.EqualTo(0.6f));
        }

        [Test]
        public void Show_OfASegmentThatWasAlwaysHidden_GivesTheVolumesOpacity()
        {
            var looks = new SegmentLooks(Table, new[] { new SegmentAppearance(12, Color.red, 0f) });
            new SegmentVisibility().Show(looks, 3, Table[3]);
            Assert.That(looks[3].Opacity, Is.EqualTo(0.25f));
        }

        [Test]
        public void Show_OfASegmentThatTheVolumeHides_MakesItOpaque()
        {
            SegmentTable hidden = Table.WithOpacity(1, 0f);
            var looks = new SegmentLooks(hidden, new List<SegmentAppearance>());
            new SegmentVisibility().Show(looks, 1, hidden[1]);
            Assert.That(looks[1].Opacity, Is.EqualTo(1f));
        }

        [Test]
        public void ShowOnly_OfSome_HidesAllOthers()
        {
            var visibility = new SegmentVisibility();
            SegmentLooks looks = None();
            visibility.Hide(looks, Kidneys);
            visibility.ShowOnly(looks, Kidneys, Table);
            Assert.That(Enumerable.Range(0, Table.Count).Select(row => looks[row].Opacity), Is.EqualTo(new[] { 0f, 0f, 1f, 0.25f, 0f }));
            visibility.Show(looks, Enumerable.Range(0, Table.Count).ToArray(), Table);
            Assert.That(looks.Result(), Is.Empty);
        }

        static SegmentLooks None() => new SegmentLooks(Table, new List<SegmentAppearance>());
    }
}
