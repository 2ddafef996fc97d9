using System;
using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>Paints a transfer function over its volume's histogram.</summary>
    sealed class TransferFunctionPainter : IDisposable
    {
        const float LineWidth = 2.5f, PointSize = 7f, SelectedSize = 11f, LabelHeight = 14f;

        /// <summary>Behind plots and previews.</summary>
        public static readonly Color Background = new Color(0.16f, 0.16f, 0.16f);

        static readonly Color Grid = new Color(1f, 1f, 1f, 0.12f), Frame = new Color(0.35f, 0.6f, 1f);
        static readonly Color LineColor = new Color(1f, 0.85f, 0.4f), PointColor = Color.white, SelectedColor = new Color(1f, 0.55f, 0.1f);

        readonly HistogramTexture texture = new HistogramTexture();
        Vector3[] line;
        string leftText = "", rightText = "";
        ValueWindow named;
        GUIStyle left, right;

        public void Paint(TransferFunctionPlot plot, OpacityTransferFunction function, IntensityHistogram histogram, int selected, bool focused)
        {
            Rect area = plot.Area;
            EditorGUI.DrawRect(area, Background);
            if (histogram != null)
            {
                var seen = new ValueWindow(plot.ValueAt(area.xMin), plot.ValueAt(area.xMax));
                GUI.DrawTexture(area, texture.Of(histogram, seen, (int)area.width), ScaleMode.StretchToFill, true);
            }
            PaintGrid(plot);
            using (new Handles.DrawingScope(LineColor))
                Handles.DrawAAPolyLine(LineWidth, plot.Line(function, ref line), line);
            for (int p = 0; p < function.Points.Count; p++)
                if (plot.Shows(function.Points[p].Value))
                    PaintPoint(plot.ToPixels(function.Points[p].Value, function.Points[p].Opacity), p == selected);
            PaintNumbers(plot);
            if (focused)
                EditorGUI.DrawRect(new Rect(area.x, area.yMax - 1f, area.width, 1f), Frame);
        }

        public void Dispose() => texture.Dispose();

        static void PaintGrid(TransferFunctionPlot plot)
        {
            for (int quarter = 0; quarter <= 4; quarter++)
                EditorGUI.DrawRect(new Rect(plot.Area.x, plot.YOf(0.25 * quarter), plot.Area.width, 1f), Grid);
        }

        static void PaintPoint(Vector2 centre, bool isSelected)
        {
            if (isSelected)
                EditorGUI.DrawRect(Square(centre, SelectedSize), SelectedColor);
            EditorGUI.DrawRect(Square(centre, PointSize), PointColor);
        }

        static Rect Square(Vector2 centre, float size) => new Rect(centre.x - 0.5f * size, centre.y - 0.5f * size, size, size);

        void PaintNumbers(TransferFunctionPlot plot)
        {
            left ??= new GUIStyle(EditorStyles.whiteMiniLabel) { alignment = TextAnchor.UpperLeft };
            right ??= new GUIStyle(EditorStyles.whiteMiniLabel) { alignment = TextAnchor.UpperRight };
            if (!plot.Window.Equals(named))
            {
                named = plot.Window;
                leftText = FormattableString.Invariant($"{named.Min:0.##}");
                rightText = FormattableString.Invariant($"{named.Max:0.##}");
            }
            var row = new Rect(plot.Area.x, plot.Area.y, plot.Area.width, LabelHeight);
            GUI.Label(row, leftText, left);
            GUI.Label(row, rightText, right);
        }
    }
}
