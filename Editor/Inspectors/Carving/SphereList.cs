using System.Collections.Generic;
using AnatomyCarve.Carving;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The spheres of a carving in a list: radius, centre, how many segments each clips.</summary>
    sealed class SphereList : IRows
    {
        const int VisibleRows = 8;
        const float TitleShare = 0.18f, RadiusShare = 0.2f, ClippedShare = 0.22f;

        readonly VirtualList list = new VirtualList(VisibleRows);
        readonly List<string[]> texts = new List<string[]>();
        CarvingSnapshot shown;

        public void Draw(CarvingSnapshot carving)
        {
            Describe(carving);
            if (carving.Count == 0)
            {
                EditorGUILayout.LabelField("No sphere: the whole volume is shown.", EditorStyles.miniLabel);
                return;
            }
            DrawTexts(list.TitleRect(carving.Count), "", "Radius", "Centre, mm", "Clips segments", EditorStyles.miniBoldLabel);
            list.Draw(carving.Count, this);
        }

        public void DrawRow(Rect rect, int index)
        {
            string[] row = texts[index];
            GUIStyle style = index == shown.Fixed.Count ? EditorStyles.miniBoldLabel : EditorStyles.miniLabel;
            DrawTexts(rect, row[0], row[1], row[2], row[3], style);
        }

        static void DrawTexts(Rect rect, string title, string radius, string centre, string clipped, GUIStyle style)
        {
            float x = rect.x;
            Label(title, TitleShare);
            Label(radius, RadiusShare);
            Label(centre, 1f - TitleShare - RadiusShare - ClippedShare);
            Label(clipped, ClippedShare);

            void Label(string text, float share)
            {
                GUI.Label(new Rect(x, rect.y, share * rect.width, rect.height), text, style);
                x += share * rect.width;
            }
        }

        void Describe(CarvingSnapshot carving)
        {
            if (carving == shown)
                return;
            shown = carving;
            texts.Clear();
            for (int s = 0; s < carving.Count; s++)
                texts.Add(new[]
                {
                    SphereTexts.Title(s, s == carving.Fixed.Count), SphereTexts.Radius(carving[s]), SphereTexts.Centre(carving[s]),
                    SphereTexts.Clipped(carving[s]),
                });
        }
    }
}
