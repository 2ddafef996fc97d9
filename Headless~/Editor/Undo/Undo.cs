using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    /// <summary>The Editor's undo. What is recorded is compared when the next group begins, or when something is undone.</summary>
    public class Undo
    {
        public static UndoRedoCallback undoRedoPerformed;

        static readonly List<UndoStep> s_Done = new();
        static readonly List<UndoStep> s_Undone = new();

        static int s_Group;
        static string s_GroupName = "";

        public Undo()
        {
        }

        public delegate void UndoRedoCallback();

        public static bool isProcessing { get; private set; }

        public static int GetCurrentGroup() => s_Group;

        public static string GetCurrentGroupName() => s_GroupName;

        public static void SetCurrentGroupName(string name) => s_GroupName = name ?? "";

        /// <summary>What follows is undone apart from what was before.</summary>
        public static void IncrementCurrentGroup()
        {
            FlushUndoRecordObjects();
            s_Group++;
            s_GroupName = "";
        }

        /// <summary>Makes all groups from one on a single one.</summary>
        public static void CollapseUndoOperations(int groupIndex)
        {
            FlushUndoRecordObjects();
            foreach (var step in s_Done.Where(s => s.Group > groupIndex))
                step.Group = groupIndex;
        }

        public static void RecordObject(Object objectToUndo, string name) => RecordObjects(new[] { objectToUndo }, name);

        /// <summary>The objects' serialised fields are about to be changed.</summary>
        public static void RecordObjects(Object[] objectsToUndo, string name)
        {
            MainThread.Check("RecordObjects");
            foreach (var o in objectsToUndo.Where(Object.IsAlive))
                Add(new FieldsStep(s_Group, name, o));
        }

        public static void RegisterCompleteObjectUndo(Object objectToUndo, string name) => RecordObject(objectToUndo, name);

        /// <summary>An object was made; undoing destroys it.</summary>
        public static void RegisterCreatedObjectUndo(Object objectToUndo, string name)
        {
            MainThread.Check("RegisterCreatedObjectUndo");
            Add(new CreationStep(s_Group, name, objectToUndo));
        }

        public static T AddComponent<T>(GameObject gameObject) where T : Component => (T)AddComponent(gameObject, typeof(T));

        public static Component AddComponent(GameObject gameObject, Type type)
        {
            var component = gameObject.AddComponent(type);
            if (component != null)
                RegisterCreatedObjectUndo(component, "Add Component");
            return component;
        }

        /// <summary>Ends the comparison of what was recorded with what became of it.</summary>
        public static void FlushUndoRecordObjects()
        {
            foreach (var step in s_Done.OfType<FieldsStep>())
                step.Close();
            s_Done.RemoveAll(s => s is FieldsStep { IsEmpty: true });
        }

        /// <summary>Undoes the last group.</summary>
        public static void PerformUndo() => Move(s_Done, s_Undone, s => s.Undo());

        /// <summary>Does again what was undone last.</summary>
        public static void PerformRedo() => Move(s_Undone, s_Done, s => s.Redo());

        public static void ClearAll()
        {
            s_Done.Clear();
            s_Undone.Clear();
        }

        public static void ClearUndo(Object identifier)
        {
            s_Done.RemoveAll(s => ReferenceEquals(s.Target, identifier));
            s_Undone.RemoveAll(s => ReferenceEquals(s.Target, identifier));
        }

        internal static void Forget()
        {
            ClearAll();
            undoRedoPerformed = null;
            s_Group = 0;
            s_GroupName = "";
        }

        static void Add(UndoStep step)
        {
            s_Undone.Clear();
            s_Done.Add(step);
            if (s_GroupName.Length == 0)
                s_GroupName = step.Name ?? "";
        }

        static void Move(List<UndoStep> from, List<UndoStep> to, Action<UndoStep> act)
        {
            MainThread.Check("PerformUndo");
            FlushUndoRecordObjects();
            if (from.Count == 0)
                return;
            isProcessing = true;
            for (var group = from[^1].Group; from.Count > 0 && from[^1].Group == group;)
            {
                var step = from[^1];
                from.RemoveAt(from.Count - 1);
                to.Add(step);
                if (Object.IsAlive(step.Target))
                    LogRouter.Guard(() => act(step));
            }

            isProcessing = false;
            s_Group++;
            LogRouter.Guard(() => undoRedoPerformed?.Invoke());
        }
    }
}
