using System.Collections.Generic;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// Hiding and showing: a hidden segment has opacity 0, and one that is shown again the opacity that it had. What it had is remembered as long as the
    /// Inspector lives; then what the volume says counts.
    /// </summary>
    sealed class SegmentVisibility
    {
        readonly Dictionary<long, float> formerOpacities = new Dictionary<long, float>();

        public static bool IsVisible(float opacity) => opacity > 0f;

        public void Hide(SegmentLooks looks, int row)
        {
            SegmentAppearance look = looks[row];
            if (!IsVisible(look.Opacity))
                return;
            formerOpacities[look.Label] = look.Opacity;
            looks.SetOpacity(row, 0f);
        }

        /// <param name="looks">What is edited.</param>
        /// <param name="row">The segment.</param>
        /// <param name="ofVolume">The segment as the volume says.</param>
        public void Show(SegmentLooks looks, int row, Segment ofVolume)
        {
            if (!IsVisible(looks[row].Opacity))
                looks.SetOpacity(row, OpacityWhenShown(ofVolume));
        }

        public void Hide(SegmentLooks looks, IReadOnlyList<int> rows)
        {
            for (int r = 0; r < rows.Count; r++)
                Hide(looks, rows[r]);
        }

        public void Show(SegmentLooks looks, IReadOnlyList<int> rows, SegmentTable ofVolume)
        {
            for (int r = 0; r < rows.Count; r++)
                Show(looks, rows[r], ofVolume[rows[r]]);
        }

        /// <summary>Shows these and hides all others.</summary>
        /// <param name="looks">What is edited.</param>
        /// <param name="rows">The segments to show, ascending.</param>
        /// <param name="ofVolume">The segments as the volume says.</param>
        public void ShowOnly(SegmentLooks looks, IReadOnlyList<int> rows, SegmentTable ofVolume)
        {
            int next = 0;
            for (int row = 0; row < ofVolume.Count; row++)
            {
                if (next < rows.Count && rows[next] == row)
                {
                    Show(looks, row, ofVolume[row]);
                    next++;
                }
                else
                {
                    Hide(looks, row);
                }
            }
        }

        float OpacityWhenShown(Segment ofVolume) =>
            formerOpacities.TryGetValue(ofVolume.Label, out float former) ? former : IsVisible(ofVolume.Opacity) ? ofVolume.Opacity : 1f;
    }
}
