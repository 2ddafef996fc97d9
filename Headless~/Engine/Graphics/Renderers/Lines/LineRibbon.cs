using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>How a line looks.</summary>
    struct LineShape
    {
        internal AnimationCurve Width;
        internal float WidthScale;
        internal Gradient Color;
        internal LineTextureMode TextureMode;
        internal Vector2 TextureScale;
        internal int CornerVertices;
        internal int CapVertices;
        internal bool Loop;

        /// <summary>Half the width at a place from 0 to 1 along the line.</summary>
        internal readonly float HalfWidth(float at) => Mathf.Abs(Width.Evaluate(at) * WidthScale) / 2f;
    }

    /// <summary>What a line's face is turned to: a point, or a direction that leads to it.</summary>
    readonly struct LineFacing
    {
        internal LineFacing(Vector3 toViewer, Vector3? viewer)
        {
            ToViewer = toViewer;
            Viewer = viewer;
        }

        internal readonly Vector3 ToViewer;
        internal readonly Vector3? Viewer;

        internal Vector3 At(Vector3 point) => Viewer is { } viewer ? viewer - point : ToViewer;
    }

    /// <summary>A line as a strip of triangles: pairs of vertices on both sides of it.</summary>
    sealed class LineRibbon
    {
        readonly List<Vector3> m_Positions = new();
        readonly List<Vector3> m_Normals = new();
        readonly List<Color> m_Colors = new();
        readonly List<Vector2> m_Coordinates = new();
        readonly List<int> m_Indices = new();
        readonly LineShape m_Shape;
        readonly LineFacing m_Facing;
        readonly List<Vector3> m_Points;
        readonly float[] m_Lengths;

        LineRibbon(IReadOnlyList<Vector3> points, in LineShape shape, in LineFacing facing)
        {
            (m_Shape, m_Facing) = (shape, facing);
            m_Points = new List<Vector3>(points);
            if (shape.Loop)
                m_Points.Add(points[0]);
            m_Lengths = new float[m_Points.Count];
            for (var i = 1; i < m_Points.Count; i++)
                m_Lengths[i] = m_Lengths[i - 1] + (m_Points[i] - m_Points[i - 1]).magnitude;
        }

        /// <summary>Writes the strip into a mesh; fewer than two points make nothing.</summary>
        internal static void Build(Mesh mesh, IReadOnlyList<Vector3> points, in LineShape shape, in LineFacing facing)
        {
            mesh.Clear();
            if (points.Count < 2)
                return;
            var ribbon = new LineRibbon(points, shape, facing);
            ribbon.Run();
            mesh.indexFormat = ribbon.m_Positions.Count > ushort.MaxValue ? IndexFormat.UInt32 : IndexFormat.UInt16;
            mesh.SetVertices(ribbon.m_Positions);
            mesh.SetNormals(ribbon.m_Normals);
            mesh.SetColors(ribbon.m_Colors);
            mesh.SetUVs(0, ribbon.m_Coordinates);
            mesh.SetIndices(ribbon.m_Indices, MeshTopology.Triangles, 0);
        }

        float Total => m_Lengths[m_Lengths.Length - 1];

        void Run()
        {
            var last = m_Points.Count - 1;
            if (!m_Shape.Loop)
                Cap(0, -Direction(0), true);
            for (var i = 0; i <= last; i++)
            {
                var before = i > 0 ? Direction(i - 1) : m_Shape.Loop ? Direction(last - 1) : Direction(0);
                var after = i < last ? Direction(i) : m_Shape.Loop ? Direction(0) : before;
                Corner(i, before, after);
            }
            if (!m_Shape.Loop)
                Cap(last, Direction(last - 1), false);
        }

        void Corner(int i, Vector3 before, Vector3 after)
        {
            var isStraight = Vector3.Dot(before, after) > 0.9999f;
            if (isStraight || m_Shape.CornerVertices == 0)
            {
                var mean = (before + after).normalized;
                // A mitre is longer, but not without end where the line turns back.
                var stretch = Mathf.Min(1f / Mathf.Max(Vector3.Dot(mean, after), 0.1f), 4f);
                Pair(i, m_Points[i], mean == Vector3.zero ? after : mean, isStraight ? 1f : stretch);
                return;
            }
            for (var k = 0; k <= m_Shape.CornerVertices; k++)
                Pair(i, m_Points[i], Vector3.Slerp(before, after, (float)k / m_Shape.CornerVertices), 1f);
        }

        /// <summary>Half a disc beyond an end, from its tip inwards or the other way round.</summary>
        void Cap(int i, Vector3 outwards, bool fromTip)
        {
            var count = m_Shape.CapVertices;
            var along = fromTip ? -outwards : outwards;
            var radius = m_Shape.HalfWidth(At(i));
            for (var k = 0; k < count; k++)
            {
                var step = fromTip ? k : count - 1 - k;
                var angle = Mathf.PI / 2f * step / count;
                Pair(i, m_Points[i] + outwards * (radius * Mathf.Cos(angle)), along, Mathf.Sin(angle));
            }
        }

        void Pair(int i, Vector3 centre, Vector3 along, float widthScale)
        {
            var toViewer = m_Facing.At(centre);
            var side = Vector3.Cross(along, toViewer).normalized;
            var at = At(i);
            var half = side * (m_Shape.HalfWidth(at) * widthScale);
            // Colours of vertices are those that shaders see.
            var color = ColorSpaces.ToShader(m_Shape.Color.Evaluate(at));
            var u = Coordinate(i, at) * m_Shape.TextureScale.x;
            for (var k = 0; k < 2; k++)
            {
                m_Positions.Add(k == 0 ? centre - half : centre + half);
                m_Normals.Add(Vector3.Cross(side, along).normalized);
                m_Colors.Add(color);
                m_Coordinates.Add(new Vector2(u, k * m_Shape.TextureScale.y));
            }
            var n = m_Positions.Count;
            if (n >= 4)
                m_Indices.AddRange(new[] { n - 4, n - 3, n - 2, n - 2, n - 3, n - 1 });
        }

        float Coordinate(int i, float at) => m_Shape.TextureMode switch
        {
            LineTextureMode.Tile => m_Lengths[i],
            LineTextureMode.DistributePerSegment => (float)i / (m_Points.Count - 1),
            LineTextureMode.RepeatPerSegment => i,
            _ => at,
        };

        float At(int i) => Total > 0f ? m_Lengths[i] / Total : (float)i / (m_Points.Count - 1);

        /// <summary>Of a segment; one without length has that of a neighbour.</summary>
        Vector3 Direction(int segment)
        {
            for (var distance = 0; distance < m_Points.Count; distance++)
                foreach (var k in new[] { segment + distance, segment - distance })
                    if (k >= 0 && k < m_Points.Count - 1 && m_Points[k + 1] != m_Points[k])
                        return (m_Points[k + 1] - m_Points[k]).normalized;
            return Vector3.forward;
        }
    }
}
