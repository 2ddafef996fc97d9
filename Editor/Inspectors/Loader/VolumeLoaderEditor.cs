using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The Inspector of a loader: where its volume comes from, whether it is there, and what it is.</summary>
    [CustomEditor(typeof(VolumeLoader))]
    [CanEditMultipleObjects]
    sealed class VolumeLoaderEditor : UnityEditor.Editor
    {
        static readonly GUIContent LoadNow = new GUIContent("Load now", "Loads the asset, or else the files, in Play or outside");
        static readonly GUIContent Unload = new GUIContent("Unload", "Lets go of the volume");
        static readonly GUIContent Cancel = new GUIContent("Cancel", "Stops loading; what was there stays");

        SerializedProperty asset, intensityPath, labelsPath, loadOnStart, memory;
        VolumeLoader listenedTo;
        SegmentedVolume described;
        IReadOnlyList<(string title, string text)> lines;
        string error;

        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            DrawSource();
            if (serializedObject.ApplyModifiedProperties())
                EditorViews.Refresh(); // outside Play the loader looks for what to load in the next frame
            if (serializedObject.isEditingMultipleObjects || EditorUtility.IsPersistent(target))
                return;
            var loader = (VolumeLoader)target;
            EditorGUILayout.Space();
            DrawState(loader);
            DrawButtons(loader);
        }

        public override bool RequiresConstantRepaint() => target is VolumeLoader loader && loader.IsLoading;

        void OnEnable()
        {
            asset = serializedObject.FindProperty("asset");
            intensityPath = serializedObject.FindProperty("intensityPath");
            labelsPath = serializedObject.FindProperty("labelsPath");
            loadOnStart = serializedObject.FindProperty("loadOnStart");
            memory = serializedObject.FindProperty("memory");
            listenedTo = (VolumeLoader)target;
            listenedTo.Failed += ShowError;
            listenedTo.Loaded += ForgetError;
        }

        void OnDisable()
        {
            if (listenedTo is null)
                return;
            listenedTo.Failed -= ShowError;
            listenedTo.Loaded -= ForgetError;
            listenedTo = null;
        }

        void DrawSource()
        {
            EditorGUILayout.PropertyField(asset);
            bool fromAsset = !asset.hasMultipleDifferentValues && asset.objectReferenceValue != null;
            if (!fromAsset)
            {
                PathField.Draw(intensityPath, "Choose the scan");
                PathField.Draw(labelsPath, "Choose the scan's segmentation");
            }
            EditorGUILayout.PropertyField(loadOnStart);
            EditorGUILayout.PropertyField(memory, true);
        }

        void DrawState(VolumeLoader loader)
        {
            if (error != null)
                EditorGUILayout.HelpBox(error, MessageType.Error);
            if (loader.IsLoading)
            {
                Rect bar = EditorGUILayout.GetControlRect();
                EditorGUI.ProgressBar(bar, loader.Progress, FormattableString.Invariant($"Loading, {100f * loader.Progress:0} %"));
            }
            SegmentedVolume volume = loader.Volume;
            if (volume == null)
            {
                if (!loader.IsLoading)
                    EditorGUILayout.HelpBox(
                        LoaderSource.IsNamed(loader) ? "No volume is loaded." : "Drag a volume asset here, or choose a file with a scan.", MessageType.Info);
                return;
            }
            if (volume != described)
                lines = VolumeSummary.Of(described = volume);
            foreach ((string title, string text) in lines)
                EditorGUILayout.LabelField(title, text, EditorStyles.wordWrappedLabel);
            if (loader.IsCoarse)
                EditorGUILayout.HelpBox("This is a coarse volume, shown while the whole one loads.", MessageType.Info);
            foreach (string warning in volume.Warnings)
                EditorGUILayout.HelpBox(warning, MessageType.Warning);
        }

        void DrawButtons(VolumeLoader loader)
        {
            using (new EditorGUILayout.HorizontalScope())
            {
                using (new EditorGUI.DisabledScope(!LoaderSource.IsNamed(loader)))
                    if (GUILayout.Button(LoadNow))
                        Load(loader);
                using (new EditorGUI.DisabledScope(!loader.IsLoading))
                    if (GUILayout.Button(Cancel))
                        loader.Cancel();
                using (new EditorGUI.DisabledScope(loader.Volume == null))
                    if (GUILayout.Button(Unload))
                        DoUnload(loader);
            }
        }

        void Load(VolumeLoader loader)
        {
            error = null;
            LoaderSource.Load(loader);
        }

        void DoUnload(VolumeLoader loader)
        {
            loader.Unload();
            described = null;
            lines = null;
            EditorViews.Refresh();
        }

        void ShowError(Exception problem)
        {
            error = problem.Message;
            Repaint();
        }

        void ForgetError(SegmentedVolume volume)
        {
            error = null;
            Repaint();
        }
    }
}
