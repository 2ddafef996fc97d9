using System.Collections.Generic;
using System.IO;
using System.Linq;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Volumes
{
    public sealed class PredefinedSegmentColorsTests
    {
        [Test]
        public void EveryLabelAndNameOfSlicersTable_HasItsColour()
        {
            JArray table = JArray.Parse(File.ReadAllText(SharedData.PathOf("tables/generic_anatomy_colors.json")));
            Assert.That(table, Has.Count.EqualTo(310));
            foreach (JToken row in table.Skip(1))
            {
                var color = new SegmentColor((byte)row["rgb"][0], (byte)row["rgb"][1], (byte)row["rgb"][2]);
                Assert.That(PredefinedSegmentColors.ForLabel((long)row["label"]), Is.EqualTo(color), (string)row["name"]);
                Assert.That(PredefinedSegmentColors.TryForName((string)row["name"], out _), Is.True, (string)row["name"]);
            }
        }

        [TestCase("liver")]
        [TestCase(" LIVER ")]
        public void Name_InAnySpelling_IsFound(string name)
        {
            Assert.That(PredefinedSegmentColors.TryForName(name, out SegmentColor color), Is.True);
            Assert.That(color, Is.EqualTo(new SegmentColor(221, 130, 101)));
        }

        [Test]
        public void UnderscoresBlanksAndHyphens_AreTheSame()
        {
            Assert.That(PredefinedSegmentColors.TryForName("connective tissue", out SegmentColor blank), Is.True);
            Assert.That(PredefinedSegmentColors.TryForName("Connective-Tissue", out SegmentColor hyphen), Is.True);
            Assert.That(blank, Is.EqualTo(hyphen).And.EqualTo(new SegmentColor(111, 184, 210)));
        }

        [Test]
        public void UnknownOrMissingName_IsNotFound()
        {
            Assert.That(PredefinedSegmentColors.TryForName("no such thing", out _), Is.False);
            Assert.That(PredefinedSegmentColors.TryForName(null, out _), Is.False);
        }

        [Test]
        public void LabelsBeyondTheTable_HaveColoursThatAreVisibleAndDiffer()
        {
            SegmentColor[] colors = Enumerable.Range(310, 500).Select(label => PredefinedSegmentColors.ForLabel(label)).ToArray();
            Assert.That(new HashSet<SegmentColor>(colors), Has.Count.GreaterThan(480));
            Assert.That(colors.Select(color => color.R + color.G + color.B), Is.All.GreaterThan(150));
            Assert.That(colors.Zip(colors.Skip(1), Distance), Is.All.GreaterThan(40));
        }

        [Test]
        public void AnyLabel_HasAColour()
        {
            foreach (long label in new[] { long.MinValue, -1, 0, 309, 310, 65535, 1L << 53, long.MaxValue })
                Assert.That(PredefinedSegmentColors.ForLabel(label), Is.Not.EqualTo(new SegmentColor(0, 0, 0)), label.ToString());
        }

        static int Distance(SegmentColor a, SegmentColor b) =>
            System.Math.Abs(a.R - b.R) + System.Math.Abs(a.G - b.G) + System.Math.Abs(a.B - b.B);
    }
}
