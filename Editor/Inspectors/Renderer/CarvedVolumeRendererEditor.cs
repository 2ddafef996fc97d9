using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The Inspector of a renderer: what is missing, its settings, transfer function, segments, statistics, and a preview.</summary>
    [CustomEditor(typeof(CarvedVolumeRenderer))]
    [CanEditMultipleObjects]
    sealed class CarvedVolumeRendererEditor : UnityEditor.Editor
    {
        static readonly GUIContent ResetView = new GUIContent("Reset view", "Looks from where the preview looked first");

        Section volume, quality, light, function, segments, statistics;
        SerializedProperty loader, stack, drawInCameras, layout;
        SerializedProperty[] lightSettings;
        QualitySection qualitySection;
        TransferFunctionSection functionSection;
        SegmentSection segmentSection;
        string layerHint;
        int hintedLayer;
        readonly StatisticsSection statisticsSection = new StatisticsSection();
        readonly VolumePreview preview = new VolumePreview();

        CarvedVolumeRenderer Only => serializedObject.isEditingMultipleObjects ? null : (CarvedVolumeRenderer)target;

        public override void OnInspectorGUI()
        {
            CarvedVolumeRenderer only = Only;
            serializedObject.Update();
            if (only != null)
                DrawNotice(only);
            if (volume.Draw())
                DrawVolume(only);
            if (quality.Draw())
                qualitySection.Draw(targets);
            if (light.Draw())
                foreach (SerializedProperty setting in lightSettings)
                    EditorGUILayout.PropertyField(setting);
            if (function.Draw())
                functionSection.Draw((CarvedVolumeRenderer)target);
            if (segments.Draw() && IsForOne(only))
                segmentSection.Draw(only);
            if (serializedObject.ApplyModifiedProperties())
                EditorViews.Refresh();
            if (statistics.Draw() && IsForOne(only))
                statisticsSection.Draw(only.Statistics);
        }

        /// <summary>While something is on its way that is to be seen when it arrives.</summary>
        public override bool RequiresConstantRepaint()
        {
            CarvedVolumeRenderer only = Only;
            if (only == null)
                return false;
            bool loading = only.Loader != null && only.Loader.IsLoading;
            return loading || functionSection.IsBusy || segmentSection.IsBusy || (Application.isPlaying && (statistics.IsOpen || segments.IsOpen));
        }

        public override bool HasPreviewGUI() => Only != null && Only.Volume != null;

        public override GUIContent GetPreviewTitle() => new GUIContent(target.name);

        public override void OnPreviewSettings()
        {
            if (GUILayout.Button(ResetView, EditorStyles.toolbarButton))
                preview.Reset();
        }

        public override void OnPreviewGUI(Rect r, GUIStyle background) => preview.Draw(r, Only);

        /// <summary>Called by the Scene view, by name: F frames the volume.</summary>
        public bool HasFrameBounds() => VolumeBounds.TryGet(targets, out _);

        /// <summary>Called by the Scene view, by name.</summary>
        public Bounds OnGetFrameBounds()
        {
            VolumeBounds.TryGet(targets, out Bounds bounds);
            return bounds;
        }

        void OnEnable()
        {
            volume = new Section("Volume", "What is shown, and where", true);
            quality = new Section("Quality", "What pictures may cost", true);
            light = new Section("Light", "The light that follows the viewer", false);
            function = new Section("Transfer function", "Opacity by intensity", true);
            segments = new Section("Segments", "Colours, opacities, and what the active sphere clips", true);
            statistics = new Section("Statistics", "What was computed, and what lies on the GPU", false);
            loader = serializedObject.FindProperty("loader");
            stack = serializedObject.FindProperty("stack");
            drawInCameras = serializedObject.FindProperty("drawInCameras");
            layout = serializedObject.FindProperty("layout");
            lightSettings = Children(serializedObject.FindProperty("shading"));
            qualitySection = new QualitySection(serializedObject.FindProperty("quality"));
            var appearance = new AppearanceProperty(serializedObject.FindProperty("appearance"));
            functionSection = new TransferFunctionSection(serializedObject, appearance);
            segmentSection = new SegmentSection(appearance);
        }

        void OnDisable()
        {
            preview.Dispose();
            functionSection?.Dispose();
        }

        static void DrawNotice(CarvedVolumeRenderer only)
        {
            VolumeLoader source = only.Loader;
            Notice notice = new RendererFacts
            {
                Problem = only.Problem,
                HasLoader = source != null,
                NamesVolume = source != null && LoaderSource.IsNamed(source),
                IsLoading = source != null && source.IsLoading,
                Progress = source != null ? source.Progress : 0f,
                HasVolume = only.Volume != null,
                IsEnabled = only.isActiveAndEnabled,
                IsAsset = EditorUtility.IsPersistent(only),
            }.Notice();
            if (notice.Text != null)
                EditorGUILayout.HelpBox(notice.Text, (MessageType)notice.Kind);
        }

        void DrawVolume(CarvedVolumeRenderer only)
        {
            EditorGUILayout.PropertyField(loader);
            EditorGUILayout.PropertyField(stack);
            EditorGUILayout.PropertyField(drawInCameras);
            if (drawInCameras.boolValue && only != null)
                GUILayout.Label(LayerHint(only.gameObject.layer), EditorStyles.wordWrappedMiniLabel);
            EditorGUILayout.PropertyField(layout);
        }

        string LayerHint(int layer)
        {
            if (layerHint == null || layer != hintedLayer)
                layerHint = $"Drawn by cameras that see the GameObject's layer, {LayerMask.LayerToName(layer)}.";
            hintedLayer = layer;
            return layerHint;
        }

        static bool IsForOne(CarvedVolumeRenderer only)
        {
            if (only == null)
                EditorGUILayout.HelpBox("Select one renderer to see this.", MessageType.None);
            return only != null;
        }

        static SerializedProperty[] Children(SerializedProperty parent)
        {
            var children = new List<SerializedProperty>();
            SerializedProperty end = parent.GetEndProperty();
            SerializedProperty child = parent.Copy();
            for (bool more = child.NextVisible(true); more && !SerializedProperty.EqualContents(child, end); more = child.NextVisible(false))
                children.Add(child.Copy());
            return children.ToArray();
        }
    }
}
