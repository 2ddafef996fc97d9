using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>Draws the rows of a <see cref="VirtualList"/>.</summary>
    interface IRows
    {
        /// <param name="rect">The row's place.</param>
        /// <param name="index">0 to the number of rows - 1.</param>
        void DrawRow(Rect rect, int index);
    }

    /// <summary>A scrolled list that draws only the rows that are seen, so that thousands of them cost as much as a dozen.</summary>
    sealed class VirtualList
    {
        /// <summary>Room for the scroll bar, pixels.</summary>
        const float ScrollBar = 15f;

        static readonly Color Stripe = new Color(0.5f, 0.5f, 0.5f, 0.08f);

        readonly int visibleRows;
        Vector2 scroll;
        float width = 400f;

        /// <param name="visibleRows">How many rows are seen at once.</param>
        public VirtualList(int visibleRows) => this.visibleRows = visibleRows;

        static float RowHeight => EditorGUIUtility.singleLineHeight + EditorGUIUtility.standardVerticalSpacing;

        /// <summary>The place of the titles above the columns: as wide as the rows are.</summary>
        public Rect TitleRect(int count)
        {
            Rect rect = EditorGUILayout.GetControlRect(false, RowHeight);
            rect.width -= count > visibleRows ? ScrollBar : 0f;
            return rect;
        }

        public void Draw(int count, IRows rows)
        {
            float height = Mathf.Clamp(count, 1, visibleRows) * RowHeight;
            Rect area = EditorGUILayout.GetControlRect(false, height);

            // The area is not known yet in the Layout event, and rows have to draw the same controls in each.
            if (Event.current.type == EventType.Layout)
                area = new Rect(0f, 0f, width, height);
            else
                width = area.width;
            var view = new Rect(0f, 0f, area.width - (count > visibleRows ? ScrollBar : 0f), count * RowHeight);
            Vector2 scrolled = GUI.BeginScrollView(area, scroll, view);
            if (scrolled != scroll)
            {
                scroll = scrolled;
                LetGoOfFields();
            }
            var range = new RowRange(count, RowHeight, scroll.y, height);
            for (int index = range.First; index < range.End; index++)
            {
                var row = new Rect(0f, index * RowHeight, view.width, RowHeight);
                if (index % 2 == 1 && Event.current.type == EventType.Repaint)
                    EditorGUI.DrawRect(row, Stripe);
                rows.DrawRow(row, index);
            }
            GUI.EndScrollView();
        }

        /// <summary>A field that is being typed into is known by its place among all controls; after scrolling, another row would stand there.</summary>
        static void LetGoOfFields()
        {
            if (GUIUtility.hotControl == 0)
                GUIUtility.keyboardControl = 0;
        }
    }
}
