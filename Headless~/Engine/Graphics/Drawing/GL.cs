namespace UnityEngine
{
    /// <summary>Drawing at a low level.</summary>
    public sealed class GL
    {
        public const int TRIANGLES = 4;

        public const int TRIANGLE_STRIP = 5;

        public const int QUADS = 7;

        public const int LINES = 1;

        public const int LINE_STRIP = 2;

        /// <summary>Whether back faces count as front faces.</summary>
        public static bool invertCulling
        {
            get => DrawTargets.InvertCulling;
            set { MainThread.Check("set_invertCulling"); DrawTargets.InvertCulling = value; }
        }

        /// <summary>Whether colours become sRGB as they are written into an sRGB target; a target that is set switches it on in linear projects.</summary>
        public static bool sRGBWrite
        {
            get => DrawTargets.WritesSRGB;
            set { MainThread.Check("set_sRGBWrite"); DrawTargets.WritesSRGB = value; }
        }

        /// <summary>The view matrix of Graphics.DrawMeshNow.</summary>
        public static Matrix4x4 modelview
        {
            get => ImmediateDrawing.View;
            set { MainThread.Check("set_modelview"); ImmediateDrawing.View = value; }
        }

        public static void LoadIdentity() => modelview = Matrix4x4.identity;

        public static void MultMatrix(Matrix4x4 m) => modelview *= m;

        /// <summary>A parallel projection of x and y from 0 to 1.</summary>
        public static void LoadOrtho()
        {
            LoadIdentity();
            LoadProjectionMatrix(Matrix4x4.Ortho(0, 1, 0, 1, -1, 100));
        }

        /// <summary>A parallel projection of pixels, the lower left corner at 0, 0.</summary>
        public static void LoadPixelMatrix() => LoadPixelMatrix(0, DrawTargets.Width, 0, DrawTargets.Height);

        public static void LoadPixelMatrix(float left, float right, float bottom, float top)
        {
            LoadIdentity();
            LoadProjectionMatrix(Matrix4x4.Ortho(left, right, bottom, top, -1, 100));
        }

        public static void LoadProjectionMatrix(Matrix4x4 mat)
        {
            MainThread.Check("LoadProjectionMatrix");
            ImmediateDrawing.Projection = mat;
        }

        public static void PushMatrix() => ImmediateDrawing.Push();

        public static void PopMatrix() => ImmediateDrawing.Pop();

        /// <summary>Restricts drawing to a part of the target; pixels from the lower left.</summary>
        public static void Viewport(Rect pixelRect)
        {
            MainThread.Check("Viewport");
            DrawTargets.Viewport = pixelRect;
        }

        public static void Clear(bool clearDepth, bool clearColor, Color backgroundColor) => Clear(clearDepth, clearColor, backgroundColor, 1f);

        /// <summary>Clears the present target, within the viewport. The colour is in the project's colour space as shaders see it.</summary>
        /// <param name="clearDepth">Depth and stencil too.</param>
        /// <param name="clearColor">The colour.</param>
        /// <param name="backgroundColor">To this.</param>
        /// <param name="depth">1 is far, whatever the API makes of it.</param>
        public static void Clear(bool clearDepth, bool clearColor, Color backgroundColor, float depth)
        {
            MainThread.Check("GL.Clear");
            DrawTargets.Clear(clearColor, clearDepth, clearDepth, backgroundColor, depth, 0);
        }

        public static void Flush()
        {
            MainThread.Check("GL.Flush");
            if (Gpu.IsStarted)
                Gpu.Context.Stream.Submit();
        }

        /// <summary>
        /// A camera's projection as this API wants it: depth from 1 (near) to 0 (far), and turned over when drawing into a texture, whose first row is
        /// the bottom of the picture.
        /// </summary>
        public static Matrix4x4 GetGPUProjectionMatrix(Matrix4x4 proj, bool renderIntoTexture)
        {
            var m = proj;
            // z from -1..1 to 1..0: z' = (w - z) / 2.
            m.m20 = (proj.m30 - proj.m20) * 0.5f;
            m.m21 = (proj.m31 - proj.m21) * 0.5f;
            m.m22 = (proj.m32 - proj.m22) * 0.5f;
            m.m23 = (proj.m33 - proj.m23) * 0.5f;
            if (!renderIntoTexture)
                return m;
            (m.m10, m.m11, m.m12, m.m13) = (-m.m10, -m.m11, -m.m12, -m.m13);
            return m;
        }
    }
}
