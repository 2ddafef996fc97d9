using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Tests.TestSupport
{
    /// <summary>Writes an NRRD file in memory: header lines as given, and the voxels in any encoding.</summary>
    public sealed class NrrdFile
    {
        static readonly string[] TypeNames = { "int8", "uint8", "short", "ushort", "int", "uint", "longlong", "ulonglong", "float", "double" };

        readonly List<string> order = new List<string>();
        readonly Dictionary<string, string> fields = new Dictionary<string, string>();

        /// <summary>Makes a file of the axes' sizes (fastest first) and the voxels' array, raw, little-endian, 1 mm, LPS.</summary>
        public NrrdFile(Array voxels, params int[] sizes)
        {
            Voxels = voxels;
            this["type"] = TypeNames[(int)VoxelTypes.Of(voxels)];
            this["dimension"] = sizes.Length.ToString(CultureInfo.InvariantCulture);
            this["sizes"] = string.Join(" ", sizes.Select(size => size.ToString(CultureInfo.InvariantCulture)));
            this["encoding"] = "raw";
            this["endian"] = "little";
            if (sizes.Length == 3)
            {
                this["space"] = "left-posterior-superior";
                Place(Affine.Identity);
            }
        }

        /// <summary>The voxels.</summary>
        public Array Voxels { get; set; }

        /// <summary>The end of a line.</summary>
        public string LineEnd { get; set; } = "\n";

        /// <summary>Lines behind the fields: key/value pairs, comments.</summary>
        public List<string> FurtherLines { get; } = new List<string>();

        /// <summary>A field's text; null takes it out.</summary>
        public string this[string field]
        {
            get => fields.TryGetValue(field, out string value) ? value : null;
            set
            {
                if (!order.Contains(field))
                    order.Add(field);
                fields[field] = value;
            }
        }

        /// <summary>Writes space directions and space origin.</summary>
        public void Place(Affine ijkToSpace)
        {
            string Vector(PointMm p) => string.Format(CultureInfo.InvariantCulture, "({0:R},{1:R},{2:R})", p.X, p.Y, p.Z);
            var zero = new PointMm(0, 0, 0);
            this["space directions"] = string.Join(" ", Enumerable.Range(0, 3).Select(col => Vector(zero + ijkToSpace.Column(col))));
            this["space origin"] = Vector(ijkToSpace.Origin);
        }

        /// <summary>The file's bytes, its voxels in the encoding that the field names (raw for one that is unknown).</summary>
        public byte[] ToBytes() => VoxelBytes.Join(HeaderBytes(), DataBytes());

        /// <summary>The header up to and with its empty line.</summary>
        public byte[] HeaderBytes()
        {
            var text = new StringBuilder("NRRD0005").Append(LineEnd);
            foreach (string field in order.Where(field => fields[field] != null))
                text.Append(field).Append(": ").Append(fields[field]).Append(LineEnd);
            foreach (string line in FurtherLines)
                text.Append(line).Append(LineEnd);
            return Encoding.UTF8.GetBytes(text.Append(LineEnd).ToString());
        }

        /// <summary>The voxels as the file holds them.</summary>
        public byte[] DataBytes()
        {
            byte[] bytes = VoxelBytes.Of(Voxels, this["endian"] == "big");
            switch (this["encoding"])
            {
                case "gzip":
                case "gz":
                    return VoxelBytes.Gzip(bytes);
                case "hex":
                    return Encoding.ASCII.GetBytes(string.Join("\n", bytes.Select(value => value.ToString("x2", CultureInfo.InvariantCulture))));
                case "ascii":
                case "text":
                case "txt":
                    return Encoding.ASCII.GetBytes(string.Join(" ", Voxels.Cast<IFormattable>().Select(value => value.ToString(null, CultureInfo.InvariantCulture))));
                default:
                    return bytes;
            }
        }
    }
}
