using System.Collections.Generic;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// Edits of how many segments look, as a renderer saves them: only segments that look other than the volume says are listed. Those that the volume
    /// does not have are kept for the volumes that do.
    /// </summary>
    sealed class SegmentLooks
    {
        readonly SegmentTable ofVolume;
        readonly List<SegmentAppearance> looks;
        readonly Dictionary<long, int> indexOfLabel = new Dictionary<long, int>();

        /// <param name="ofVolume">The segments as the volume says.</param>
        /// <param name="overrides">The segments that look otherwise now; of several for one label the last counts.</param>
        public SegmentLooks(SegmentTable ofVolume, IReadOnlyList<SegmentAppearance> overrides)
        {
            this.ofVolume = ofVolume;
            looks = new List<SegmentAppearance>(overrides.Count);
            foreach (SegmentAppearance look in overrides)
                Put(look);
        }

        /// <summary>The segments that look other than the volume says, in the order in which they came.</summary>
        public List<SegmentAppearance> Result()
        {
            var result = new List<SegmentAppearance>(looks.Count);
            foreach (SegmentAppearance look in looks)
            {
                int row = ofVolume.IndexOfLabel(look.Label);
                if (row < 0 || !Says(ofVolume[row], look))
                    result.Add(look);
            }
            return result;
        }

        /// <summary>How a segment looks.</summary>
        public SegmentAppearance this[int row]
        {
            get
            {
                Segment segment = ofVolume[row];
                return indexOfLabel.TryGetValue(segment.Label, out int index)
                    ? looks[index]
                    : new SegmentAppearance(segment.Label, ToColor(segment.Color), segment.Opacity);
            }
        }

        public void SetOpacity(int row, float opacity)
        {
            SegmentAppearance look = this[row];
            Put(new SegmentAppearance(look.Label, look.Color, Mathf.Clamp01(opacity)));
        }

        public void SetColor(int row, Color color)
        {
            SegmentAppearance look = this[row];
            Put(new SegmentAppearance(look.Label, color, look.Opacity));
        }

        /// <summary>Lets a segment look as the volume says.</summary>
        public void Reset(int row)
        {
            Segment segment = ofVolume[row];
            Put(new SegmentAppearance(segment.Label, ToColor(segment.Color), segment.Opacity));
        }

        public static Color ToColor(SegmentColor color) => new Color(color.RedFloat, color.GreenFloat, color.BlueFloat);

        void Put(SegmentAppearance look)
        {
            if (indexOfLabel.TryGetValue(look.Label, out int index))
            {
                looks[index] = look;
                return;
            }
            indexOfLabel.Add(look.Label, looks.Count);
            looks.Add(look);
        }

        static bool Says(Segment segment, SegmentAppearance look) =>
            segment.Opacity == look.Opacity && segment.Color == SegmentColor.FromFloats(look.Color.r, look.Color.g, look.Color.b);
    }
}
