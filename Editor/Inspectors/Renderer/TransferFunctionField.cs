using System;
using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// A plot of a transfer function in which its points are edited: dragged, added by a double click, removed by a right click or the Delete key, nudged
    /// by the arrows (Shift: ten times as far). The wheel zooms once the plot was clicked, or with Ctrl; the middle button, or Alt, pans; F shows all.
    /// </summary>
    sealed class TransferFunctionField : IDisposable
    {
        const float Height = 150f;
        const double ZoomPerStep = 1.08, OpacityStep = 0.01, Coarse = 10;

        static readonly int Hint = "AnatomyCarve.TransferFunctionField".GetHashCode();

        readonly TransferFunctionPainter painter = new TransferFunctionPainter();
        ValueWindow window, widest;
        object fittedTo;
        bool isFitted, panning;
        Vector2 grabbed;
        int selected = -1;

        /// <summary>The point whose numbers are edited; -1 = none.</summary>
        public int Selected { get => selected; set => selected = value; }

        /// <summary>Shows all values that the volume has, or else all points, when it is drawn next.</summary>
        public void Fit() => isFitted = false;

        /// <summary>Says which values there are to look at; the view stays where it is for the same volume.</summary>
        /// <param name="source">The volume; null = none.</param>
        /// <param name="data">The values that the volume has, or else those of the points.</param>
        /// <param name="all">The values that can be looked at beside them.</param>
        public void SetRange(object source, ValueWindow data, ValueWindow all)
        {
            widest = all.United(data);
            window = (isFitted && source == fittedTo ? window : data).Within(widest);
            isFitted = true;
            fittedTo = source;
        }

        /// <summary>Draws the plot and edits the points.</summary>
        /// <returns>Whether a point was edited.</returns>
        public bool Draw(TransferPoints points, IntensityHistogram histogram)
        {
            Rect area = EditorGUILayout.GetControlRect(false, Height);
            int id = GUIUtility.GetControlID(Hint, FocusType.Keyboard, area);
            selected = Mathf.Min(selected, points.Count - 1);
            var plot = new TransferFunctionPlot(area, window);
            Event e = Event.current;
            bool over = area.Contains(e.mousePosition), mine = GUIUtility.hotControl == id, focused = GUIUtility.keyboardControl == id;
            switch (e.GetTypeForControl(id))
            {
                case EventType.Repaint:
                    painter.Paint(plot, points.Function, histogram, selected, focused);
                    return false;
                case EventType.MouseDown when over && GUI.enabled:
                    return Press(e, id, plot, points);
                case EventType.MouseDrag when mine:
                    return Drag(e, plot, points);
                case EventType.MouseUp when mine:
                    GUIUtility.hotControl = 0;
                    e.Use();
                    return false;
                case EventType.ContextClick when over:
                    e.Use(); // a right click has removed a point
                    return false;
                case EventType.ScrollWheel when over && (focused || EditorGUI.actionKey):
                    window = window.Zoomed(Math.Pow(ZoomPerStep, e.delta.x + e.delta.y), plot.ValueAt(e.mousePosition.x), widest);
                    e.Use();
                    return false;
                case EventType.KeyDown when focused && GUI.enabled:
                    return PressKey(e, plot, points);
                case EventType.ValidateCommand when focused && IsDelete(e):
                    e.Use();
                    return false;
                case EventType.ExecuteCommand when focused && IsDelete(e) && GUI.enabled:
                    return Remove(e, points, selected);
                default:
                    return false;
            }
        }

        public void Dispose() => painter.Dispose();

        bool Press(Event e, int id, TransferFunctionPlot plot, TransferPoints points)
        {
            GUIUtility.keyboardControl = id;
            int hit = plot.HitTest(points.Points, e.mousePosition);
            if (e.button == 1)
                return Remove(e, points, hit);
            panning = e.button == 2 || e.alt;
            bool added = !panning && hit < 0 && e.clickCount == 2;
            if (added)
                hit = points.Add(plot.ValueAt(e.mousePosition.x), plot.OpacityAt(e.mousePosition.y));
            if (!panning)
                selected = hit;
            if (panning || hit >= 0)
                GUIUtility.hotControl = id;
            grabbed = panning || hit < 0 ? Vector2.zero : e.mousePosition - plot.ToPixels(points[hit].Value, points[hit].Opacity);
            e.Use();
            return added;
        }

        bool Drag(Event e, TransferFunctionPlot plot, TransferPoints points)
        {
            bool moves = !panning && selected >= 0;
            if (moves)
                points.Drag(selected, plot.ValueAt(e.mousePosition.x - grabbed.x), plot.OpacityAt(e.mousePosition.y - grabbed.y));
            else
                window = window.Panned(-e.delta.x * plot.ValuePerPixel, widest);
            e.Use();
            return moves;
        }

        bool PressKey(Event e, TransferFunctionPlot plot, TransferPoints points)
        {
            double steps = e.shift ? Coarse : 1;
            switch (e.keyCode)
            {
                case KeyCode.LeftArrow: return Nudge(e, points, -steps * plot.ValuePerPixel, 0);
                case KeyCode.RightArrow: return Nudge(e, points, steps * plot.ValuePerPixel, 0);
                case KeyCode.DownArrow: return Nudge(e, points, 0, -steps * OpacityStep);
                case KeyCode.UpArrow: return Nudge(e, points, 0, steps * OpacityStep);
                case KeyCode.Delete:
                case KeyCode.Backspace:
                    return Remove(e, points, selected);
                case KeyCode.F:
                    Fit();
                    e.Use();
                    return false;
                default:
                    return false;
            }
        }

        bool Nudge(Event e, TransferPoints points, double value, double opacity)
        {
            if (selected < 0)
                return false;
            points.Drag(selected, points[selected].Value + value, points[selected].Opacity + opacity);
            e.Use();
            return true;
        }

        bool Remove(Event e, TransferPoints points, int index)
        {
            e.Use();
            bool removed = points.Remove(index);
            if (removed)
                selected = -1;
            return removed;
        }

        static bool IsDelete(Event e) => e.commandName == "Delete" || e.commandName == "SoftDelete";
    }
}
