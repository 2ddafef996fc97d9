using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>How Unity writes its own value types and packed lists of integers.</summary>
    static class YamlStructs
    {
        /// <exception cref="FormatException">A component is missing or no number.</exception>
        internal static object Read(YamlMappingNode node, Type type)
        {
            float F(string key) => float.Parse(Text(node, key), CultureInfo.InvariantCulture);
            int I(string key) => int.Parse(Text(node, key), CultureInfo.InvariantCulture);
            Vector3 V(string key) => (Vector3)Read((YamlMappingNode)YamlAsset.Child(node, key), typeof(Vector3));
            if (type == typeof(Vector2))
                return new Vector2(F("x"), F("y"));
            if (type == typeof(Vector3))
                return new Vector3(F("x"), F("y"), F("z"));
            if (type == typeof(Vector4))
                return new Vector4(F("x"), F("y"), F("z"), F("w"));
            if (type == typeof(Vector2Int))
                return new Vector2Int(I("x"), I("y"));
            if (type == typeof(Vector3Int))
                return new Vector3Int(I("x"), I("y"), I("z"));
            if (type == typeof(Quaternion))
                return new Quaternion(F("x"), F("y"), F("z"), F("w"));
            if (type == typeof(Color))
                return new Color(F("r"), F("g"), F("b"), F("a"));
            if (type == typeof(Color32))
            {
                var rgba = uint.Parse(Text(node, "rgba"), CultureInfo.InvariantCulture);
                return new Color32((byte)rgba, (byte)(rgba >> 8), (byte)(rgba >> 16), (byte)(rgba >> 24));
            }

            if (type == typeof(Rect))
                return new Rect(F("x"), F("y"), F("width"), F("height"));
            if (type == typeof(Bounds))
                return new Bounds(V("m_Center"), V("m_Extent") * 2f);
            if (type == typeof(LayerMask))
                return (LayerMask)(int)uint.Parse(Text(node, "m_Bits"), CultureInfo.InvariantCulture);
            if (type == typeof(Matrix4x4))
                return ReadMatrix(F);
            throw new FormatException($"{type.Name} is not supported in files");
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

        static Matrix4x4 ReadMatrix(Func<string, float> component)
        {
            var m = default(Matrix4x4);
            for (var row = 0; row < 4; row++)
                for (var column = 0; column < 4; column++)
                    m[row, column] = component($"e{row}{column}");
            return m;
        }

        static string Text(YamlMappingNode node, string key) =>
            (YamlAsset.Child(node, key) as YamlScalarNode)?.Value ?? throw new FormatException($"'{key}' is missing");
    }
}
