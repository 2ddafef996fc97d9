using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace AnatomyCarve.Headless.Cli
{
    /// <summary>JSON as the commands write it: indented, letters as they are, null for numbers that JSON can't hold.</summary>
    static class Json
    {
        static readonly JsonSerializerOptions Options = new() { WriteIndented = true, Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

        public static string Text(JsonNode node) => node.ToJsonString(Options);

        public static JsonNode Number(double value) => double.IsFinite(value) ? JsonValue.Create(value == 0 ? 0 : value) : null;
    }
}
