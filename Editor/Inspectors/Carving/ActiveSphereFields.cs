using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The active sphere's numbers as fields, and the button that makes one.</summary>
    static class ActiveSphereFields
    {
        /// <summary>A new sphere's radius as a share of the volume's smallest extent.</summary>
        const double FirstRadius = 0.3;

        static readonly GUIContent Radius = new GUIContent("Active radius, mm", "Radius of the active sphere in the patient's millimetres");
        static readonly GUIContent Left = new GUIContent("Active centre L, mm", "Towards the patient's left, in the scan's own coordinates (LPS)");
        static readonly GUIContent Back = new GUIContent("Active centre P, mm", "Towards the patient's back, in the scan's own coordinates (LPS)");
        static readonly GUIContent Head = new GUIContent("Active centre S, mm", "Towards the patient's head, in the scan's own coordinates (LPS)");
        static readonly GUIContent Place = new GUIContent("Place a sphere", "An active sphere in the middle of the volume");

        public static void Draw(ClipSphereStack stack)
        {
            ClipSphere sphere = stack.Carving.Active;
            if (sphere is null)
            {
                if (GUILayout.Button(Place))
                    PlaceFirst(stack);
                return;
            }
            EditorGUI.BeginChangeCheck();
            double radius = EditorGUILayout.DelayedDoubleField(Radius, sphere.RadiusMm);
            double x = EditorGUILayout.DelayedDoubleField(Left, sphere.CentreLps.X);
            double y = EditorGUILayout.DelayedDoubleField(Back, sphere.CentreLps.Y);
            double z = EditorGUILayout.DelayedDoubleField(Head, sphere.CentreLps.Z);
            if (EditorGUI.EndChangeCheck())
                Move(stack, new PointMm(SphereLimits.Coordinate(x), SphereLimits.Coordinate(y), SphereLimits.Coordinate(z)), SphereLimits.Radius(radius));
        }

        static void Move(ClipSphereStack stack, PointMm centreLps, double radiusMm) =>
            CarvingEdits.Do(stack, "Move Clip Sphere", carving => carving.SetActive(centreLps, radiusMm));

        static void PlaceFirst(ClipSphereStack stack)
        {
            VolumeGeometry geometry = stack.Loader.Volume.Geometry;
            Vector3 extents = BoxFrame.Extents(geometry);
            double radiusMm = 2 * FirstRadius * Mathf.Min(extents.x, Mathf.Min(extents.y, extents.z)) / VolumeSpace.MetresPerMm;
            CarvingEdits.Do(stack, "Place Clip Sphere", carving => carving.SetActive(geometry.CentreLps, radiusMm));
        }
    }
}
