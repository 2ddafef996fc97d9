using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>Quality: a preset that the values below it are, or "Custom", and the values.</summary>
    sealed class QualitySection
    {
        static readonly GUIContent Preset = new GUIContent(
            "Preset", "Fast: long steps, the GPU's filter. Balanced: what a new renderer has. Best: smooth cuts, short steps");

        static readonly GUIContent[] Presets = System.Array.ConvertAll(QualityPresets.Menu, name => new GUIContent(name));

        readonly SerializedProperty step, cutMode, antiAliasing, opaqueAlpha, firstVisibleAlpha, filter;

        /// <param name="quality">The property of type <see cref="RenderQuality"/>.</param>
        public QualitySection(SerializedProperty quality)
        {
            step = quality.FindPropertyRelative("step");
            cutMode = quality.FindPropertyRelative("cutMode");
            antiAliasing = quality.FindPropertyRelative("antiAliasing");
            opaqueAlpha = quality.FindPropertyRelative("opaqueAlpha");
            firstVisibleAlpha = quality.FindPropertyRelative("firstVisibleAlpha");
            filter = quality.FindPropertyRelative("filter");
        }

        /// <param name="targets">The renderers that are edited.</param>
        public void Draw(Object[] targets)
        {
            int index = IndexOf(targets, out bool mixed);
            EditorGUI.BeginChangeCheck();
            EditorGUI.showMixedValue = mixed;
            int chosen = EditorGUILayout.Popup(Preset, index, Presets);
            EditorGUI.showMixedValue = false;
            if (EditorGUI.EndChangeCheck() && chosen != QualityPresets.Custom)
                Set(QualityPresets.At(chosen));
            EditorGUILayout.PropertyField(step);
            EditorGUILayout.PropertyField(cutMode);
            EditorGUILayout.PropertyField(filter);
            EditorGUILayout.PropertyField(antiAliasing);
            EditorGUILayout.PropertyField(opaqueAlpha);
            EditorGUILayout.PropertyField(firstVisibleAlpha);
        }

        static int IndexOf(Object[] targets, out bool mixed)
        {
            int first = QualityPresets.IndexOf(((CarvedVolumeRenderer)targets[0]).Quality);
            mixed = false;
            for (int t = 1; t < targets.Length; t++)
                mixed |= QualityPresets.IndexOf(((CarvedVolumeRenderer)targets[t]).Quality) != first;
            return first;
        }

        void Set(RenderQuality quality)
        {
            step.floatValue = quality.Step;
            cutMode.enumValueIndex = (int)quality.CutMode;
            antiAliasing.floatValue = quality.AntiAliasing;
            opaqueAlpha.floatValue = quality.OpaqueAlpha;
            firstVisibleAlpha.floatValue = quality.FirstVisibleAlpha;
            filter.enumValueIndex = (int)quality.Filter;
        }
    }
}
