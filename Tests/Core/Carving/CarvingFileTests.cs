using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Carving
{
    public sealed class CarvingFileTests
    {
        const string Sphere = "{\"centerMm\": [1, 2, 3], \"radiusMm\": 4, \"clipped\": []}";

        string folder;

        [SetUp]
        public void MakeFolder()
        {
            folder = Path.Combine(Path.GetTempPath(), "carving-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(folder);
        }

        [TearDown]
        public void RemoveFolder() => Directory.Delete(folder, true);

        [Test]
        public void Parse_TheDocumentedExample_IsUnderstood()
        {
            CarvingDocument document = CarvingFile.Parse(
                "{\"version\": 1, \"space\": \"LPS\", \"spheres\": [{\"centerMm\": [1.5, -2, 3e1], \"radiusMm\": 40, \"clipped\": [{\"label\": 5, \"name\": \"liver\"}]}]}");

            Assert.That(document.Fixed, Has.Count.EqualTo(1));
            Assert.That(document.Fixed[0].CentreLps, Is.EqualTo(new PointMm(1.5, -2, 30)));
            Assert.That(document.Fixed[0].RadiusMm, Is.EqualTo(40));
            Assert.That(document.Fixed[0].Clipped, Is.EqualTo(new[] { new SegmentReference(5, "liver") }));
            Assert.That(document.Active, Is.Null);
            Assert.That(document.Warnings, Is.Empty);
        }

        [Test]
        public void SaveAndLoad_RandomCarvings_RoundTripExactly()
        {
            var scenes = new RandomScenes(101);
            for (int n = 0; n < 300; n++)
            {
                int segmentCount = scenes.Between(1, 80);
                SegmentTable segments = Phantoms.Segments(segmentCount);
                VolumeGeometry geometry = scenes.Geometry(30);
                var stack = new CarvingStack(segmentCount);
                stack.Replace(scenes.Spheres(geometry, segmentCount, 5), scenes.Chance(0.5) ? scenes.Sphere(geometry, segmentCount) : null);

                string text = CarvingFile.Format(CarvingBinding.Document(stack.State, segments));
                CarvingBinding loaded = CarvingBinding.Bind(CarvingFile.Parse(text), segments);

                Assert.That(loaded.Warnings, Is.Empty);
                Assert.That(loaded.Fixed, Is.EqualTo(stack.Fixed));
                Assert.That(loaded.Active, Is.EqualTo(stack.Active));
                Assert.That(CarvingFile.Format(CarvingBinding.Document(stack.State, segments, CarvingFile.Parse(text))), Is.EqualTo(text));
            }
        }

        [TestCase(double.Epsilon)]
        [TestCase(ClipSphere.LargestMm)]
        [TestCase(-ClipSphere.LargestMm)]
        [TestCase(0.1 + 0.2)]
        [TestCase(1.0 / 3)]
        [TestCase(9007199254740993)]
        [TestCase(123456789012345680.0)]
        public void SaveAndLoad_AnyNumber_KeepsEveryBit(double number)
        {
            var sphere = new CarvingDocumentSphere(new PointMm(number, -number, number), Math.Abs(number), Enumerable.Empty<SegmentReference>());

            CarvingDocumentSphere read = CarvingFile.Parse(CarvingFile.Format(new CarvingDocument(new[] { sphere }))).Fixed[0];

            Assert.That(BitConverter.DoubleToInt64Bits(read.CentreLps.X), Is.EqualTo(BitConverter.DoubleToInt64Bits(number)));
            Assert.That(BitConverter.DoubleToInt64Bits(read.CentreLps.Y), Is.EqualTo(BitConverter.DoubleToInt64Bits(-number)));
            Assert.That(read.RadiusMm, Is.EqualTo(Math.Abs(number)));
        }

        [Test]
        public void SaveAndLoad_MinusZero_IsZero()
        {
            var sphere = new CarvingDocumentSphere(new PointMm(-0.0, 0, 0), 1, Enumerable.Empty<SegmentReference>());
            string text = CarvingFile.Format(new CarvingDocument(new[] { sphere }));
            Assert.That(text, Does.Contain("[0, 0, 0]"));
            Assert.That(CarvingFile.Parse(text).Fixed[0].CentreLps, Is.EqualTo(new PointMm(0, 0, 0)));
        }

        [Test]
        public void SaveAndLoad_CultureWithADecimalComma_IsIdentical()
        {
            CultureInfo before = Thread.CurrentThread.CurrentCulture;
            try
            {
                var document = new CarvingDocument(new[] { new CarvingDocumentSphere(new PointMm(1.5, -2.25, 1e-7), 3.75, new[] { new SegmentReference(-12, "a") }) });
                string text = CarvingFile.Format(document);
                Thread.CurrentThread.CurrentCulture = new CultureInfo("de-DE");
                Assert.That(CarvingFile.Format(document), Is.EqualTo(text));
                Assert.That(CarvingFile.Parse(text).Fixed[0].CentreLps, Is.EqualTo(new PointMm(1.5, -2.25, 1e-7)));
            }
            finally
            {
                Thread.CurrentThread.CurrentCulture = before;
            }
        }

        [Test]
        public void Parse_Ras_NegatesXAndY()
        {
            CarvingDocument document = CarvingFile.Parse("{\"version\": 1, \"space\": \"RAS\", \"spheres\": [" + Sphere + "]}");
            Assert.That(document.Fixed.Single().CentreLps, Is.EqualTo(new PointMm(-1, -2, 3)));
        }

        [Test]
        public void Format_ActiveSphere_IsTheLastOfTheSpheres()
        {
            var sphere = new CarvingDocumentSphere(new PointMm(1, 2, 3), 4, new SegmentReference[0]);
            JObject json = JObject.Parse(CarvingFile.Format(new CarvingDocument(new[] { sphere }, sphere)));
            Assert.That(json["spheres"].Select(s => (bool?)s["active"]), Is.EqualTo(new bool?[] { null, true }));
            Assert.That(json.Properties().Select(p => p.Name), Is.EqualTo(new[] { "version", "space", "spheres" }));
        }

        [TestCase("true", "spheres[0].active", "true")]
        [TestCase("1", "spheres[0].active", "1")]
        public void Parse_ActiveSphereThatIsNotTheLast_IsRefused(string active, string field, string found)
        {
            string first = Sphere.TrimEnd('}') + ", \"active\": " + active + "}";
            CarvingFileException problem = Refused("{\"version\": 1, \"space\": \"LPS\", \"spheres\": [" + first + ", " + Sphere + "]}");
            Assert.That(problem.Field, Is.EqualTo(field));
            Assert.That(problem.FoundValue, Is.EqualTo(found));
        }

        [Test]
        public void Parse_UnknownField_IsAWarning()
        {
            CarvingDocument document = CarvingFile.Parse("{\"version\": 1, \"space\": \"LPS\", \"spheres\": [], \"colour\": 3}", "my.json");
            Assert.That(document.Warnings.Single(), Does.Contain("my.json").And.Contain("\"colour\""));
        }

        [TestCase("", "the text")]
        [TestCase("{", "the text")]
        [TestCase("[]", "the whole")]
        [TestCase("{}", "version")]
        [TestCase("{\"version\": 1, \"version\": 1}", "the text")]
        [TestCase("{\"version\": 1, \"spheres\": []}", "space")]
        [TestCase("{\"version\": 1, \"space\": \"XYZ\", \"spheres\": []}", "space")]
        [TestCase("{\"version\": 1, \"space\": \"LPS\"}", "spheres")]
        [TestCase("{\"version\": 1, \"space\": \"LPS\", \"spheres\": {}}", "spheres")]
        [TestCase("{\"version\": 1, \"space\": \"LPS\", \"spheres\": []} x", "the text")]
        [TestCase("{\"version\": 1, \"space\": \"LPS\", \"spheres\": []} {}", "the text")]
        [TestCase("{\"version\": \"1\", \"space\": \"LPS\", \"spheres\": []}", "version")]
        [TestCase("{\"version\": 1.0, \"space\": \"LPS\", \"spheres\": []}", "version")]
        public void Parse_NoCarvingFile_IsRefusedByField(string json, string field)
        {
            CarvingFileException problem = Refused(json);
            Assert.That(problem.Field, Is.EqualTo(field));
            Assert.That(problem.Message, Does.StartWith("test.json: " + field + " is "));
        }

        [TestCase("3", "spheres[0]", "3")]
        [TestCase("{\"radiusMm\": 1, \"clipped\": []}", "spheres[0].centerMm", "missing")]
        [TestCase("{\"centerMm\": [1, 2], \"radiusMm\": 1, \"clipped\": []}", "spheres[0].centerMm", "[1,2]")]
        [TestCase("{\"centerMm\": [1, \"2\", 3], \"radiusMm\": 1, \"clipped\": []}", "spheres[0].centerMm[1]", "\"2\"")]
        [TestCase("{\"centerMm\": [1, 2, NaN], \"radiusMm\": 1, \"clipped\": []}", "spheres[0].centerMm[2]", "NaN")]
        [TestCase("{\"centerMm\": [1, 2, 3], \"radiusMm\": Infinity, \"clipped\": []}", "spheres[0].radiusMm", "Infinity")]
        [TestCase("{\"centerMm\": [1, 2, 3], \"radiusMm\": -1, \"clipped\": []}", "spheres[0].radiusMm", "-1")]
        [TestCase("{\"centerMm\": [1, -2e18, 3], \"radiusMm\": 1, \"clipped\": []}", "spheres[0].centerMm[1]", "-2E+18")]
        [TestCase("{\"centerMm\": [1, 2, 3], \"radiusMm\": 1.5e18, \"clipped\": []}", "spheres[0].radiusMm", "1.5E+18")]
        [TestCase("{\"centerMm\": [1, 2, 3], \"clipped\": []}", "spheres[0].radiusMm", "missing")]
        [TestCase("{\"centerMm\": [1, 2, 3], \"radiusMm\": 1}", "spheres[0].clipped", "missing")]
        [TestCase("{\"centerMm\": [1, 2, 3], \"radiusMm\": 1, \"clipped\": [{}]}", "spheres[0].clipped[0]", "{}")]
        [TestCase("{\"centerMm\": [1, 2, 3], \"radiusMm\": 1, \"clipped\": [{\"label\": 1.5}]}", "spheres[0].clipped[0].label", "1.5")]
        [TestCase("{\"centerMm\": [1, 2, 3], \"radiusMm\": 1, \"clipped\": [{\"label\": 99999999999999999999}]}", "spheres[0].clipped[0].label", "99999999999999999999")]
        [TestCase("{\"centerMm\": [1, 2, 3], \"radiusMm\": 1, \"clipped\": [{\"name\": 4}]}", "spheres[0].clipped[0].name", "4")]
        public void Parse_BadSphere_IsRefusedByFieldAndValue(string sphere, string field, string found)
        {
            CarvingFileException problem = Refused("{\"version\": 1, \"space\": \"LPS\", \"spheres\": [" + sphere + "]}");
            Assert.That(problem.Field, Is.EqualTo(field));
            Assert.That(problem.FoundValue, Is.EqualTo(found));
        }

        [TestCase("1e999")]
        [TestCase("-1e999")]
        public void Parse_NumberBeyondDouble_IsRefused(string number) =>
            Refused("{\"version\": 1, \"space\": \"LPS\", \"spheres\": [{\"centerMm\": [1, 2, " + number + "], \"radiusMm\": 1, \"clipped\": []}]}");

        [TestCase("2")]
        [TestCase("0")]
        [TestCase("99999999999999999999")]
        public void Parse_UnknownVersion_IsRefusedWithASentence(string version)
        {
            CarvingFileException problem = Refused("{\"version\": " + version + ", \"space\": \"LPS\", \"spheres\": []}");
            Assert.That(problem.Message, Is.EqualTo(
                "test.json: version is " + version + "; expected 1, the only version that this package reads; the file may come from a newer one."));
        }

        [Test]
        public void Bind_LabelTheVolumeLacks_WarnsOnceAndSavingKeepsIt()
        {
            SegmentTable segments = Phantoms.Segments(4);
            string liver = "{\"label\": 5, \"name\": \"liver\"}";
            string sphere = "{\"centerMm\": [1, 2, 3], \"radiusMm\": 4, \"clipped\": [" + liver + ", {\"label\": 6, \"name\": \"segment 2\"}]}";
            CarvingDocument document = CarvingFile.Parse("{\"version\": 1, \"space\": \"LPS\", \"spheres\": [" + sphere + ", " + sphere + "]}");

            CarvingBinding binding = CarvingBinding.Bind(document, segments);
            var stack = new CarvingStack(4);
            stack.Replace(binding.Fixed, binding.Active);
            stack.SetSegment(0, 1, true);
            CarvingDocument saved = CarvingBinding.Document(stack.State, segments, document);

            Assert.That(binding.Warnings.Single(), Is.EqualTo("The carving clips label 5 \"liver\", which this volume does not have."));
            Assert.That(binding.Fixed[0].Mask.ClippedSegments(), Is.EqualTo(new[] { 2 }));
            Assert.That(saved.Fixed[0].Clipped.Select(segment => segment.Label), Is.EqualTo(new long?[] { 3, 6, 5 }));
            Assert.That(saved.Fixed[1].Clipped.Last(), Is.EqualTo(new SegmentReference(5, "liver")));
        }

        [Test]
        public void Bind_NameDiffers_TheLabelCountsAndItWarns()
        {
            CarvingBinding binding = Bound("{\"label\": 3, \"name\": \"spleen\"}");
            Assert.That(binding.Fixed[0].Mask.ClippedSegments(), Is.EqualTo(new[] { 1 }));
            Assert.That(binding.Warnings.Single(), Does.Contain("\"spleen\"").And.Contain("\"segment 1\""));
        }

        [Test]
        public void Bind_NameOnly_IsFoundWhateverTheCase()
        {
            CarvingBinding binding = Bound("{\"name\": \"SEGMENT 3\"}");
            Assert.That(binding.Fixed[0].Mask.ClippedSegments(), Is.EqualTo(new[] { 3 }));
            Assert.That(binding.Warnings, Is.Empty);
            Assert.That(Bound("{\"name\": \"kidney\"}").Warnings, Has.Count.EqualTo(1));
        }

        [Test]
        public void Write_OverAnExistingFile_ReplacesItAndLeavesNothingElse()
        {
            string path = Path.Combine(folder, "my carving.json");
            File.WriteAllText(path, "old");

            CarvingFile.Write(new CarvingDocument(Enumerable.Empty<CarvingDocumentSphere>()), path);

            Assert.That(CarvingFile.Read(path).Fixed, Is.Empty);
            Assert.That(Directory.GetFiles(folder), Has.Length.EqualTo(1));
            Assert.That(File.ReadAllBytes(path)[0], Is.EqualTo((byte)'{'), "no byte order mark");
        }

        [Test]
        public void Write_NoSuchFolder_IsRefusedByName()
        {
            string path = Path.Combine(folder, "none", "carving.json");
            Assert.That(
                () => CarvingFile.Write(new CarvingDocument(Enumerable.Empty<CarvingDocumentSphere>()), path),
                Throws.InstanceOf<CarvingFileException>().With.Message.Contains(path));
        }

        [Test]
        public void Read_NoSuchFile_IsRefusedByName()
        {
            string path = Path.Combine(folder, "none.json");
            Assert.That(() => CarvingFile.Read(path), Throws.InstanceOf<CarvingFileException>().With.Message.Contains(path));
        }

        [Test]
        public void Read_NotUtf8_IsRefused()
        {
            string path = Path.Combine(folder, "bytes.json");
            File.WriteAllBytes(path, new byte[] { 0x7B, 0x22, 0xC3, 0x28, 0x22 });
            Assert.That(() => CarvingFile.Read(path), Throws.InstanceOf<CarvingFileException>());
        }

        static CarvingBinding Bound(string reference) => CarvingBinding.Bind(
            CarvingFile.Parse("{\"version\": 1, \"space\": \"LPS\", \"spheres\": [{\"centerMm\": [1, 2, 3], \"radiusMm\": 4, \"clipped\": [" + reference + "]}]}"),
            Phantoms.Segments(4));

        static CarvingFileException Refused(string json) => Assert.Throws<CarvingFileException>(() => CarvingFile.Parse(json, "test.json"));
    }
}
