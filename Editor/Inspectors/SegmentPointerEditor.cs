using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The Inspector of a pointer: its fields, and in Play what it points at.</summary>
    [CustomEditor(typeof(SegmentPointer))]
    [CanEditMultipleObjects]
    sealed class SegmentPointerEditor : UnityEditor.Editor
    {
        SerializedProperty volume, autoPoint, maxDistance;

        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            EditorGUILayout.PropertyField(volume);
            EditorGUILayout.PropertyField(autoPoint);
            EditorGUILayout.PropertyField(maxDistance);
            serializedObject.ApplyModifiedProperties();
            if (serializedObject.isEditingMultipleObjects)
                return;
            var pointer = (SegmentPointer)target;
            if (pointer.Target == null)
                EditorGUILayout.HelpBox("There is no Carved Volume Renderer on this GameObject or its parents: set the one to point at.", MessageType.Warning);
            else if (!Application.isPlaying)
                EditorGUILayout.HelpBox("It points in Play.", MessageType.None);
            else
                DrawHit(pointer);
        }

        public override bool RequiresConstantRepaint() => Application.isPlaying;

        void OnEnable()
        {
            volume = serializedObject.FindProperty("target");
            autoPoint = serializedObject.FindProperty("autoPoint");
            maxDistance = serializedObject.FindProperty("maxDistance");
        }

        static void DrawHit(SegmentPointer pointer)
        {
            Segment segment = pointer.CurrentSegment;
            EditorGUILayout.LabelField("Points at", segment == null ? "nothing" : segment.ToString());
            if (segment == null)
                return;
            EditorGUILayout.LabelField("The active sphere", pointer.WillBeClipped ? "clips it (red)" : "leaves it (green)");
            EditorGUILayout.LabelField("Where, LPS", pointer.Current.PositionLps.ToString());
        }
    }
}
