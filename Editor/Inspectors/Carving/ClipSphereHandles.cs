using System.Collections.Generic;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// The spheres in the Scene view: circles of the fixed ones, and handles that move and resize the active one. A drag is one step to undo. All is drawn
    /// in the volume's local space, so that spheres are what the patient's millimetres make of them in a volume that is scaled unevenly too.
    /// </summary>
    sealed class ClipSphereHandles
    {
        static readonly Color FixedColor = new Color(1f, 1f, 1f, 0.6f), ActiveColor = new Color(1f, 0.75f, 0.1f, 1f);

        readonly List<string> names = new List<string>();
        CarvingSnapshot named;
        CarvingStack dragged;

        public void Draw(ClipSphereStack stack)
        {
            if (GUIUtility.hotControl == 0)
                EndDrag();
            if (!CarvingEdits.IsPossible(stack))
                return;
            CarvingSnapshot carving = stack.Carving.State;
            Matrix4x4 localToWorld = stack.transform.localToWorldMatrix;
            VolumeGeometry geometry = stack.Loader.Volume.Geometry;
            if (VolumeSpace.WorldScale(localToWorld) == 0)
                return;
            Name(carving);
            using (new Handles.DrawingScope(FixedColor, localToWorld))
            {
                for (int s = 0; s < carving.Fixed.Count; s++)
                    DrawFixed(carving.Fixed[s], geometry, names[s]);
                if (carving.Active is ClipSphere active)
                    DrawActive(stack, active, geometry, names[carving.Fixed.Count]);
            }
        }

        /// <summary>Ends a drag that the mouse did not.</summary>
        public void EndDrag()
        {
            dragged?.EndGesture();
            dragged = null;
        }

        static void DrawFixed(ClipSphere sphere, VolumeGeometry geometry, string name)
        {
            Vector3 centre = VolumeSpace.LpsToLocal(geometry, sphere.CentreLps);
            float radius = Metres(sphere.RadiusMm);
            Handles.DrawWireDisc(centre, Vector3.right, radius);
            Handles.DrawWireDisc(centre, Vector3.up, radius);
            Handles.DrawWireDisc(centre, Vector3.forward, radius);
            Handles.Label(centre + radius * Vector3.up, name);
        }

        void DrawActive(ClipSphereStack stack, ClipSphere sphere, VolumeGeometry geometry, string name)
        {
            Vector3 centre = VolumeSpace.LpsToLocal(geometry, sphere.CentreLps);
            float radius = Metres(sphere.RadiusMm);
            Handles.color = ActiveColor;
            Handles.Label(centre + radius * Vector3.up, name);
            EditorGUI.BeginChangeCheck();
            Vector3 newCentre = Handles.PositionHandle(centre, Quaternion.identity);
            float newRadius = Handles.RadiusHandle(Quaternion.identity, centre, radius);
            if (!EditorGUI.EndChangeCheck())
                return;

            // What was not dragged keeps its double precision.
            PointMm centreLps = newCentre.Equals(centre) ? sphere.CentreLps : VolumeSpace.LocalToLps(geometry, newCentre);
            double radiusMm = newRadius == radius ? sphere.RadiusMm : Mathf.Max(0f, newRadius) / VolumeSpace.MetresPerMm;
            BeginDrag(stack.Carving);
            Move(stack, centreLps, radiusMm);
        }

        static void Move(ClipSphereStack stack, PointMm centreLps, double radiusMm) =>
            CarvingEdits.Do(stack, "Move Clip Sphere", carving => carving.SetActive(centreLps, radiusMm));

        void BeginDrag(CarvingStack carving)
        {
            if (dragged == carving)
                return;
            EndDrag();
            carving.BeginGesture();
            dragged = carving;
        }

        void Name(CarvingSnapshot carving)
        {
            if (carving == named)
                return;
            named = carving;
            names.Clear();
            for (int s = 0; s < carving.Count; s++)
                names.Add(SphereTexts.Title(s, s == carving.Fixed.Count) + ", " + SphereTexts.Radius(carving[s]));
        }

        static float Metres(double mm) => (float)(mm * VolumeSpace.MetresPerMm);
    }
}
