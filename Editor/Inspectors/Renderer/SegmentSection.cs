using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEditor.IMGUI.Controls;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The segments: a search, buttons for the rows that it leaves, and the table.</summary>
    sealed class SegmentSection
    {
        const int VisibleRows = 14;

        static readonly GUIContent Show = new GUIContent("Show", "Shows the listed segments");
        static readonly GUIContent Hide = new GUIContent("Hide", "Hides the listed segments");
        static readonly GUIContent Only = new GUIContent("Only these", "Shows the listed segments and hides all others");
        static readonly GUIContent ResetLooks = new GUIContent("Reset looks", "The listed segments look as the volume says");
        static readonly GUIContent Clip = new GUIContent("Clip", "The active sphere clips the listed segments");
        static readonly GUIContent Keep = new GUIContent("Keep", "The active sphere leaves the listed segments");
        static readonly GUIContent Invert = new GUIContent(
            "Invert", "The active sphere clips those of the listed segments that it left, and leaves those that it clipped");

        readonly SegmentFilter filter = new SegmentFilter();
        readonly VirtualList list = new VirtualList(VisibleRows);
        readonly SegmentLookRows rows;
        readonly Background<SegmentedVolume, long[]> voxelCounts = new Background<SegmentedVolume, long[]>(CountVoxels);
        SearchField searchField;
        string count = "";
        int counted = -1, countedOf = -1;

        public SegmentSection(AppearanceProperty appearance) => rows = new SegmentLookRows(appearance);

        /// <summary>Whether voxels are being counted.</summary>
        public bool IsBusy => voxelCounts.IsBusy;

        /// <param name="renderer">The only one that is edited.</param>
        public void Draw(CarvedVolumeRenderer renderer)
        {
            SegmentTable table = renderer.Segments;
            if (table == null)
            {
                EditorGUILayout.HelpBox("The segments are listed as soon as a volume is loaded.", MessageType.None);
                return;
            }
            SegmentedVolume volume = renderer.Volume;
            if (table != renderer.Appearance.Apply(volume.Segments))
                EditorGUILayout.HelpBox("A script has set these looks. Edits are saved, and seen once it sets none.", MessageType.Info);
            searchField ??= new SearchField();
            filter.Search = searchField.OnGUI(EditorGUILayout.GetControlRect(), filter.Search);
            IReadOnlyList<int> listed = filter.Rows(table);
            rows.Set(renderer, table, listed, voxelCounts.Of(volume));
            DrawButtons(listed.Count > 0);
            rows.DrawTitles(list.TitleRect(listed.Count));
            list.Draw(listed.Count, rows);
            GUILayout.Label(Count(listed.Count, table.Count), EditorStyles.miniLabel);
        }

        void DrawButtons(bool any)
        {
            using (new EditorGUI.DisabledScope(!any))
            {
                using (new EditorGUILayout.HorizontalScope())
                {
                    if (GUILayout.Button(Show, EditorStyles.miniButtonLeft))
                        rows.ShowListed();
                    if (GUILayout.Button(Hide, EditorStyles.miniButtonMid))
                        rows.HideListed();
                    if (GUILayout.Button(Only, EditorStyles.miniButtonMid))
                        rows.ShowOnlyListed();
                    if (GUILayout.Button(ResetLooks, EditorStyles.miniButtonRight))
                        rows.ResetListed();
                }
                using (new EditorGUI.DisabledScope(!rows.CanMask))
                using (new EditorGUILayout.HorizontalScope())
                {
                    if (GUILayout.Button(Clip, EditorStyles.miniButtonLeft))
                        rows.MaskListed(MaskEdit.Clip);
                    if (GUILayout.Button(Keep, EditorStyles.miniButtonMid))
                        rows.MaskListed(MaskEdit.Keep);
                    if (GUILayout.Button(Invert, EditorStyles.miniButtonRight))
                        rows.MaskListed(MaskEdit.Invert);
                }
            }
        }

        string Count(int listed, int all)
        {
            if (listed != counted || all != countedOf)
                count = FormattableString.Invariant($"{listed:N0} of {all:N0} segments, unlabelled tissue included");
            counted = listed;
            countedOf = all;
            return count;
        }

        static long[] CountVoxels(SegmentedVolume volume) => volume.Labels.CountVoxels();
    }
}
