using System;
using System.Collections;
using System.Collections.Generic;
using System.Reflection;
using UnityEngine.Events;

namespace UnityEngine
{
    /// <summary>Copies serialised fields as a trip through Unity's serialiser would: deep, by value, without nulls but for Object references.</summary>
    sealed class FieldCopier
    {
        const int DepthLimit = 10;

        readonly Func<Object, Object> m_Remap;
        readonly Dictionary<object, object> m_References = new(ReferenceEquality.Instance);

        internal FieldCopier(Func<Object, Object> remap) => m_Remap = remap;

        internal void Copy(object from, object to)
        {
            (from as ISerializationCallbackReceiver)?.OnBeforeSerialize();
            CopyFields(from, to, 0);
            (to as ISerializationCallbackReceiver)?.OnAfterDeserialize();
        }

        void CopyFields(object from, object to, int depth)
        {
            foreach (var field in SerializedFields.Of(from.GetType()))
                field.SetValue(to, Value(field, field.GetValue(from), depth));
        }

        /// <summary>A copy of a field's value.</summary>
        internal object Value(FieldInfo field, object value, int depth = 0) =>
            SerializedFields.IsReference(field) ? CopyReference(value, field.FieldType) : CopyValue(value, field.FieldType, depth);

        object CopyValue(object value, Type type, int depth)
        {
            if (type == typeof(string))
                return value ?? "";
            if (type.IsPrimitive || type.IsEnum || SerializedFields.IsEngineStruct(type))
                return value;
            if (typeof(Object).IsAssignableFrom(type))
                return value is null ? null : m_Remap((Object)value);
            if (SerializedFields.ElementOf(type) is { } element)
                return CopyList((IList)value, type, item => CopyValue(item, element, depth));
            if (typeof(UnityEventBase).IsAssignableFrom(type))
                return CopyEvent((UnityEventBase)value, type);
            if (depth >= DepthLimit)
                return type.IsValueType ? value : null;
            var copy = Activator.CreateInstance(type, true);
            if (value != null)
            {
                (value as ISerializationCallbackReceiver)?.OnBeforeSerialize();
                CopyFields(value, copy, depth + 1);
                (copy as ISerializationCallbackReceiver)?.OnAfterDeserialize();
            }

            return copy;
        }

        /// <summary>[SerializeReference]: nulls, shared instances and the run-time type are kept.</summary>
        object CopyReference(object value, Type type)
        {
            if (value == null)
                return null;
            if (SerializedFields.ElementOf(type) is { } element)
                return CopyList((IList)value, type, item => CopyReference(item, element));
            if (m_References.TryGetValue(value, out var known))
                return known;
            var copy = Activator.CreateInstance(value.GetType(), true);
            m_References.Add(value, copy);
            CopyFields(value, copy, 0);
            return copy;
        }

        /// <summary>What was wired in the Inspector goes along, what was added by code does not.</summary>
        UnityEventBase CopyEvent(UnityEventBase value, Type type)
        {
            var copy = (UnityEventBase)Activator.CreateInstance(type, true);
            if (value != null)
                foreach (var call in value.PersistentCalls)
                    copy.PersistentCalls.Add(call.For(m_Remap));
            return copy;
        }

        static object CopyList(IList source, Type type, Func<object, object> copy)
        {
            var count = source?.Count ?? 0;
            if (type.IsArray)
            {
                var array = Array.CreateInstance(type.GetElementType(), count);
                for (var i = 0; i < count; i++)
                    array.SetValue(copy(source[i]), i);
                return array;
            }

            var list = (IList)Activator.CreateInstance(type);
            for (var i = 0; i < count; i++)
                list.Add(copy(source[i]));
            return list;
        }

        sealed class ReferenceEquality : IEqualityComparer<object>
        {
            internal static readonly ReferenceEquality Instance = new();

            bool IEqualityComparer<object>.Equals(object x, object y) => ReferenceEquals(x, y);

            int IEqualityComparer<object>.GetHashCode(object obj) => System.Runtime.CompilerServices.RuntimeHelpers.GetHashCode(obj);
        }
    }
}
