using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using AnatomyCarve.Volumes;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace AnatomyCarve.Carving
{
    /// <summary>Reads the JSON of a carving file and checks every field. Fields that it does not know are warned about.</summary>
    sealed class CarvingFileReader
    {
        static readonly JsonLoadSettings LoadSettings = new JsonLoadSettings { DuplicatePropertyNameHandling = DuplicatePropertyNameHandling.Error };

        static readonly string Coordinate = FormattableString.Invariant($"a number from {-ClipSphere.LargestMm} to {ClipSphere.LargestMm}");
        static readonly string Radius = FormattableString.Invariant($"a number from 0 to {ClipSphere.LargestMm}");

        readonly string file;
        readonly List<string> warnings = new List<string>();
        bool isRas;

        CarvingFileReader(string file) => this.file = file;

        public static CarvingDocument Read(TextReader text, string file) => new CarvingFileReader(file).Document(Load(text, file));

        static JToken Load(TextReader text, string file)
        {
            try
            {
                using var json = new JsonTextReader(text) { DateParseHandling = DateParseHandling.None, Culture = CultureInfo.InvariantCulture, CloseInput = false };
                JToken root = JToken.ReadFrom(json, LoadSettings);
                while (json.Read())
                {
                    // Only comments get here; the reader refuses anything else after the end.
                }
                return root;
            }
            catch (JsonException problem)
            {
                throw new CarvingFileException(file, "the text", "no JSON (" + problem.Message.TrimEnd('.') + ")", "a carving in JSON", problem);
            }
        }

        CarvingDocument Document(JToken root)
        {
            JObject carving = Object(root, "the whole", "version", "space", "spheres");
            CheckVersion(carving["version"]);
            isRas = IsRas(carving["space"]);
            JArray list = Array(carving["spheres"], "spheres");
            CarvingDocumentSphere[] spheres = list.Select((sphere, index) => Sphere(sphere, Element("spheres", index))).ToArray();
            int active = ActiveIndex(list);
            return new CarvingDocument(active < 0 ? spheres : spheres.Take(active), active < 0 ? null : spheres[active], warnings);
        }

        /// <summary>The active sphere's place in the list, which is the last; -1 = none is active.</summary>
        int ActiveIndex(JArray list)
        {
            for (int index = 0; index < list.Count; index++)
            {
                JToken active = list[index]["active"];
                string field = Element("spheres", index) + ".active";
                if (active != null && active.Type != JTokenType.Boolean)
                    throw Problem(field, active, "true or false");
                if (active == null || !(bool)active)
                    continue;
                return index == list.Count - 1 ? index : throw Problem(field, active, "true for the last sphere only");
            }
            return -1;
        }

        void CheckVersion(JToken version)
        {
            if (version == null || version.Type != JTokenType.Integer)
                throw Problem("version", version, FormattableString.Invariant($"the number {CarvingFile.Version}"));
            if (!JToken.DeepEquals(version, new JValue((long)CarvingFile.Version)))
                throw Problem("version", version, FormattableString.Invariant(
                    $"{CarvingFile.Version}, the only version that this package reads; the file may come from a newer one"));
        }

        bool IsRas(JToken space)
        {
            string name = space != null && space.Type == JTokenType.String ? (string)space : null;
            if (name != "LPS" && name != "RAS")
                throw Problem("space", space, "\"LPS\" or \"RAS\"");
            return name == "RAS";
        }

        CarvingDocumentSphere Sphere(JToken token, string field)
        {
            JObject sphere = Object(token, field, "centerMm", "radiusMm", "clipped", "active");
            PointMm center = Center(sphere["centerMm"], field + ".centerMm");
            double radius = Number(sphere["radiusMm"], field + ".radiusMm", Radius);
            if (radius < 0)
                throw Problem(field + ".radiusMm", sphere["radiusMm"], Radius);
            string clipped = field + ".clipped";
            return new CarvingDocumentSphere(
                center, radius, Array(sphere["clipped"], clipped).Select((segment, index) => Reference(segment, Element(clipped, index))).ToArray());
        }

        PointMm Center(JToken token, string field)
        {
            JArray center = Array(token, field);
            if (center.Count != 3)
                throw Problem(field, token, "three numbers");
            double x = Number(center[0], field + "[0]", Coordinate);
            double y = Number(center[1], field + "[1]", Coordinate);
            double z = Number(center[2], field + "[2]", Coordinate);
            return isRas ? new PointMm(-x, -y, z) : new PointMm(x, y, z);
        }

        SegmentReference Reference(JToken token, string field)
        {
            JObject segment = Object(token, field, "label", "name");
            JToken label = segment["label"];
            JToken name = segment["name"];
            if (label == null && name == null)
                throw Problem(field, token, "a segment's label, its name or both");
            if (label != null && (label.Type != JTokenType.Integer || !(((JValue)label).Value is long)))
                throw Problem(field + ".label", label, "an integer");
            if (name != null && name.Type != JTokenType.String)
                throw Problem(field + ".name", name, "a text");
            return new SegmentReference((long?)label, (string)name);
        }

        double Number(JToken token, string field, string expectation)
        {
            if (token == null || (token.Type != JTokenType.Integer && token.Type != JTokenType.Float))
                throw Problem(field, token, expectation);
            double value = (double)token;
            if (!ClipSphere.IsWithin(value))
                throw Problem(field, token, expectation);
            return value;
        }

        JArray Array(JToken token, string field) => token as JArray ?? throw Problem(field, token, "a list");

        JObject Object(JToken token, string field, params string[] known)
        {
            JObject found = token as JObject ?? throw Problem(field, token, "an object");
            foreach (JProperty property in found.Properties())
            {
                if (System.Array.IndexOf(known, property.Name) < 0)
                    warnings.Add($"{file}: the field \"{property.Name}\" of {field} is not known and was ignored.");
            }
            return found;
        }

        CarvingFileException Problem(string field, JToken found, string expectation) => new CarvingFileException(file, field, Shown(found), expectation);

        static string Shown(JToken token)
        {
            const int Longest = 60;
            if (token == null)
                return "missing";
            string text = token.Type == JTokenType.Float ? ((double)token).ToString("R", CultureInfo.InvariantCulture) : token.ToString(Formatting.None);
            return text.Length <= Longest ? text : text.Substring(0, Longest) + "...";
        }

        static string Element(string list, int index) => FormattableString.Invariant($"{list}[{index}]");
    }
}
