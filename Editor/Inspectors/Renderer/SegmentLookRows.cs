using System.Collections.Generic;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The rows of a renderer's segment table, and what its buttons do to those that are listed.</summary>
    sealed class SegmentLookRows : IRows
    {
        /// <summary>Below this Unity's slider is a number field only.</summary>
        const float NarrowestSlider = 116f;

        static readonly GUIContent ClipTitle = new GUIContent("Clip", "Whether the active sphere clips the segment");

        readonly AppearanceProperty appearance;
        readonly SegmentVisibility visibility = new SegmentVisibility();
        readonly SegmentTexts texts = new SegmentTexts();
        CarvedVolumeRenderer renderer;
        SegmentTable table;
        IReadOnlyList<int> listed;
        IReadOnlyList<long> voxelCounts;
        SegmentMask mask;
        long pickedLabel;

        public SegmentLookRows(AppearanceProperty appearance) => this.appearance = appearance;

        /// <summary>Whether the active sphere's mask can be edited.</summary>
        public bool CanMask { get; private set; }

        /// <summary>Says what is drawn and edited next.</summary>
        public void Set(CarvedVolumeRenderer target, SegmentTable segments, IReadOnlyList<int> rows, IReadOnlyList<long> counts)
        {
            renderer = target;
            table = segments;
            listed = rows;
            voxelCounts = counts;
            ClipSphereStack stack = target.Stack;
            bool same = stack != null && stack.Loader != null && stack.Loader.Volume == target.Volume && CarvingEdits.IsPossible(stack);
            mask = same ? stack.Carving.ActiveMask : null;
            CanMask = same && CarvingEdits.IsMaskPossible(stack);
        }

        public void DrawTitles(Rect rect)
        {
            var columns = new SegmentColumns(rect, true);
            GUI.Label(columns.Name, "Segment", EditorStyles.miniBoldLabel);
            GUI.Label(columns.Opacity, "Opacity", EditorStyles.miniBoldLabel);
            Title(columns.Label, "Label");
            Title(columns.Voxels, "Voxels");
            GUI.Label(columns.Clipped, ClipTitle, EditorStyles.miniBoldLabel);
        }

        public void DrawRow(Rect rect, int index)
        {
            int row = listed[index];
            Segment segment = table[row];
            var columns = new SegmentColumns(rect, true);
            DrawVisible(columns.Visible, row, segment.Opacity);
            DrawColor(columns.Color, segment);
            DrawOpacity(columns.Opacity, segment);
            GUI.Label(columns.Name, segment.Name, EditorStyles.label);
            if (columns.Label.width > 0f)
                GUI.Label(columns.Label, texts.Label(table, row), EditorStyles.miniLabel);
            if (columns.Voxels.width > 0f)
                GUI.Label(columns.Voxels, texts.Voxels(voxelCounts, row), EditorStyles.miniLabel);
            DrawClipped(columns.Clipped, row);
        }

        public void ShowListed() => Edit(looks => visibility.Show(looks, listed, renderer.Volume.Segments));

        public void HideListed() => Edit(looks => visibility.Hide(looks, listed));

        public void ShowOnlyListed() => Edit(looks => visibility.ShowOnly(looks, listed, renderer.Volume.Segments));

        public void ResetListed() => Edit(looks =>
        {
            for (int r = 0; r < listed.Count; r++)
                looks.Reset(listed[r]);
        });

        public void MaskListed(MaskEdit edit) =>
            CarvingEdits.Do(renderer.Stack, "Edit Mask", carving => carving.SetActiveMask(MaskEdits.Apply(carving.ActiveMask, edit, listed)));

        void DrawVisible(Rect rect, int row, float opacity)
        {
            bool visible = SegmentVisibility.IsVisible(opacity);
            if (EditorGUI.Toggle(rect, visible) != visible)
                SetVisible(row, !visible);
        }

        void SetVisible(int row, bool visible)
        {
            if (visible)
                Edit(looks => visibility.Show(looks, row, renderer.Volume.Segments[row]));
            else
                Edit(looks => visibility.Hide(looks, row));
        }

        /// <summary>
        /// A colour picker answers the field that stands where the clicked one stood. After scrolling, that is another row's: so the segment that was clicked
        /// gets the colour, whichever row's field reports it.
        /// </summary>
        void DrawColor(Rect rect, Segment segment)
        {
            if (Event.current.type == EventType.MouseDown && rect.Contains(Event.current.mousePosition))
                pickedLabel = segment.Label;
            EditorGUI.BeginChangeCheck();
            Color color = EditorGUI.ColorField(rect, GUIContent.none, SegmentLooks.ToColor(segment.Color), false, false, false);
            if (!EditorGUI.EndChangeCheck())
                return;
            int picked = table.IndexOfLabel(pickedLabel);
            if (picked >= 0)
                appearance.SetSegment(new SegmentAppearance(pickedLabel, color, table[picked].Opacity));
        }

        void DrawOpacity(Rect rect, Segment segment)
        {
            EditorGUI.BeginChangeCheck();
            float opacity = rect.width < NarrowestSlider
                ? GUI.HorizontalSlider(rect, segment.Opacity, 0f, 1f)
                : EditorGUI.Slider(rect, segment.Opacity, 0f, 1f);
            if (EditorGUI.EndChangeCheck())
                appearance.SetSegment(new SegmentAppearance(segment.Label, SegmentLooks.ToColor(segment.Color), Mathf.Clamp01(opacity)));
        }

        void DrawClipped(Rect rect, int row)
        {
            if (mask == null || row >= mask.SegmentCount)
                return;
            using (new EditorGUI.DisabledScope(!CanMask))
            {
                bool clipped = mask[row];
                if (EditorGUI.Toggle(rect, clipped) != clipped)
                    ToggleClipped(row);
            }
        }

        void ToggleClipped(int row) => CarvingEdits.Do(renderer.Stack, "Edit Mask", carving => carving.ToggleSegment(row));

        void Edit(System.Action<SegmentLooks> edit)
        {
            var looks = new SegmentLooks(renderer.Volume.Segments, renderer.Appearance.Segments);
            edit(looks);
            appearance.SetSegments(looks.Result());
        }

        static void Title(Rect rect, string title)
        {
            if (rect.width > 0f)
                GUI.Label(rect, title, EditorStyles.miniBoldLabel);
        }
    }
}
