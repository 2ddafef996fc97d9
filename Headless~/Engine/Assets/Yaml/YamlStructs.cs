using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>How Unity writes its own value types and packed lists of integers.</summary>
    static class YamlStructs
    {
        /// <param name="node">The components by name.</param>
        /// <param name="type">A value type of the engine's.</param>
        /// <param name="current">Gives the components that the node lacks, as in overrides of a prefab instance.</param>
        /// <exception cref="FormatException">A component is unknown or no number.</exception>
        internal static object Read(YamlMappingNode node, Type type, object current)
        {
            current ??= Activator.CreateInstance(type);
            switch (current)
            {
                case Vector2 v:
                    Allow(node, "x", "y");
                    return new Vector2(Float(node, "x", v.x), Float(node, "y", v.y));
                case Vector3 v:
                    Allow(node, "x", "y", "z");
                    return new Vector3(Float(node, "x", v.x), Float(node, "y", v.y), Float(node, "z", v.z));
                case Vector4 v:
                    Allow(node, "x", "y", "z", "w");
                    return new Vector4(Float(node, "x", v.x), Float(node, "y", v.y), Float(node, "z", v.z), Float(node, "w", v.w));
                case Quaternion q:
                    Allow(node, "x", "y", "z", "w");
                    return new Quaternion(Float(node, "x", q.x), Float(node, "y", q.y), Float(node, "z", q.z), Float(node, "w", q.w));
                case Vector2Int v:
                    Allow(node, "x", "y");
                    return new Vector2Int(Int(node, "x", v.x), Int(node, "y", v.y));
                case Vector3Int v:
                    Allow(node, "x", "y", "z");
                    return new Vector3Int(Int(node, "x", v.x), Int(node, "y", v.y), Int(node, "z", v.z));
                case Color c:
                    Allow(node, "r", "g", "b", "a");
                    return new Color(Float(node, "r", c.r), Float(node, "g", c.g), Float(node, "b", c.b), Float(node, "a", c.a));
                case Rect r:
                    Allow(node, "x", "y", "width", "height");
                    return new Rect(Float(node, "x", r.x), Float(node, "y", r.y), Float(node, "width", r.width), Float(node, "height", r.height));
                case Matrix4x4 m:
                    return ReadMatrix(node, m);
                default:
                    return ReadOther(node, type, current);
            }
        }

        static object ReadOther(YamlMappingNode node, Type type, object current)
        {
            switch (current)
            {
                case Color32:
                    Allow(node, "rgba");
                    var rgba = uint.Parse(Text(node, "rgba") ?? throw new FormatException("'rgba' is missing"), CultureInfo.InvariantCulture);
                    return new Color32((byte)rgba, (byte)(rgba >> 8), (byte)(rgba >> 16), (byte)(rgba >> 24));
                case LayerMask mask:
                    Allow(node, "m_Bits");
                    return Text(node, "m_Bits") is { } bits ? (LayerMask)(int)uint.Parse(bits, CultureInfo.InvariantCulture) : mask;
                case Bounds bounds:
                    Allow(node, "m_Center", "m_Extent");
                    return new Bounds(Vector(node, "m_Center", bounds.center), Vector(node, "m_Extent", bounds.extents) * 2f);
                default:
                    throw new FormatException($"{type.Name} is not supported in files");
            }
        }

        /// <summary>Lists of integers and bools come as one word: little-endian hexadecimal digits.</summary>
        internal static List<object> PackedIntegers(string hex, Type element)
        {
            var size = Size(element);
            if (hex.Length % (size * 2) != 0)
                throw new FormatException($"'{hex}' is no list of {element.Name} in hexadecimal digits");
            var items = new List<object>();
            for (var i = 0; i < hex.Length; i += size * 2)
            {
                ulong bits = 0;
                for (var b = 0; b < size; b++)
                    bits |= (ulong)byte.Parse(hex.Substring(i + b * 2, 2), NumberStyles.HexNumber, CultureInfo.InvariantCulture) << (8 * b);
                items.Add(FromBits(bits, element));
            }

            return items;
        }

        static object FromBits(ulong bits, Type type)
        {
            if (type.IsEnum)
                return Enum.ToObject(type, unchecked((int)bits));
            unchecked
            {
                return Type.GetTypeCode(type) switch
                {
                    TypeCode.Boolean => bits != 0,
                    TypeCode.SByte => (sbyte)bits,
                    TypeCode.Byte => (byte)bits,
                    TypeCode.Int16 => (short)bits,
                    TypeCode.UInt16 => (ushort)bits,
                    TypeCode.Char => (char)bits,
                    TypeCode.Int32 => (int)bits,
                    TypeCode.UInt32 => (uint)bits,
                    TypeCode.Int64 => (long)bits,
                    _ => (object)bits,
                };
            }
        }

        static int Size(Type type) => type.IsEnum ? 4 : Type.GetTypeCode(type) switch
        {
            TypeCode.Boolean or TypeCode.SByte or TypeCode.Byte => 1,
            TypeCode.Int16 or TypeCode.UInt16 or TypeCode.Char => 2,
            TypeCode.Int32 or TypeCode.UInt32 => 4,
            TypeCode.Int64 or TypeCode.UInt64 => 8,
            _ => throw new FormatException($"a list of {type.Name} is never packed"),
        };

        static Matrix4x4 ReadMatrix(YamlMappingNode node, Matrix4x4 current)
        {
            var m = current;
            foreach (var key in node.Children.Select(YamlNodes.Key))
            {
                if (key.Length != 3 || key[0] != 'e' || key[1] is < '0' or > '3' || key[2] is < '0' or > '3')
                    throw new FormatException($"there is no component '{key}'");
                m[key[1] - '0', key[2] - '0'] = Float(node, key, 0f);
            }

            return m;
        }

        static void Allow(YamlMappingNode node, params string[] keys)
        {
            foreach (var key in node.Children.Select(YamlNodes.Key))
                if (Array.IndexOf(keys, key) < 0 && key != "serializedVersion")
                    throw new FormatException($"there is no component '{key}'");
        }

        static float Float(YamlMappingNode node, string key, float current) =>
            Text(node, key) is { } text ? float.Parse(text, NumberStyles.Float, CultureInfo.InvariantCulture) : current;

        static int Int(YamlMappingNode node, string key, int current) =>
            Text(node, key) is { } text ? int.Parse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture) : current;

        static Vector3 Vector(YamlMappingNode node, string key, Vector3 current) => YamlNodes.Child(node, key) switch
        {
            null => current,
            YamlMappingNode inner => (Vector3)Read(inner, typeof(Vector3), current),
            _ => throw new FormatException($"'{key}' is no vector"),
        };

        /// <summary>Null if the component is missing.</summary>
        static string Text(YamlMappingNode node, string key) => YamlNodes.Child(node, key) switch
        {
            null => null,
            YamlScalarNode scalar => scalar.Value ?? "",
            _ => throw new FormatException($"'{key}' is no single value"),
        };
    }
}
