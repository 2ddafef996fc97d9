namespace UnityEngine
{
    /// <summary>Which eyes a camera draws.</summary>
    public enum StereoTargetEyeMask
    {
        None = 0,
        Left = 1,
        Right = 2,
        Both = 3,
    }

    public sealed partial class Camera
    {
        readonly Matrix4x4?[] m_EyeViews = new Matrix4x4?[2];
        readonly Matrix4x4?[] m_EyeProjections = new Matrix4x4?[2];
        float m_Separation = 0.022f;

        /// <summary>An eye of a headset.</summary>
        public enum StereoscopicEye
        {
            Left = 0,
            Right = 1,
        }

        /// <summary>Whether it draws into a headset: if there is one, and no other target.</summary>
        public bool stereoEnabled
        {
            get
            {
                Use("get_stereoEnabled");
                return Headset.Mode != StereoMode.None && !m_Target && stereoTargetEye != StereoTargetEyeMask.None
                    && cameraType is CameraType.Game or CameraType.VR;
            }
        }

        public StereoTargetEyeMask stereoTargetEye { get; set; } = StereoTargetEyeMask.Both;

        /// <summary>The eye that is drawn; between pictures the left one, without a headset neither.</summary>
        public MonoOrStereoscopicEye stereoActiveEye => stereoEnabled ? DrawnEye : MonoOrStereoscopicEye.Mono;

        /// <summary>The distance between the eyes. The headset's, if there is one.</summary>
        public float stereoSeparation { get => stereoEnabled ? Headset.Separation : m_Separation; set => m_Separation = value; }

        public float stereoConvergence { get; set; } = 10f;

        /// <summary>Both eyes are always culled at once.</summary>
        public bool areVRStereoViewMatricesWithinSingleCullTolerance => true;

        internal MonoOrStereoscopicEye DrawnEye { get; set; } = MonoOrStereoscopicEye.Left;

        /// <summary>World to an eye's view. Without a headset that of the camera.</summary>
        public Matrix4x4 GetStereoViewMatrix(StereoscopicEye eye)
        {
            Use("GetStereoViewMatrix");
            return m_EyeViews[(int)eye] ?? (stereoEnabled ? Headset.View(worldToCameraMatrix, eye) : worldToCameraMatrix);
        }

        /// <summary>Sticks until <see cref="ResetStereoViewMatrices"/>.</summary>
        public void SetStereoViewMatrix(StereoscopicEye eye, Matrix4x4 matrix)
        {
            Use("SetStereoViewMatrix");
            m_EyeViews[(int)eye] = matrix;
        }

        public void ResetStereoViewMatrices() => m_EyeViews[0] = m_EyeViews[1] = null;

        /// <summary>An eye's projection in OpenGL's manner. Without a headset that of the camera.</summary>
        public Matrix4x4 GetStereoProjectionMatrix(StereoscopicEye eye)
        {
            Use("GetStereoProjectionMatrix");
            return m_EyeProjections[(int)eye] ?? (stereoEnabled ? Headset.Projection(eye, m_Near, m_Far) : projectionMatrix);
        }

        public Matrix4x4 GetStereoNonJitteredProjectionMatrix(StereoscopicEye eye) => GetStereoProjectionMatrix(eye);

        /// <summary>Sticks until <see cref="ResetStereoProjectionMatrices"/>.</summary>
        public void SetStereoProjectionMatrix(StereoscopicEye eye, Matrix4x4 matrix)
        {
            Use("SetStereoProjectionMatrix");
            m_EyeProjections[(int)eye] = matrix;
        }

        public void ResetStereoProjectionMatrices() => m_EyeProjections[0] = m_EyeProjections[1] = null;

        /// <summary>Matrices of an eye, or of the camera.</summary>
        internal EyeView View(MonoOrStereoscopicEye eye) => eye switch
        {
            MonoOrStereoscopicEye.Left => new EyeView(GetStereoViewMatrix(StereoscopicEye.Left), GetStereoProjectionMatrix(StereoscopicEye.Left)),
            MonoOrStereoscopicEye.Right => new EyeView(GetStereoViewMatrix(StereoscopicEye.Right), GetStereoProjectionMatrix(StereoscopicEye.Right)),
            _ => new EyeView(worldToCameraMatrix, projectionMatrix),
        };
    }
}
