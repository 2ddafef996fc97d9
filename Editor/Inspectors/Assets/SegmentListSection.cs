using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEditor.IMGUI.Controls;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The segments of an asset: a search and a table that only shows.</summary>
    sealed class SegmentListSection : IRows
    {
        const int VisibleRows = 14;

        readonly SegmentFilter filter = new SegmentFilter();
        readonly SegmentTexts texts = new SegmentTexts();
        readonly VirtualList list = new VirtualList(VisibleRows);
        IReadOnlyList<VolumeAssetSegment> shown;
        IReadOnlyList<int> rows;
        SegmentTable table;
        long[] voxelCounts;
        SearchField searchField;

        public void Draw(IReadOnlyList<VolumeAssetSegment> segments)
        {
            if (segments != shown)
            {
                shown = segments;
                table = AssetTable.Of(segments);
                voxelCounts = AssetTable.VoxelCounts(segments);
            }
            if (table == null)
                return;
            searchField ??= new SearchField();
            filter.Search = searchField.OnGUI(EditorGUILayout.GetControlRect(), filter.Search);
            rows = filter.Rows(table);
            DrawTitles(list.TitleRect(rows.Count));
            list.Draw(rows.Count, this);
        }

        public void DrawRow(Rect rect, int index)
        {
            int row = rows[index];
            var columns = new SegmentColumns(rect, false);
            EditorGUI.DrawRect(Inset(columns.Color), SegmentLooks.ToColor(table[row].Color));
            GUI.Label(columns.Name, table[row].Name, EditorStyles.label);
            if (columns.Label.width > 0f)
                GUI.Label(columns.Label, texts.Label(table, row), EditorStyles.miniLabel);
            if (columns.Voxels.width > 0f)
                GUI.Label(columns.Voxels, texts.Voxels(voxelCounts, row), EditorStyles.miniLabel);
        }

        static void DrawTitles(Rect rect)
        {
            var columns = new SegmentColumns(rect, false);
            GUI.Label(columns.Name, "Segment", EditorStyles.miniBoldLabel);
            if (columns.Label.width > 0f)
                GUI.Label(columns.Label, "Label", EditorStyles.miniBoldLabel);
            if (columns.Voxels.width > 0f)
                GUI.Label(columns.Voxels, "Voxels", EditorStyles.miniBoldLabel);
        }

        static Rect Inset(Rect rect) => new Rect(rect.x + 2f, rect.y + 3f, rect.width - 4f, Math.Max(0f, rect.height - 6f));
    }
}
