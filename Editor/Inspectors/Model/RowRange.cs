using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The rows of a long list that a scrolled view shows, so that only those are drawn.</summary>
    readonly struct RowRange
    {
        /// <param name="rows">Rows of the list.</param>
        /// <param name="rowHeight">A row's height, pixels, above 0.</param>
        /// <param name="scroll">What is scrolled away above the view, pixels.</param>
        /// <param name="viewHeight">The view's height, pixels.</param>
        public RowRange(int rows, float rowHeight, float scroll, float viewHeight)
        {
            First = Mathf.Clamp((int)(scroll / rowHeight), 0, rows);
            End = Mathf.Clamp(Mathf.CeilToInt((scroll + viewHeight) / rowHeight), First, rows);
        }

        /// <summary>The first row that is seen, in part at least.</summary>
        public int First { get; }

        /// <summary>One behind the last row that is seen.</summary>
        public int End { get; }
    }
}
