using System;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine.Benchmark
{
    /// <summary>Figures: whether they hold, how files have them, and what got worse.</summary>
    sealed class FigureTests
    {
        static Figure Make(double[] values, double[] goals, bool atLeast = false, string unit = "bricks", string id = "P4", string reason = null) =>
            new(new Quantity(id, "what, it is", unit, goals, atLeast), new Outcome(values, values == null ? null : "scene", new JsonObject { ["n"] = 1 }, reason));

        [TestCase(1.0, 1.0, false, true)]
        [TestCase(1.1, 1.0, false, false)]
        [TestCase(1.0, 1.0, true, true)]
        [TestCase(0.9, 1.0, true, false)]
        [TestCase(double.NaN, 1.0, false, false)]
        [TestCase(double.NaN, 1.0, true, false)]
        public void Holds_OfAValue_IsWhetherItReachesItsGoal(double value, double goal, bool atLeast, bool holds)
        {
            Assert.That(Make([value], [goal], atLeast).Holds, Is.EqualTo(holds));
        }

        [Test]
        public void Holds_OfAList_AsksAllOfThem()
        {
            Assert.That(Make([1, 3], [1, 2]).Holds, Is.False);
        }

        [Test]
        public void Json_OfFigures_IsKeyedByIdWithAllFields()
        {
            var json = FigureFile.ToJson([Make([2, 3], [2, 2]), Make(null, [1], id: "P24", reason: "not yet")]);

            Assert.That(json["P4"].AsObject().Select(pair => pair.Key), Is.EqualTo(new[] { "what", "value", "goal", "atLeast", "unit", "holds", "scene", "settings" }));
            Assert.That(json["P4"]["value"].AsArray().Select(value => (double)value), Is.EqualTo(new[] { 2.0, 3.0 }));
            Assert.That((bool)json["P4"]["holds"], Is.False);
        }

        [Test]
        public void Json_OfWhatWasNotMeasured_HasNullAndTheReason()
        {
            var json = FigureFile.ToJson([Make(null, [1], id: "P24", reason: "not yet")]);

            Assert.That((json["P24"]["value"], json["P24"]["holds"], (string)json["P24"]["reason"]), Is.EqualTo(((JsonNode)null, (JsonNode)null, "not yet")));
        }

        [Test]
        public void Json_OfOneValue_IsANumber()
        {
            Assert.That((double)FigureFile.ToJson([Make([0.025], [0.025])])["P4"]["value"], Is.EqualTo(0.025));
        }

        [Test]
        public void File_ReadAgain_HasTheSameFigures()
        {
            using var folder = new TestFolder();
            var path = folder.Write("f.json", Json.Text(FigureFile.ToJson([Make([2, 3], [2, 2], atLeast: true), Make(null, [1], id: "P24", reason: "not yet")])));

            var read = FigureFile.Read(path);

            Assert.That(read.Select(figure => (figure.Quantity.Id, figure.Quantity.AtLeast, figure.Holds, figure.Outcome.Reason)),
                Is.EqualTo(new (string, bool, bool?, string)[] { ("P4", true, true, null), ("P24", false, null, "not yet") }));
            Assert.That(read[0].Outcome.Values, Is.EqualTo(new[] { 2.0, 3.0 }));
        }

        [TestCase("[]")]
        [TestCase("{\"P1\": 3}")]
        [TestCase("{\"P1\": {\"value\": [1, 2], \"goal\": 3, \"unit\": \"m\"}}")]
        [TestCase("{")]
        public void File_WithoutFigures_IsRefused(string text)
        {
            using var folder = new TestFolder();
            Assert.That(() => FigureFile.Read(folder.Write("f.json", text)), Throws.InstanceOf<CommandException>().With.Message.Contains("not a file of figures"));
        }

        [Test]
        public void Csv_OfFigures_HasALinePerValueAndQuotesCommas()
        {
            var lines = FigureFile.ToCsv([Make([2, 3], [2, 2])]).Split('\n', StringSplitOptions.RemoveEmptyEntries);

            Assert.That(lines, Is.EqualTo(new[]
            {
                "id,number,value,goal,at least,unit,holds,scene,what,reason",
                "P4,1,2,2,no,bricks,no,scene,\"what, it is\",",
                "P4,2,3,2,no,bricks,no,scene,\"what, it is\",",
            }));
        }

        [TestCase(10, 10, false, "bricks", nameof(FigureTrend.Same))]
        [TestCase(10, 11, false, "bricks", nameof(FigureTrend.Worse))]
        [TestCase(10, 9, false, "bricks", nameof(FigureTrend.Better))]
        [TestCase(80, 79, true, "%", nameof(FigureTrend.Worse))]
        [TestCase(80, 81, true, "%", nameof(FigureTrend.Better))]
        [TestCase(0, 1, false, "bytes", nameof(FigureTrend.Worse))]
        [TestCase(0.1, 0.11, false, "new/old", nameof(FigureTrend.Same))]
        [TestCase(0.1, 0.13, false, "new/old", nameof(FigureTrend.Worse))]
        [TestCase(0.1, 0.07, false, "new/old", nameof(FigureTrend.Better))]
        public void Comparison_OfAFigure_SaysHowItChanged(double old, double now, bool atLeast, string unit, string trend)
        {
            var changes = FigureComparison.Compare([Make([old], [5], atLeast, unit)], [Make([now], [5], atLeast, unit)]);

            Assert.That(changes.Single().Trend.ToString(), Is.EqualTo(trend));
        }

        [Test]
        public void Comparison_OfAFigureThatIsGone_SaysThatItIsLost()
        {
            var changes = FigureComparison.Compare([Make([1], [5])], [Make(null, [5], reason: "no VTK")]);

            Assert.That(FigureComparison.Lines(changes), Is.EqualTo(new[] { "lost   P4  1 -> not measured bricks" }));
        }

        [Test]
        public void Comparison_OfAListWithOneWorse_IsWorse()
        {
            var changes = FigureComparison.Compare([Make([4, 4], [5, 5])], [Make([1, 5], [5, 5])]);

            Assert.That(changes.Single().Trend, Is.EqualTo(FigureTrend.Worse));
        }

        [Test]
        public void Compare_OfFiles_NamesWhatGotWorseAndEndsWithOne()
        {
            using var folder = new TestFolder();
            var old = folder.Write("old.json", Json.Text(FigureFile.ToJson([Make([4], [5]), Make([1], [5], id: "P5")])));
            var now = folder.Write("now.json", Json.Text(FigureFile.ToJson([Make([6], [5]), Make([1], [5], id: "P5")])));

            var result = Carve.InProcess("bench", "compare", now, old);

            Assert.That(result.ExitCode, Is.EqualTo(1), result.Error);
            Assert.That(result.Output.Split('\n')[..2], Is.EqualTo(new[] { "worse  P4  4 -> 6 bricks", $"1 of 2 figures got worse against {old}" }));
        }

        [Test]
        public void Compare_OfEqualFiles_EndsWithZero()
        {
            using var folder = new TestFolder();
            var path = folder.Write("f.json", Json.Text(FigureFile.ToJson([Make([4], [5])])));

            Assert.That(Carve.InProcess("bench", "compare", path, path).ExitCode, Is.Zero);
        }
    }
}
