using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>A loaded volume in the Scene view: what a click selects, and the box with the patient's directions when it is selected.</summary>
    static class VolumeGizmos
    {
        /// <summary>How far letters lie outside the box, relative to its extents.</summary>
        const float LetterDistance = 1.12f;

        static readonly Color BoxColor = new Color(1f, 1f, 1f, 0.5f);

        /// <summary>The volume is no mesh that Unity could pick: an invisible box stands for it.</summary>
        [DrawGizmo(GizmoType.Pickable | GizmoType.Selected | GizmoType.NonSelected)]
        static void DrawPickable(CarvedVolumeRenderer renderer, GizmoType type)
        {
            if (!TryGetFrame(renderer, out Matrix4x4 frame))
                return;
            Gizmos.matrix = frame;
            Gizmos.color = Color.clear;
            Gizmos.DrawCube(Vector3.zero, Vector3.one);
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.Active)]
        static void DrawBox(CarvedVolumeRenderer renderer, GizmoType type)
        {
            if (!TryGetFrame(renderer, out Matrix4x4 frame))
                return;
            Gizmos.matrix = frame;
            Gizmos.color = BoxColor;
            Gizmos.DrawWireCube(Vector3.zero, Vector3.one);
            DrawLetters(renderer.transform, LetterDistance * BoxFrame.Extents(renderer.Volume.Geometry));
        }

        /// <summary>In a volume's local space +x is the patient's left, +y superior, +z posterior.</summary>
        static void DrawLetters(Transform volume, Vector3 at)
        {
            Handles.Label(volume.TransformPoint(new Vector3(at.x, 0f, 0f)), "L", EditorStyles.whiteBoldLabel);
            Handles.Label(volume.TransformPoint(new Vector3(-at.x, 0f, 0f)), "R", EditorStyles.whiteBoldLabel);
            Handles.Label(volume.TransformPoint(new Vector3(0f, at.y, 0f)), "S", EditorStyles.whiteBoldLabel);
            Handles.Label(volume.TransformPoint(new Vector3(0f, -at.y, 0f)), "I", EditorStyles.whiteBoldLabel);
            Handles.Label(volume.TransformPoint(new Vector3(0f, 0f, at.z)), "P", EditorStyles.whiteBoldLabel);
            Handles.Label(volume.TransformPoint(new Vector3(0f, 0f, -at.z)), "A", EditorStyles.whiteBoldLabel);
        }

        static bool TryGetFrame(CarvedVolumeRenderer renderer, out Matrix4x4 frame)
        {
            SegmentedVolume volume = renderer.Volume;
            frame = volume == null ? default : renderer.transform.localToWorldMatrix * BoxFrame.UnitCubeToLocal(volume.Geometry);
            return volume != null;
        }
    }
}
