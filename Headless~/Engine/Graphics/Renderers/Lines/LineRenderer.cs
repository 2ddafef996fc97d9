using System;
using Unity.Collections;

namespace UnityEngine
{
    /// <summary>A line through points as a flat band that is turned to the camera.</summary>
    public sealed class LineRenderer : Renderer
    {
        Vector3[] m_Positions = { Vector3.zero, Vector3.forward };
        AnimationCurve m_Width = new(new Keyframe(0f, 1f));
        Gradient m_Color = new();
        Mesh m_Mesh;

        public LineRenderer()
        {
        }

        /// <summary>New ones are the origin.</summary>
        public int positionCount
        {
            get => m_Positions.Length;
            set
            {
                if (value < 0)
                    throw new ArgumentOutOfRangeException(nameof(value), value, "positionCount is 0 or more");
                Array.Resize(ref m_Positions, value);
            }
        }

        /// <summary>Whether positions are of the world, or of the transform.</summary>
        public bool useWorldSpace { get; set; } = true;

        public bool loop { get; set; }

        public LineAlignment alignment { get; set; } = LineAlignment.View;

        public LineTextureMode textureMode { get; set; } = LineTextureMode.Stretch;

        public Vector2 textureScale { get; set; } = Vector2.one;

        public int numCornerVertices { get; set; }

        public int numCapVertices { get; set; }

        public bool generateLightingData { get; set; }

        public float shadowBias { get; set; } = 0.5f;

        public float widthMultiplier { get; set; } = 1f;

        /// <summary>Widths along the line; a copy.</summary>
        public AnimationCurve widthCurve
        {
            get { var copy = new AnimationCurve(); copy.CopyFrom(m_Width); return copy; }
            set => m_Width.CopyFrom(value ?? throw new ArgumentNullException(nameof(value)));
        }

        public float startWidth { get => m_Width.Evaluate(0f) * widthMultiplier; set => SetWidths(value, endWidth); }

        public float endWidth { get => m_Width.Evaluate(1f) * widthMultiplier; set => SetWidths(startWidth, value); }

        /// <summary>Colours along the line; a copy.</summary>
        public Gradient colorGradient
        {
            get => Copy(m_Color);
            set => m_Color = Copy(value ?? throw new ArgumentNullException(nameof(value)));
        }

        public Color startColor { get => m_Color.Evaluate(0f); set => SetColors(value, endColor); }

        public Color endColor { get => m_Color.Evaluate(1f); set => SetColors(startColor, value); }

        public void SetPosition(int index, Vector3 position)
        {
            Use("SetPosition");
            m_Positions[Checked(index)] = position;
        }

        public Vector3 GetPosition(int index)
        {
            Use("GetPosition");
            return m_Positions[Checked(index)];
        }

        /// <summary>As many as <see cref="positionCount"/> says; further ones are ignored.</summary>
        public void SetPositions(Vector3[] positions)
        {
            Use("SetPositions");
            if (positions == null)
                throw new ArgumentNullException(nameof(positions));
            Array.Copy(positions, m_Positions, Math.Min(positions.Length, m_Positions.Length));
        }

        public void SetPositions(NativeArray<Vector3> positions) => SetPositions(positions.ToArray());

        /// <returns>How many were written.</returns>
        public int GetPositions(Vector3[] positions)
        {
            Use("GetPositions");
            if (positions == null)
                throw new ArgumentNullException(nameof(positions));
            var count = Math.Min(positions.Length, m_Positions.Length);
            Array.Copy(m_Positions, positions, count);
            return count;
        }

        /// <summary>The band as a camera sees it, in the line's own space.</summary>
        /// <param name="mesh">Gets the vertices.</param>
        /// <param name="camera">Who looks.</param>
        /// <param name="useTransform">Whether the mesh will be drawn with the line's transform.</param>
        public void BakeMesh(Mesh mesh, Camera camera, bool useTransform = false)
        {
            Use("BakeMesh");
            if (mesh == null)
                throw new ArgumentNullException(nameof(mesh));
            LineRibbon.Build(mesh, WorldPoints(), Shape, FacingTo(camera));
            if (!useTransform)
                return;
            mesh.vertices = Array.ConvertAll(mesh.vertices, v => worldToLocalMatrix.MultiplyPoint3x4(v));
            mesh.RecalculateBounds();
        }

        public void BakeMesh(Mesh mesh, bool useTransform = false) => BakeMesh(mesh, Camera.main, useTransform);

        internal override Mesh MeshFor(Camera camera)
        {
            if (m_Mesh is null)
            {
                m_Mesh = new Mesh { name = "Line" };
                ObjectRegistry.Remove(m_Mesh);
            }
            LineRibbon.Build(m_Mesh, WorldPoints(), Shape, FacingTo(camera));
            return m_Mesh;
        }

        // The band is made of places in the world.
        internal override Matrix4x4 MeshToWorld => Matrix4x4.identity;

        internal override Bounds OwnBounds => MeshMath.Transform(worldToLocalMatrix, OwnWorldBounds);

        internal override Bounds OwnWorldBounds
        {
            get
            {
                var points = WorldPoints();
                if (points.Length == 0)
                    return new Bounds(transform.position, Vector3.zero);
                var box = new Bounds(points[0], Vector3.zero);
                foreach (var point in points)
                    box.Encapsulate(point);
                var widest = 0f;
                foreach (var key in m_Width.keys)
                    widest = Mathf.Max(widest, Mathf.Abs(key.value * widthMultiplier));
                box.Expand(widest);
                return box;
            }
        }

        internal override void OnNativeDestroy()
        {
            base.OnNativeDestroy();
            m_Mesh?.Kill();
            m_Mesh = null;
        }

        internal override void CopyNativeState(Component source, Func<Object, Object> remap)
        {
            base.CopyNativeState(source, remap);
            var other = (LineRenderer)source;
            (m_Positions, m_Width, m_Color) = ((Vector3[])other.m_Positions.Clone(), other.widthCurve, other.colorGradient);
            (useWorldSpace, loop, alignment, textureMode, textureScale) =
                (other.useWorldSpace, other.loop, other.alignment, other.textureMode, other.textureScale);
            (numCornerVertices, numCapVertices, generateLightingData, shadowBias, widthMultiplier) =
                (other.numCornerVertices, other.numCapVertices, other.generateLightingData, other.shadowBias, other.widthMultiplier);
        }

        LineShape Shape => new()
        {
            Width = m_Width,
            WidthScale = widthMultiplier,
            Color = m_Color,
            TextureMode = textureMode,
            TextureScale = textureScale,
            CornerVertices = numCornerVertices,
            CapVertices = numCapVertices,
            Loop = loop && m_Positions.Length > 2,
        };

        Vector3[] WorldPoints() => useWorldSpace ? m_Positions : Array.ConvertAll(m_Positions, p => transform.TransformPoint(p));

        LineFacing FacingTo(Camera camera)
        {
            if (alignment == LineAlignment.TransformZ || camera == null)
                return new LineFacing(-transform.forward, null);
            return camera.orthographic ? new LineFacing(-camera.transform.forward, null) : new LineFacing(default, camera.transform.position);
        }

        void SetWidths(float start, float end)
        {
            var scale = widthMultiplier != 0f ? widthMultiplier : 1f;
            m_Width = start == end ? new AnimationCurve(new Keyframe(0f, start / scale)) : AnimationCurve.Linear(0f, start / scale, 1f, end / scale);
        }

        void SetColors(Color start, Color end) => m_Color.SetKeys(
            new[] { new GradientColorKey(start, 0f), new GradientColorKey(end, 1f) },
            new[] { new GradientAlphaKey(start.a, 0f), new GradientAlphaKey(end.a, 1f) });

        int Checked(int index) => index >= 0 && index < m_Positions.Length ? index
            : throw new IndexOutOfRangeException($"The line has {m_Positions.Length} positions, not one of index {index}");

        static Gradient Copy(Gradient gradient)
        {
            var copy = new Gradient { mode = gradient.mode, colorSpace = gradient.colorSpace };
            copy.SetKeys(gradient.colorKeys, gradient.alphaKeys);
            return copy;
        }
    }
}
