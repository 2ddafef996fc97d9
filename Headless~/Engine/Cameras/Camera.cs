using System;

namespace UnityEngine
{
    /// <summary>What a camera is for.</summary>
    [Flags]
    public enum CameraType
    {
        Game = 1,
        SceneView = 2,
        Preview = 4,
        VR = 8,
        Reflection = 16,
    }

    /// <summary>What a camera clears before it draws.</summary>
    public enum CameraClearFlags
    {
        Skybox = 1,
        Color = 2,
        SolidColor = 2,
        Depth = 3,
        Nothing = 4,
    }

    /// <summary>A view of the scene. Looks along its transform's +z; its matrices follow OpenGL.</summary>
    public sealed partial class Camera : Behaviour
    {
        float m_FieldOfView = 60f;
        float m_Near = 0.3f;
        float m_Far = 1000f;
        float m_Size = 5f;
        float m_Depth;
        bool m_Orthographic;
        float? m_Aspect;
        Rect m_Rect = new(0f, 0f, 1f, 1f);
        RenderTexture m_Target;

        public Camera()
        {
        }

        /// <summary>Called for each camera, as it is about to cull, to draw, and when it is done.</summary>
        public delegate void CameraCallback(Camera cam);

        /// <summary>The eye that a projection is meant for.</summary>
        public enum MonoOrStereoscopicEye
        {
            Left = 0,
            Right = 1,
            Mono = 2,
        }

        /// <summary>The first enabled camera tagged MainCamera; null if there is none.</summary>
        public static Camera main
        {
            get { MainThread.Check("get_main"); return Cameras.Running.Find(c => c.Owner.tag == "MainCamera"); }
        }

        /// <summary>The camera that renders at this moment.</summary>
        public static Camera current { get; internal set; }

        public static int allCamerasCount => Cameras.Running.Count;

        public static Camera[] allCameras => Cameras.Running.ToArray();

        /// <summary>The vertical angle in degrees.</summary>
        public float fieldOfView { get => m_FieldOfView; set => m_FieldOfView = Mathf.Clamp(value, 1E-05f, 179f); }

        public float nearClipPlane { get => m_Near; set => m_Near = value; }

        public float farClipPlane { get => m_Far; set => m_Far = value; }

        public bool orthographic { get => m_Orthographic; set => m_Orthographic = value; }

        /// <summary>Half the height of a parallel projection, in world units.</summary>
        public float orthographicSize { get => m_Size; set => m_Size = value; }

        /// <summary>Width by height; follows the target until it is set.</summary>
        public float aspect { get => m_Aspect ?? (pixelHeight > 0 ? (float)pixelWidth / pixelHeight : 1f); set => m_Aspect = value; }

        /// <summary>Cameras with a lower depth render first.</summary>
        public float depth { get => m_Depth; set => m_Depth = value; }

        public int cullingMask { get; set; } = -1;

        public CameraType cameraType { get; set; } = CameraType.Game;

        public CameraClearFlags clearFlags { get; set; } = CameraClearFlags.Skybox;

        public Color backgroundColor { get; set; } = new(49f / 255f, 77f / 255f, 121f / 255f, 0f);

        public bool allowHDR { get; set; } = true;

        public bool allowMSAA { get; set; } = true;

        public bool useOcclusionCulling { get; set; } = true;

        /// <summary>Which textures of its depth shaders can read.</summary>
        public DepthTextureMode depthTextureMode { get; set; }

        /// <summary>The part of the target that is drawn to, 0..1.</summary>
        public Rect rect { get => m_Rect; set => m_Rect = value; }

        public RenderTexture targetTexture
        {
            get { Use("get_targetTexture"); return m_Target; }
            set { Use("set_targetTexture"); m_Target = value; }
        }

        public int pixelWidth => Mathf.RoundToInt(m_Rect.width * TargetWidth);

        public int pixelHeight => Mathf.RoundToInt(m_Rect.height * TargetHeight);

        public Rect pixelRect
        {
            get => new(m_Rect.x * TargetWidth, m_Rect.y * TargetHeight, pixelWidth, pixelHeight);
            set => m_Rect = new Rect(value.x / TargetWidth, value.y / TargetHeight, value.width / TargetWidth, value.height / TargetHeight);
        }

        int TargetWidth => m_Target ? m_Target.width : stereoEnabled ? Headset.EyeWidth : Screen.width;

        int TargetHeight => m_Target ? m_Target.height : stereoEnabled ? Headset.EyeHeight : Screen.height;

        public void ResetAspect() => m_Aspect = null;

        /// <summary>Renders now, whether the camera is enabled or not.</summary>
        public void Render()
        {
            Use("Render");
            Cameras.Render(this);
        }

        /// <summary>Takes over the settings and the pose of another camera.</summary>
        public void CopyFrom(Camera other)
        {
            Use("CopyFrom");
            other.Use("CopyFrom");
            CopyNativeState(other, o => o);
            transform.SetPositionAndRotation(other.transform.position, other.transform.rotation);
        }

        internal override void OnRunningChanged(bool running)
        {
            if (running)
                Cameras.Running.Add(this);
            else
                Cameras.Running.Remove(this);
        }

        internal override void CopyNativeState(Component source, Func<Object, Object> remap)
        {
            var other = (Camera)source;
            (m_FieldOfView, m_Near, m_Far, m_Size, m_Depth) = (other.m_FieldOfView, other.m_Near, other.m_Far, other.m_Size, other.m_Depth);
            (m_Orthographic, m_Aspect, m_Rect, m_Target) = (other.m_Orthographic, other.m_Aspect, other.m_Rect, other.m_Target);
            (cullingMask, cameraType, clearFlags, backgroundColor) = (other.cullingMask, other.cameraType, other.clearFlags, other.backgroundColor);
            (allowHDR, allowMSAA, useOcclusionCulling) = (other.allowHDR, other.allowMSAA, other.useOcclusionCulling);
            (depthTextureMode, stereoTargetEye, m_Separation, stereoConvergence) =
                (other.depthTextureMode, other.stereoTargetEye, other.m_Separation, other.stereoConvergence);
            (m_WorldToCamera, m_Projection, m_Culling) = (other.m_WorldToCamera, other.m_Projection, other.m_Culling);
        }
    }
}
