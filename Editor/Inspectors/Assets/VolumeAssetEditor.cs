using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The Inspector of an imported volume: what it is, its intensities and segments, and the way into the scene.</summary>
    [CustomEditor(typeof(VolumeAsset))]
    sealed class VolumeAssetEditor : UnityEditor.Editor
    {
        const float HistogramHeight = 64f;

        static readonly GUIContent Create = new GUIContent("Create in scene", "Makes a GameObject that loads, carves and shows this volume");

        readonly SegmentListSection segments = new SegmentListSection();
        readonly HistogramTexture histogram = new HistogramTexture();
        IReadOnlyList<(string title, string text)> lines;

        public override void OnInspectorGUI()
        {
            bool enabled = GUI.enabled;
            GUI.enabled = true; // imported assets are shown disabled; here nothing is edited, but searched and pressed
            var asset = (VolumeAsset)target;
            lines ??= VolumeSummary.Of(asset);
            if (GUILayout.Button(Create))
                VolumeObjects.CreateVolume(asset, null);
            foreach ((string title, string text) in lines)
                EditorGUILayout.LabelField(title, text, EditorStyles.wordWrappedLabel);
            foreach (string warning in asset.Warnings)
                EditorGUILayout.HelpBox(warning, MessageType.Warning);
            EditorGUILayout.Space();
            DrawHistogram(asset.Histogram);
            EditorGUILayout.Space();
            segments.Draw(asset.Segments);
            GUI.enabled = enabled;
        }

        public override bool HasPreviewGUI() => ((VolumeAsset)target).Thumbnail != null;

        public override void OnPreviewGUI(Rect r, GUIStyle background)
        {
            if (Event.current.type == EventType.Repaint)
                GUI.DrawTexture(r, ((VolumeAsset)target).Thumbnail, ScaleMode.ScaleToFit, true);
        }

        void OnDisable() => histogram.Dispose();

        void DrawHistogram(IntensityHistogram counts)
        {
            Rect rect = EditorGUILayout.GetControlRect(false, HistogramHeight);
            if (Event.current.type != EventType.Repaint)
                return;
            var window = new ValueWindow(counts.ValueMin, counts.StartOf(counts.BinCount));
            EditorGUI.DrawRect(rect, TransferFunctionPainter.Background);
            GUI.DrawTexture(rect, histogram.Of(counts, window, (int)rect.width), ScaleMode.StretchToFill, true);
        }
    }
}
