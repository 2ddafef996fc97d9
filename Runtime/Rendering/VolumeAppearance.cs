using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// How a renderer shows whatever volume it has: the transfer function, and the segments that are to look other than the volume says. Saved with the
    /// scene; segments are named by their labels, and labels that a volume does not have do nothing.
    /// </summary>
    [Serializable]
    public sealed class VolumeAppearance
    {
        [SerializeField, Tooltip("Opacity by intensity. Off: chosen from each volume's intensities")]
        bool customTransferFunction;

        [SerializeField, Tooltip("Opacity by intensity, straight lines between the points")]
        List<TransferFunctionPoint> transferFunction = new List<TransferFunctionPoint>();

        [SerializeField, Tooltip("Segments that look other than the volume says")]
        List<SegmentAppearance> segments = new List<SegmentAppearance>();

        [NonSerialized] OpacityTransferFunction function;
        [NonSerialized] SegmentTable applied, appliedTo;
        [NonSerialized] TransferFunctionPoint[] functionsPoints = Array.Empty<TransferFunctionPoint>();
        [NonSerialized] SegmentAppearance[] appliedSegments = Array.Empty<SegmentAppearance>();

        /// <summary>Opacity by intensity; null = chosen from each volume's intensities.</summary>
        public OpacityTransferFunction TransferFunction
        {
            get
            {
                if (!customTransferFunction || transferFunction.Count == 0)
                    return null;
                if (function == null)
                {
                    functionsPoints = transferFunction.ToArray();
                    function = new OpacityTransferFunction(functionsPoints.Select(p => new TransferPoint(p.value, p.opacity)));
                }
                return function;
            }
            set
            {
                customTransferFunction = value != null;
                transferFunction.Clear();
                if (value != null)
                    foreach (TransferPoint point in value.Points)
                        transferFunction.Add(new TransferFunctionPoint { value = (float)point.Value, opacity = (float)point.Opacity });
                function = value;
                functionsPoints = transferFunction.ToArray();
            }
        }

        /// <summary>The segments that look other than the volume says, in no order.</summary>
        public IReadOnlyList<SegmentAppearance> Segments => segments;

        /// <summary>Makes a segment look other than the volume says.</summary>
        public void SetSegment(SegmentAppearance appearance)
        {
            int known = segments.FindIndex(s => s.Label == appearance.Label);
            if (known < 0)
                segments.Add(appearance);
            else
                segments[known] = appearance;
            Invalidate();
        }

        /// <summary>Lets a segment look as the volume says.</summary>
        /// <returns>Whether it looked otherwise.</returns>
        public bool ResetSegment(long label)
        {
            int removed = segments.RemoveAll(s => s.Label == label);
            Invalidate();
            return removed > 0;
        }

        /// <summary>Lets all segments look as the volume says.</summary>
        public void ResetSegments()
        {
            segments.Clear();
            Invalidate();
        }

        /// <summary>A volume's table as it is to be shown. The same object until something changes.</summary>
        internal SegmentTable Apply(SegmentTable table)
        {
            if (table == null || segments.Count == 0)
                return table;
            if (appliedTo != table || applied == null)
            {
                appliedTo = table;
                appliedSegments = segments.ToArray();
                applied = table.With(segments.Select(s => (s.Label, ToSegmentColor(s.Color), s.Opacity)));
            }
            return applied;
        }

        /// <summary>
        /// Called when fields may have been changed from outside, by the Inspector or by undo. What did not change stays the same object: another one would
        /// have the whole volume computed anew.
        /// </summary>
        internal void Invalidate()
        {
            if (!transferFunction.SequenceEqual(functionsPoints))
                function = null;
            if (!segments.SequenceEqual(appliedSegments))
                applied = appliedTo = null;
        }

        internal void Clamp()
        {
            for (int p = 0; p < transferFunction.Count; p++)
            {
                TransferFunctionPoint point = transferFunction[p];
                point.value = float.IsNaN(point.value) || float.IsInfinity(point.value) ? 0f : point.value;
                point.opacity = point.opacity >= 0f ? Mathf.Min(point.opacity, 1f) : 0f;
                transferFunction[p] = point;
            }
            for (int s = 0; s < segments.Count; s++)
                segments[s] = new SegmentAppearance(segments[s].Label, segments[s].Color, segments[s].Opacity >= 0f ? Mathf.Min(segments[s].Opacity, 1f) : 0f);
            Invalidate();
        }

        static SegmentColor ToSegmentColor(Color color) => SegmentColor.FromFloats(color.r, color.g, color.b);
    }
}
