using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>A picture that a camera draws in one go: of no eye in particular, of one, or of both.</summary>
    sealed class CameraPicture
    {
        static readonly EyeView s_None = new(Matrix4x4.identity, Matrix4x4.identity);

        readonly bool m_InHeadset;
        readonly int m_Slice;
        readonly StereoDrawing m_Stereo;
        readonly EyeView m_Left;
        readonly EyeView m_Right;

        CameraPicture(Camera camera, Camera.MonoOrStereoscopicEye eye)
        {
            (Camera, Eye, m_InHeadset) = (camera, eye, eye != Camera.MonoOrStereoscopicEye.Mono);
            m_Slice = eye == Camera.MonoOrStereoscopicEye.Right ? 1 : 0;
            (m_Left, m_Right) = (camera.View(eye), s_None);
        }

        CameraPicture(Camera camera, StereoDrawing stereo)
        {
            (Camera, Eye, m_InHeadset, m_Slice, m_Stereo) = (camera, Camera.MonoOrStereoscopicEye.Left, true, DrawTargets.AllSlices, stereo);
            (m_Left, m_Right) = (camera.View(Camera.MonoOrStereoscopicEye.Left), camera.View(Camera.MonoOrStereoscopicEye.Right));
        }

        internal Camera Camera { get; }

        /// <summary>Of a picture of both the left one, as Unity says.</summary>
        internal Camera.MonoOrStereoscopicEye Eye { get; }

        /// <summary>Null for the screen.</summary>
        internal RenderTexture Target => m_InHeadset ? Headset.Eyes : Camera.targetTexture != null ? Camera.targetTexture : null;

        internal bool IsOfBothEyes => m_Stereo != StereoDrawing.None;

        /// <summary>The pictures that make up what a camera shows.</summary>
        internal static IReadOnlyList<CameraPicture> Of(Camera camera)
        {
            if (!camera.stereoEnabled)
                return new[] { new CameraPicture(camera, Camera.MonoOrStereoscopicEye.Mono) };
            var mask = camera.stereoTargetEye;
            if (mask == StereoTargetEyeMask.Both && Headset.Mode != StereoMode.MultiPass)
                return new[] { new CameraPicture(camera, Headset.Mode == StereoMode.Multiview ? StereoDrawing.Multiview : StereoDrawing.Instanced) };
            var pictures = new List<CameraPicture>(2);
            if ((mask & StereoTargetEyeMask.Left) != 0)
                pictures.Add(new CameraPicture(camera, Camera.MonoOrStereoscopicEye.Left));
            if ((mask & StereoTargetEyeMask.Right) != 0)
                pictures.Add(new CameraPicture(camera, Camera.MonoOrStereoscopicEye.Right));
            return pictures;
        }

        /// <summary>Sets target, viewport and matrices of all that follows, until <see cref="End"/>.</summary>
        internal void Begin()
        {
            Begin(Target, m_Slice);
            DrawTargets.Viewport = Camera.pixelRect;
        }

        /// <summary>The same for another texture, which the picture fills.</summary>
        internal void Begin(RenderTexture other) => Begin(other, IsOfBothEyes ? DrawTargets.AllSlices : 0);

        internal static void End() => Drawer.Stereo = StereoDrawing.None;

        internal void Clear()
        {
            var flags = Camera.clearFlags;
            if (flags == CameraClearFlags.Nothing)
                return;
            DrawTargets.Clear(ClearsColor(Camera), true, true, ColorSpaces.ToShader(Camera.backgroundColor), 1f, 0);
        }

        /// <summary>There is no skybox: the background stands for it.</summary>
        internal static bool ClearsColor(Camera camera) => camera.clearFlags is CameraClearFlags.Skybox or CameraClearFlags.SolidColor;

        internal static void Draw(IReadOnlyList<VisibleMesh> meshes, PassRules rules)
        {
            foreach (var mesh in meshes)
                rules.Draw(mesh.Item);
        }

        /// <summary>What shaders are told of the view.</summary>
        internal ViewSetup View => new()
        {
            Left = m_Left,
            Right = m_Right,
            IsStereo = IsOfBothEyes,
            CameraPosition = IsToldTheObjectsPlace ? Camera.transform.position : (Vector3?)null,
            EyeIndex = Eye == Camera.MonoOrStereoscopicEye.Right ? 1 : 0,
            Width = Camera.pixelWidth,
            Height = Camera.pixelHeight,
            Near = Camera.nearClipPlane,
            Far = Camera.farClipPlane,
            IsOrthographic = Camera.orthographic,
            OrthographicSize = new Vector2(Camera.orthographicSize * Camera.aspect, Camera.orthographicSize),
        };

        /// <summary>
        /// Whether shaders are told where the camera's GameObject is, though the view may be from elsewhere: so are a camera's that is no headset's, which may
        /// have a view matrix of its own, and in URP also a single eye's.
        /// </summary>
        bool IsToldTheObjectsPlace => !IsOfBothEyes && (!m_InHeadset || RenderPipelines.Asset != null);

        void Begin(RenderTexture target, int slice)
        {
            DrawTargets.Set(new[] { target }, target, 0, slice, m_Stereo == StereoDrawing.Multiview);
            Drawer.View = View;
            Drawer.Stereo = m_Stereo;
        }
    }
}
