using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// Where the points of a transfer function lie in a plot, in GUI pixels (y downwards): values to the right, opacity upwards. A margin inside
    /// the plot keeps points at its edges whole.
    /// </summary>
    readonly struct TransferFunctionPlot
    {
        /// <summary>Pixels between the plot's edges and the lines of opacity 0 and 1.</summary>
        public const float Margin = 6f;

        /// <summary>How near a click has to be to a point, pixels.</summary>
        const float Reach = 8f;

        readonly Rect inner;

        public TransferFunctionPlot(Rect area, ValueWindow window)
        {
            Area = area;
            Window = window;
            inner = new Rect(area.x + Margin, area.y + Margin, Mathf.Max(1f, area.width - 2f * Margin), Mathf.Max(1f, area.height - 2f * Margin));
        }

        public Rect Area { get; }

        public ValueWindow Window { get; }

        /// <summary>What a pixel to the right adds to the value.</summary>
        public double ValuePerPixel => Window.Width / inner.width;

        /// <summary>What a pixel upwards adds to the opacity.</summary>
        public double OpacityPerPixel => 1.0 / inner.height;

        public float XOf(double value) => inner.x + (float)(Window.FractionOf(value) * inner.width);

        public float YOf(double opacity) => inner.yMax - (float)(opacity * inner.height);

        public Vector2 ToPixels(double value, double opacity) => new Vector2(XOf(value), YOf(opacity));

        public double ValueAt(float x) => Window.ValueAt((x - inner.x) / inner.width);

        /// <summary>The opacity of a height, 0 to 1 whatever the height.</summary>
        public double OpacityAt(float y) => Mathf.Clamp01((inner.yMax - y) / inner.height);

        /// <summary>Whether a value lies between the plot's left and right edges.</summary>
        public bool Shows(double value)
        {
            float x = XOf(value);
            return x >= Area.xMin && x <= Area.xMax;
        }

        /// <summary>The point under the mouse, the nearest if there are several; -1 = none.</summary>
        public int HitTest(IReadOnlyList<TransferPoint> points, Vector2 mouse)
        {
            int nearest = -1;
            float nearestDistance = Reach;
            for (int p = 0; p < points.Count; p++)
            {
                if (!Shows(points[p].Value))
                    continue;
                float distance = Vector2.Distance(ToPixels(points[p].Value, points[p].Opacity), mouse);
                if (distance > nearestDistance)
                    continue;
                nearest = p;
                nearestDistance = distance;
            }
            return nearest;
        }

        /// <summary>The function's line from the plot's left edge to its right one.</summary>
        /// <param name="function">The function.</param>
        /// <param name="line">Takes the line's points; made longer if it is too short.</param>
        /// <returns>How many points the line has.</returns>
        public int Line(OpacityTransferFunction function, ref Vector3[] line)
        {
            IReadOnlyList<TransferPoint> points = function.Points;
            if (line == null || line.Length < points.Count + 2)
                Array.Resize(ref line, points.Count + 2);
            int count = 0;
            double left = ValueAt(Area.xMin), right = ValueAt(Area.xMax);
            line[count++] = new Vector3(Area.xMin, YOf(function.OpacityAt(left)));
            for (int p = 0; p < points.Count; p++)
                if (points[p].Value > left && points[p].Value < right)
                    line[count++] = ToPixels(points[p].Value, points[p].Opacity);
            line[count++] = new Vector3(Area.xMax, YOf(function.OpacityAt(right)));
            return count;
        }
    }
}
