using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>A path as a field with a button beside it that chooses a file.</summary>
    static class PathField
    {
        const float ButtonWidth = 70f, Gap = 4f;

        static readonly GUIContent Choose = new GUIContent("Choose...", "A file below StreamingAssets is saved relative to that folder");
        static readonly string[] Filters = { "Volumes", "nii,gz,nrrd", "All files", "*" };

        public static void Draw(SerializedProperty path, string title)
        {
            Rect row = EditorGUILayout.GetControlRect();
            var button = new Rect(row.xMax - ButtonWidth, row.y, ButtonWidth, row.height);
            row.width -= ButtonWidth + Gap;
            EditorGUI.PropertyField(row, path);
            if (!GUI.Button(button, Choose))
                return;
            string chosen = EditorUtility.OpenFilePanelWithFilters(title, Application.streamingAssetsPath, Filters);
            if (!string.IsNullOrEmpty(chosen))
            {
                path.stringValue = FilePaths.RelativeTo(chosen, Application.streamingAssetsPath);
                path.serializedObject.ApplyModifiedProperties();
                EditorViews.Refresh(); // the Inspector's own end is not reached
            }
            GUIUtility.ExitGUI(); // the window that was shown meanwhile had events of its own
        }
    }
}
