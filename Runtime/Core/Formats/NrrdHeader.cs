using System;
using System.Collections.Generic;
using System.IO;
using System.Text;

namespace AnatomyCarve.Formats
{
    /// <summary>The text before the voxels of an NRRD file: fields ("type: short") and key/value pairs ("key:=value").</summary>
    sealed class NrrdHeader
    {
        /// <summary>What every NRRD file starts with; one digit, the version, follows.</summary>
        internal const string Magic = "NRRD000";

        /// <summary>Headers that are longer, bytes, are taken for damaged files.</summary>
        const int LargestSize = 16 << 20;

        static readonly HashSet<string> FieldNames = new HashSet<string>(StringComparer.OrdinalIgnoreCase)
        {
            "dimension", "type", "block size", "encoding", "endian", "content", "min", "max", "old min", "old max", "data file", "line skip",
            "byte skip", "number", "sample units", "sizes", "spacings", "thicknesses", "axis mins", "axis maxs", "centers", "centerings",
            "labels", "units", "kinds", "space", "space dimension", "space units", "space origin", "space directions", "measurement frame",
        };

        /// <summary>Names that may be written as one word.</summary>
        static readonly Dictionary<string, string> OtherNames = new Dictionary<string, string>(StringComparer.OrdinalIgnoreCase)
        {
            { "blocksize", "block size" }, { "oldmin", "old min" }, { "oldmax", "old max" }, { "datafile", "data file" },
            { "lineskip", "line skip" }, { "byteskip", "byte skip" }, { "sampleunits", "sample units" }, { "axismins", "axis mins" }, { "axismaxs", "axis maxs" },
        };

        readonly Dictionary<string, string> fields = new Dictionary<string, string>(StringComparer.OrdinalIgnoreCase);
        readonly ReadContext context;

        NrrdHeader(ReadContext context)
        {
            this.context = context;
        }

        /// <summary>Reads the header; the stream then stands behind the empty line that ends it.</summary>
        internal static NrrdHeader Read(Stream stream, ReadContext context)
        {
            var header = new NrrdHeader(context);
            var line = new List<byte>();
            long left = LargestSize;
            if (!ReadLine(stream, line, Magic.Length + 3, out string magic))
                left = 0;
            if (!magic.StartsWith(Magic, StringComparison.Ordinal) || magic.Length != Magic.Length + 1 || magic[Magic.Length] < '1' || magic[Magic.Length] > '5')
                throw context.Refusal("the first line", $"\"{Excerpt(magic)}\"", "NRRD0001 to NRRD0005");
            while (ReadLine(stream, line, left, out string text))
            {
                left -= line.Count + 1;
                if (text.Length == 0)
                {
                    header.RefuseDetached();
                    return header;
                }

                header.Add(text);
            }

            header.RefuseDetached();
            throw context.Refusal("the header", $"without an end", FormattableString.Invariant($"an empty line behind it within {LargestSize} bytes, and the voxels"));
        }

        /// <summary>A field's text, or null when the header doesn't have it.</summary>
        internal string Find(string field) => fields.TryGetValue(field, out string value) ? value : null;

        /// <summary>A field's text; refuses the file when the header doesn't have it.</summary>
        internal string Require(string field) => Find(field) ?? throw context.Refusal(field, $"missing", "a line \"" + field + ": ...\" in the header");

        /// <summary>A text for messages: not longer than a line.</summary>
        internal static string Excerpt(string text)
        {
            var excerpt = new StringBuilder();
            foreach (char letter in text.Length > 60 ? text.Substring(0, 60) + "..." : text)
                excerpt.Append(char.IsControl(letter) ? '?' : letter);
            return excerpt.ToString();
        }

        void RefuseDetached()
        {
            string dataFile = Find("data file");
            if (dataFile != null)
                throw context.Refusal("data file", $"\"{Excerpt(dataFile)}\"", "voxels in the same file: detached headers are not read yet");
        }

        void Add(string line)
        {
            if (line[0] == '#')
                return;
            int pair = line.IndexOf(":=", StringComparison.Ordinal);
            int colon = line.IndexOf(':');
            if (colon >= 0 && colon != pair)
            {
                // A key may hold a colon; a field is one only under a name that the format knows.
                string name = line.Substring(0, colon).Trim();
                name = OtherNames.TryGetValue(name, out string usual) ? usual : name;
                if (FieldNames.Contains(name))
                {
                    fields[name] = line.Substring(colon + 1).Trim();
                    return;
                }
            }

            if (pair > 0)
                context.Description.Metadata[Unescape(line.Substring(0, pair))] = Unescape(line.Substring(pair + 2));
            else
                context.Warn($"The header's line \"{Excerpt(line)}\" is neither a field of NRRD nor key:=value; it is ignored.");
        }

        /// <summary>Resolves \n to a line's end and \\ to one backslash; other backslashes stand for themselves.</summary>
        static string Unescape(string text)
        {
            if (text.IndexOf('\\') < 0)
                return text;
            var result = new StringBuilder(text.Length);
            for (int n = 0; n < text.Length; n++)
            {
                char next = text[n] == '\\' && n + 1 < text.Length ? text[n + 1] : '\0';
                if (next == 'n' || next == '\\')
                {
                    result.Append(next == 'n' ? '\n' : '\\');
                    n++;
                }
                else
                {
                    result.Append(text[n]);
                }
            }

            return result.ToString();
        }

        /// <summary>Reads up to a line's end (LF or CRLF); false when the stream ends, or the line doesn't within a number of bytes.</summary>
        static bool ReadLine(Stream stream, List<byte> line, long largestLength, out string text)
        {
            line.Clear();
            int next = -1;
            while (line.Count < largestLength && (next = stream.ReadByte()) >= 0 && next != '\n')
                line.Add((byte)next);
            int length = line.Count > 0 && line[line.Count - 1] == '\r' ? line.Count - 1 : line.Count;
            text = Encoding.UTF8.GetString(line.ToArray(), 0, length);
            return next == '\n';
        }
    }
}
