using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    /// <summary>Something that can be undone.</summary>
    abstract class UndoStep
    {
        protected UndoStep(int group, string name, Object target)
        {
            Group = group;
            Name = name;
            Target = target;
        }

        internal int Group { get; set; }

        internal string Name { get; }

        internal Object Target { get; }

        internal abstract void Undo();

        internal abstract void Redo();
    }

    /// <summary>A change of an object's serialised fields.</summary>
    sealed class FieldsStep : UndoStep
    {
        readonly FieldSnapshot m_Before;
        FieldSnapshot m_After;

        internal FieldsStep(int group, string name, Object target) : base(group, name, target) => m_Before = FieldSnapshot.Of(target);

        /// <summary>True if nothing was changed.</summary>
        internal bool IsEmpty => m_After != null && m_After.Equals(m_Before);

        internal void Close() => m_After ??= FieldSnapshot.Of(Target);

        internal override void Undo() => Restore(m_Before);

        internal override void Redo() => Restore(m_After);

        void Restore(FieldSnapshot snapshot)
        {
            snapshot.RestoreTo(Target);
            Validation.Send(Target);
        }
    }

    /// <summary>An object was made.</summary>
    sealed class CreationStep : UndoStep
    {
        internal CreationStep(int group, string name, Object target) : base(group, name, target)
        {
        }

        internal override void Undo() => Object.DestroyImmediate(Target);

        /// <summary>What was destroyed is gone: the host does not keep it aside as the Editor does.</summary>
        internal override void Redo() => throw new NotSupportedException($"Redoing the creation of '{Name}' is not implemented headless");
    }
}
