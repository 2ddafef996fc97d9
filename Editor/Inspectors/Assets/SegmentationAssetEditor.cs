using System;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The Inspector of an imported segmentation: which segments it has.</summary>
    [CustomEditor(typeof(SegmentationAsset))]
    sealed class SegmentationAssetEditor : UnityEditor.Editor
    {
        readonly SegmentListSection segments = new SegmentListSection();
        string size;

        public override void OnInspectorGUI()
        {
            bool enabled = GUI.enabled;
            GUI.enabled = true; // imported assets are shown disabled; here nothing is edited, but searched
            var asset = (SegmentationAsset)target;
            size ??= FormattableString.Invariant($"{asset.Size.x} x {asset.Size.y} x {asset.Size.z} voxels");
            EditorGUILayout.LabelField("Size", size);
            EditorGUILayout.HelpBox("Its voxels are in the volume asset of the scan that it belongs to.", MessageType.None);
            segments.Draw(asset.Segments);
            GUI.enabled = enabled;
        }
    }
}
