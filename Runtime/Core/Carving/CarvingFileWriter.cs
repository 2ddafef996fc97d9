using System.Globalization;
using System.IO;
using AnatomyCarve.Volumes;
using Newtonsoft.Json;

namespace AnatomyCarve.Carving
{
    /// <summary>Writes the JSON of a carving file.</summary>
    static class CarvingFileWriter
    {
        public static void Write(CarvingDocument document, TextWriter text)
        {
            using var json = new JsonTextWriter(text) { Formatting = Formatting.Indented, Culture = CultureInfo.InvariantCulture, CloseOutput = false };
            json.WriteStartObject();
            json.WritePropertyName("version");
            json.WriteValue(CarvingFile.Version);
            json.WritePropertyName("space");
            json.WriteValue("LPS");
            json.WritePropertyName("spheres");
            json.WriteStartArray();
            foreach (CarvingDocumentSphere sphere in document.Fixed)
                WriteSphere(json, sphere, false);
            if (document.Active is object)
                WriteSphere(json, document.Active, true);
            json.WriteEndArray();
            json.WriteEndObject();
            json.Flush();
            text.WriteLine();
        }

        static void WriteSphere(JsonTextWriter json, CarvingDocumentSphere sphere, bool isActive)
        {
            PointMm center = sphere.CentreLps;
            json.WriteStartObject();
            json.WritePropertyName("centerMm");
            json.WriteRawValue("[" + Number(center.X) + ", " + Number(center.Y) + ", " + Number(center.Z) + "]");
            json.WritePropertyName("radiusMm");
            json.WriteRawValue(Number(sphere.RadiusMm));
            json.WritePropertyName("clipped");
            json.WriteStartArray();
            foreach (SegmentReference reference in sphere.Clipped)
                WriteReference(json, reference);
            json.WriteEndArray();
            if (isActive)
            {
                json.WritePropertyName("active");
                json.WriteValue(true);
            }
            json.WriteEndObject();
        }

        static void WriteReference(JsonTextWriter json, SegmentReference reference)
        {
            json.WriteStartObject();
            if (reference.Label is long label)
            {
                json.WritePropertyName("label");
                json.WriteValue(label);
            }
            if (reference.Name != null)
            {
                json.WritePropertyName("name");
                json.WriteValue(reference.Name);
            }
            json.WriteEndObject();
        }

        /// <summary>
        /// The shortest text that reads back as the same number. "R" alone does not on every runtime that Unity has used. Zero has no sign: Newtonsoft.Json
        /// 13.0.2, Unity's, loses it on reading.
        /// </summary>
        static string Number(double value)
        {
            string text = value.ToString("R", CultureInfo.InvariantCulture);
            if (double.Parse(text, NumberStyles.Float, CultureInfo.InvariantCulture) != value)
                text = value.ToString("G17", CultureInfo.InvariantCulture);
            return text == "-0" ? "0" : text;
        }
    }
}
