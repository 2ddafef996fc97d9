using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The Inspector of a carving, and its spheres in the Scene view.</summary>
    [CustomEditor(typeof(ClipSphereStack))]
    [CanEditMultipleObjects]
    sealed class ClipSphereStackEditor : UnityEditor.Editor
    {
        static readonly GUIContent Forget = new GUIContent("Forget edits", "Volumes start with the start file again, or with nothing");

        readonly SphereList spheres = new SphereList();
        readonly ClipSphereHandles handles = new ClipSphereHandles();
        SerializedProperty loader, startFile, startCarving, activeRadiusFactor, historyLimit;

        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            EditorGUILayout.PropertyField(loader);
            EditorGUILayout.PropertyField(startFile);
            EditorGUILayout.PropertyField(activeRadiusFactor);
            EditorGUILayout.PropertyField(historyLimit);
            DrawEdited();
            if (serializedObject.ApplyModifiedProperties())
                EditorViews.Refresh();
            EditorGUILayout.Space();
            if (serializedObject.isEditingMultipleObjects)
                EditorGUILayout.HelpBox("Select one carving to see its spheres.", MessageType.None);
            else
                DrawCarving((ClipSphereStack)target);
        }

        public override bool RequiresConstantRepaint() => Application.isPlaying && !serializedObject.isEditingMultipleObjects;

        void OnEnable()
        {
            loader = serializedObject.FindProperty("loader");
            startFile = serializedObject.FindProperty("startFile");
            startCarving = serializedObject.FindProperty("startCarving");
            activeRadiusFactor = serializedObject.FindProperty("activeRadiusFactor");
            historyLimit = serializedObject.FindProperty("historyLimit");
        }

        void OnDisable() => handles.EndDrag();

        void OnSceneGUI() => handles.Draw((ClipSphereStack)target);

        /// <summary>Says that what was edited comes before the start file, with the way back.</summary>
        void DrawEdited()
        {
            if (!startCarving.hasMultipleDifferentValues && startCarving.stringValue.Length == 0)
                return;
            using (new EditorGUILayout.HorizontalScope())
            {
                EditorGUILayout.HelpBox("Volumes start with the carving as it was edited here; it comes before the start file.", MessageType.None);
                if (!Application.isPlaying && GUILayout.Button(Forget, GUILayout.ExpandWidth(false)))
                    startCarving.stringValue = "";
            }
        }

        void DrawCarving(ClipSphereStack stack)
        {
            if (!CarvingEdits.IsPossible(stack))
            {
                EditorGUILayout.HelpBox("The carving can be edited while a volume is loaded.", MessageType.Info);
                return;
            }
            spheres.Draw(stack.Carving.State);
            ActiveSphereFields.Draw(stack);
            CarvingButtons.Draw(stack);
        }
    }
}
