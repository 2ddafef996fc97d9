using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace AnatomyCarve.Headless.Cli.Bench.Measures
{
    /// <summary>A quantity and what was found, as files hold it.</summary>
    sealed record Figure(Quantity Quantity, Outcome Outcome)
    {
        /// <summary>Null = it was not measured.</summary>
        public bool? Holds => Outcome.Values == null ? null : Quantity.Holds(Outcome.Values);

        public JsonObject ToJson()
        {
            var json = new JsonObject
            {
                ["what"] = Quantity.What,
                ["value"] = Outcome.Values == null ? null : Numbers(Outcome.Values.Select(Rounded).ToArray()),
                ["goal"] = Numbers(Quantity.Goals),
                ["atLeast"] = Quantity.AtLeastEach is { } each ? new JsonArray(each.Select(one => (JsonNode)one).ToArray()) : Quantity.AtLeast,
                ["unit"] = Quantity.Unit,
                ["holds"] = Holds,
                ["scene"] = Outcome.Scene,
                ["settings"] = Outcome.Settings?.DeepClone() ?? new JsonObject(),
            };
            if (Outcome.Reason != null) json["reason"] = Outcome.Reason;
            return json;
        }

        /// <exception cref="FormatException">It is no figure.</exception>
        public static Figure FromJson(string id, JsonNode json)
        {
            try
            {
                var quantity = new Quantity(id, (string)json["what"], (string)json["unit"], List(json["goal"]), json["atLeast"] is JsonValue one && (bool)one)
                {
                    AtLeastEach = (json["atLeast"] as JsonArray)?.Select(each => (bool)each).ToArray(),
                };
                var values = json["value"] == null ? null : List(json["value"]);
                if (values != null && values.Length != quantity.Goals.Length) throw new FormatException($"{id} has {values.Length} values for {quantity.Goals.Length} goals");
                return new Figure(quantity, new Outcome(values, (string)json["scene"], json["settings"]?.DeepClone() as JsonObject, (string)json["reason"]));
            }
            catch (Exception exception) when (exception is InvalidOperationException or NullReferenceException or ArgumentException)
            {
                throw new FormatException($"{id} is no figure", exception);
            }
        }

        static double[] List(JsonNode node) => node is JsonArray array ? array.Select(Number).ToArray() : [Number(node)];

        // JSON has no infinities; the writer put null.
        static double Number(JsonNode node) => node == null ? double.NaN : (double)node;

        static JsonNode Numbers(double[] values) => values.Length == 1 ? Json.Number(values[0]) : new JsonArray(values.Select(Json.Number).ToArray());

        static double Rounded(double value) =>
            double.IsFinite(value) ? double.Parse(value.ToString("G6", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture) : value;
    }

    /// <summary>The figures of a run as files.</summary>
    static class FigureFile
    {
        /// <summary>An object keyed by the ids.</summary>
        public static JsonObject ToJson(IEnumerable<Figure> figures) =>
            new(figures.Select(figure => KeyValuePair.Create(figure.Quantity.Id, (JsonNode)figure.ToJson())));

        /// <summary>One line per value.</summary>
        public static string ToCsv(IEnumerable<Figure> figures)
        {
            var lines = new List<string> { "id,number,value,goal,at least,unit,holds,scene,what,reason" };
            foreach (var (quantity, outcome) in figures)
            {
                for (var n = 0; n < quantity.Goals.Length; n++)
                {
                    lines.Add(string.Join(',', quantity.Id, Text(n + 1), outcome.Values == null ? "" : Text(outcome.Values[n]), Text(quantity.Goals[n]),
                        quantity.IsAtLeast(n) ? "yes" : "no", Quoted(quantity.Unit), outcome.Values == null ? "" : quantity.Holds(outcome.Values) ? "yes" : "no",
                        Quoted(outcome.Scene), Quoted(quantity.What), Quoted(outcome.Reason)));
                }
            }

            return string.Join('\n', lines) + "\n";
        }

        /// <exception cref="CommandException">The file holds no figures.</exception>
        public static IReadOnlyList<Figure> Read(string path)
        {
            try
            {
                return JsonNode.Parse(File.ReadAllText(path)) is JsonObject json
                    ? json.Select(pair => Figure.FromJson(pair.Key, pair.Value)).ToArray()
                    : throw new FormatException("it is no object");
            }
            catch (Exception exception) when (exception is JsonException or FormatException)
            {
                throw new CommandException($"{path}: not a file of figures: {exception.Message}.");
            }
        }

        static string Text(double value) => value.ToString("G6", CultureInfo.InvariantCulture);

        static string Quoted(string text) => text == null ? "" : text.AsSpan().IndexOfAny(",\"\n") >= 0 ? $"\"{text.Replace("\"", "\"\"")}\"" : text;
    }
}
