using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Editor
{
    /// <summary>The points of a transfer function while they are edited: ascending by value, one at least. Values are floats, as scenes save them.</summary>
    sealed class TransferPoints
    {
        readonly List<TransferPoint> points = new List<TransferPoint> { new TransferPoint(0, 1) };
        OpacityTransferFunction function;

        /// <summary>The points, ascending by value.</summary>
        public IReadOnlyList<TransferPoint> Points => points;

        public int Count => points.Count;

        public TransferPoint this[int index] => points[index];

        /// <summary>The function that the points make. The same object until something changes.</summary>
        public OpacityTransferFunction Function => function ??= new OpacityTransferFunction(points);

        /// <summary>Takes another function's points.</summary>
        public void Set(OpacityTransferFunction source)
        {
            points.Clear();
            foreach (TransferPoint point in source.Points)
                points.Add(Point(point.Value, point.Opacity));
            function = null;
        }

        /// <summary>Moves a point, as a drag does: not past its neighbours, so that two points of one value stay a step.</summary>
        public void Drag(int index, double value, double opacity)
        {
            double lowest = index > 0 ? points[index - 1].Value : -float.MaxValue;
            double highest = index < points.Count - 1 ? points[index + 1].Value : float.MaxValue;
            points[index] = Point(Math.Max(lowest, Math.Min(value, highest)), opacity);
            function = null;
        }

        /// <summary>Puts a point where a number says, past its neighbours if need be.</summary>
        /// <returns>Its new index.</returns>
        public int Place(int index, double value, double opacity)
        {
            points.RemoveAt(index);
            return Add(value, opacity);
        }

        /// <summary>Adds a point; behind those of the same value.</summary>
        /// <returns>Its index.</returns>
        public int Add(double value, double opacity)
        {
            TransferPoint point = Point(value, opacity);
            int index = points.Count;
            while (index > 0 && points[index - 1].Value > point.Value)
                index--;
            points.Insert(index, point);
            function = null;
            return index;
        }

        /// <summary>Removes a point; the last one stays.</summary>
        /// <returns>Whether it went.</returns>
        public bool Remove(int index)
        {
            if (index < 0 || index >= points.Count || points.Count == 1)
                return false;
            points.RemoveAt(index);
            function = null;
            return true;
        }

        /// <summary>A point that can be saved: a finite float and an opacity of 0 to 1; NaN counts as 0.</summary>
        static TransferPoint Point(double value, double opacity)
        {
            double finite = double.IsNaN(value) ? 0 : Math.Max(-float.MaxValue, Math.Min(value, float.MaxValue));
            return new TransferPoint((float)finite, (float)(opacity >= 0 ? Math.Min(opacity, 1) : 0));
        }
    }
}
