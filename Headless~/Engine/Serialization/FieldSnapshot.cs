using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace UnityEngine
{
    /// <summary>An object's serialised fields at one time.</summary>
    sealed class FieldSnapshot : IEquatable<FieldSnapshot>
    {
        readonly List<(FieldInfo Field, object Value)> m_Values;

        FieldSnapshot(List<(FieldInfo, object)> values) => m_Values = values;

        internal static FieldSnapshot Of(Object target)
        {
            (target as ISerializationCallbackReceiver)?.OnBeforeSerialize();
            var copier = new FieldCopier(o => o);
            return new FieldSnapshot(SerializedFields.Of(target.GetType()).Select(f => (f, copier.Value(f, f.GetValue(target)))).ToList());
        }

        internal void RestoreTo(Object target)
        {
            var copier = new FieldCopier(o => o);
            foreach (var (field, value) in m_Values)
                field.SetValue(target, copier.Value(field, value));
            (target as ISerializationCallbackReceiver)?.OnAfterDeserialize();
        }

        public bool Equals(FieldSnapshot other) =>
            other != null && m_Values.Count == other.m_Values.Count && m_Values.Zip(other.m_Values, (a, b) => Same(a.Value, b.Value)).All(s => s);

        public override bool Equals(object obj) => Equals(obj as FieldSnapshot);

        public override int GetHashCode() => m_Values.Count;

        static bool Same(object a, object b)
        {
            if (a == null || b == null || a is Object)
                return ReferenceEquals(a, b);
            if (a.GetType() != b.GetType())
                return false;
            if (a is IList list)
                return list.Count == ((IList)b).Count && list.Cast<object>().Zip(((IList)b).Cast<object>(), Same).All(s => s);
            return SerializedFields.IsPlainData(a.GetType())
                ? SerializedFields.Of(a.GetType()).All(f => Same(f.GetValue(a), f.GetValue(b)))
                : a.Equals(b);
        }
    }
}
