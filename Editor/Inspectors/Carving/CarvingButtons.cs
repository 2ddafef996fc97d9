using System.IO;
using AnatomyCarve.Carving;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The buttons that edit a carving, load it and save it.</summary>
    static class CarvingButtons
    {
        const string Extension = "json";

        static readonly GUIContent Fix = new GUIContent("Fix", "The active sphere stays where it is; a smaller one takes its place");
        static readonly GUIContent RemoveLast = new GUIContent("Remove last", "Removes the sphere that was fixed last");
        static readonly GUIContent RemoveActive = new GUIContent("Remove active", "Takes the active sphere away");
        static readonly GUIContent Clear = new GUIContent("Clear", "Removes all spheres");
        static readonly GUIContent Reset = new GUIContent("Reset mask", "The active sphere clips every segment; none, if it clips all");
        static readonly GUIContent OwnUndo = new GUIContent("Undo", "Takes the last edit of the carving back");
        static readonly GUIContent OwnRedo = new GUIContent("Redo", "Makes it again");
        static readonly GUIContent UnityUndo = new GUIContent("Undo", "Unity's Undo: takes back what was edited last, whatever that is");
        static readonly GUIContent UnityRedo = new GUIContent("Redo", "Unity's Redo");
        static readonly GUIContent LoadFile = new GUIContent("Load carving file...", "Replaces the carving by a saved one");
        static readonly GUIContent SaveFile = new GUIContent("Save carving file...", "Saves the carving as JSON");

        public static void Draw(ClipSphereStack stack)
        {
            CarvingStack carving = stack.Carving;
            using (new EditorGUILayout.HorizontalScope())
            {
                Button(stack, Fix, "Fix Clip Sphere", carving.Active is object, c => c.FixActive());
                Button(stack, RemoveActive, "Remove Active Sphere", carving.Active is object, c => c.RemoveActive());
                Button(stack, RemoveLast, "Remove Last Sphere", carving.Fixed.Count > 0, c => c.RemoveLast());
                Button(stack, Clear, "Clear Carving", carving.Spheres.Count > 0, c => c.Clear());
            }
            using (new EditorGUILayout.HorizontalScope())
            {
                Button(stack, Reset, "Reset Mask", CarvingEdits.IsMaskPossible(stack), c => c.ResetMask());
                DrawHistory(carving);
            }
            using (new EditorGUILayout.HorizontalScope())
            {
                if (GUILayout.Button(LoadFile))
                    Load(stack);
                if (GUILayout.Button(SaveFile))
                    Save(stack);
            }
        }

        static void Button(ClipSphereStack stack, GUIContent title, string name, bool enabled, System.Action<CarvingStack> edit)
        {
            using (new EditorGUI.DisabledScope(!enabled))
                if (GUILayout.Button(title))
                    CarvingEdits.Do(stack, name, edit);
        }

        static void DrawHistory(CarvingStack carving)
        {
            bool playing = Application.isPlaying;
            using (new EditorGUI.DisabledScope(playing && !carving.CanUndo))
                if (GUILayout.Button(playing ? OwnUndo : UnityUndo))
                    TakeBack(carving);
            using (new EditorGUI.DisabledScope(playing && !carving.CanRedo))
                if (GUILayout.Button(playing ? OwnRedo : UnityRedo))
                    MakeAgain(carving);
        }

        static void TakeBack(CarvingStack carving)
        {
            if (Application.isPlaying)
                carving.Undo();
            else
                Undo.PerformUndo();
        }

        static void MakeAgain(CarvingStack carving)
        {
            if (Application.isPlaying)
                carving.Redo();
            else
                Undo.PerformRedo();
        }

        static void Load(ClipSphereStack stack)
        {
            string path = EditorUtility.OpenFilePanel("Load a carving", "", Extension);
            if (!string.IsNullOrEmpty(path))
            {
                try
                {
                    CarvingEdits.Do(stack, "Load Carving", _ => stack.Load(path));
                }
                catch (CarvingFileException problem)
                {
                    EditorUtility.DisplayDialog("The carving could not be loaded", problem.Message, "OK");
                }
            }
            GUIUtility.ExitGUI(); // the window that was shown meanwhile had events of its own
        }

        static void Save(ClipSphereStack stack)
        {
            string path = EditorUtility.SaveFilePanel("Save the carving", "", stack.name + ".carving", Extension);
            if (!string.IsNullOrEmpty(path))
            {
                try
                {
                    stack.Save(path);
                    if (Path.GetFullPath(path).StartsWith(Path.GetFullPath(Application.dataPath), System.StringComparison.OrdinalIgnoreCase))
                        AssetDatabase.Refresh();
                }
                catch (CarvingFileException problem)
                {
                    EditorUtility.DisplayDialog("The carving could not be saved", problem.Message, "OK");
                }
            }
            GUIUtility.ExitGUI();
        }
    }
}
