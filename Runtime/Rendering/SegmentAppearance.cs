using System;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>How a segment is shown, in place of what the volume says.</summary>
    [Serializable]
    public struct SegmentAppearance
    {
        [SerializeField, Tooltip("The segment's value in the label map")]
        long label;

        [SerializeField, Tooltip("The segment's colour")]
        Color color;

        [SerializeField, Range(0f, 1f), Tooltip("0 = invisible; multiplies the transfer function")]
        float opacity;

        /// <summary>Sets all of it.</summary>
        /// <param name="label">The segment's value in the label map; 0 = tissue that no segment claims.</param>
        /// <param name="color">Its colour, sRGB as in all of Unity's colour fields; alpha does not count.</param>
        /// <param name="opacity">0 (invisible) to 1; multiplies the transfer function.</param>
        /// <exception cref="ArgumentOutOfRangeException">The opacity lies outside, or a channel of the colour is negative, infinite or NaN.</exception>
        public SegmentAppearance(long label, Color color, float opacity)
        {
            this.label = label;
            this.color = SettingRange.Checked(color, nameof(color));
            this.opacity = SettingRange.Checked(opacity, 0f, 1f, nameof(opacity));
        }

        /// <summary>The segment's value in the label map.</summary>
        public long Label => label;

        /// <summary>Its colour, sRGB.</summary>
        public Color Color => color;

        /// <summary>0 (invisible) to 1; multiplies the transfer function.</summary>
        public float Opacity => opacity;
    }
}
