using System;
using System.Collections.Generic;
using System.Reflection;
using UnityEngine.Events;

namespace UnityEngine
{
    /// <summary>Which fields Unity serialises, and what their types are to it.</summary>
    static class SerializedFields
    {
        static readonly Dictionary<Type, FieldInfo[]> s_Known = new();

        /// <summary>The serialised fields of a class or struct, those of base classes first.</summary>
        internal static FieldInfo[] Of(Type type)
        {
            lock (s_Known)
            {
                if (!s_Known.TryGetValue(type, out var fields))
                    s_Known.Add(type, fields = Collect(type));
                return fields;
            }
        }

        /// <summary>The element type of an array or List, the only containers that Unity serialises; null for others.</summary>
        internal static Type ElementOf(Type type)
        {
            if (type.IsArray)
                return type.GetArrayRank() == 1 ? type.GetElementType() : null;
            return type.IsGenericType && type.GetGenericTypeDefinition() == typeof(List<>) ? type.GetGenericArguments()[0] : null;
        }

        /// <summary>True for the engine's own value types, which are copied as a whole.</summary>
        internal static bool IsEngineStruct(Type type) => type.IsValueType && !type.IsPrimitive && !type.IsEnum && type.Assembly == typeof(Object).Assembly;

        /// <summary>True for classes and structs that are written field by field.</summary>
        internal static bool IsPlainData(Type type) =>
            !type.IsPrimitive && !type.IsEnum && type != typeof(string) && !typeof(Object).IsAssignableFrom(type) && ElementOf(type) == null
                && !IsEngineStruct(type);

        internal static bool IsReference(FieldInfo field) => field.IsDefined(typeof(SerializeReference), false);

        /// <summary>Sets a field, or one of a field's value: "quality.step".</summary>
        /// <exception cref="ArgumentException">There is no such serialised field, or the value does not fit.</exception>
        internal static void Set(object target, string path, object value)
        {
            var dot = path.IndexOf('.');
            var name = dot < 0 ? path : path.Substring(0, dot);
            var field = Array.Find(Of(target.GetType()), f => f.Name == name)
                ?? throw new ArgumentException($"{target.GetType().Name} has no serialised field '{name}'", nameof(path));
            if (dot >= 0)
            {
                var inner = field.GetValue(target);
                Set(inner, path.Substring(dot + 1), value);
                value = inner;
            }

            field.SetValue(target, value);
        }

        static FieldInfo[] Collect(Type type)
        {
            var fields = new List<FieldInfo>();
            if (type.BaseType is { } parent && parent != typeof(object) && parent != typeof(ValueType) && !IsEnd(parent))
                fields.AddRange(Of(parent));
            foreach (var field in type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly))
                if (IsSerialized(field))
                    fields.Add(field);
            return fields.ToArray();
        }

        static bool IsEnd(Type type) =>
            type == typeof(MonoBehaviour) || type == typeof(ScriptableObject) || type == typeof(Component) || type == typeof(Object);

        static bool IsSerialized(FieldInfo field)
        {
            if (field.IsStatic || field.IsInitOnly || field.IsLiteral || field.IsNotSerialized)
                return false;
            if (IsReference(field))
                return true;
            if (!field.IsPublic && !field.IsDefined(typeof(SerializeField), false))
                return false;
            var element = ElementOf(field.FieldType);
            return IsSerializable(element ?? field.FieldType);
        }

        static bool IsSerializable(Type type)
        {
            if (type.IsEnum)
                type = Enum.GetUnderlyingType(type);
            if (type == typeof(string))
                return true;
            if (type.IsPrimitive)
                return type != typeof(IntPtr) && type != typeof(UIntPtr);
            if (typeof(Object).IsAssignableFrom(type) || IsEngineStruct(type) || typeof(UnityEventBase).IsAssignableFrom(type))
                return true;
            // Containers do not nest, and what the framework calls serialisable is not so to Unity.
            return !type.IsAbstract && !type.IsInterface && ElementOf(type) == null && !type.IsArray && type.IsSerializable
                && type.Assembly != typeof(object).Assembly &&
                !typeof(Delegate).IsAssignableFrom(type) && !(type.Namespace ?? "").StartsWith("System", StringComparison.Ordinal);
        }
    }
}
