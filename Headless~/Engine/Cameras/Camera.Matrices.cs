namespace UnityEngine
{
    public sealed partial class Camera
    {
        Matrix4x4? m_WorldToCamera;
        Matrix4x4? m_Projection;
        Matrix4x4? m_Culling;

        /// <summary>World to view space, where points in front have negative z. A value set by hand sticks until it is reset.</summary>
        public Matrix4x4 worldToCameraMatrix
        {
            get { Use("get_worldToCameraMatrix"); return m_WorldToCamera ?? CameraToWorldFromTransform().inverse; }
            set { Use("set_worldToCameraMatrix"); m_WorldToCamera = value; }
        }

        public Matrix4x4 cameraToWorldMatrix
        {
            get { Use("get_cameraToWorldMatrix"); return m_WorldToCamera?.inverse ?? CameraToWorldFromTransform(); }
        }

        /// <summary>OpenGL's projection, z to -1..1. A value set by hand sticks until it is reset.</summary>
        public Matrix4x4 projectionMatrix
        {
            get { Use("get_projectionMatrix"); return m_Projection ?? OwnProjection(); }
            set { Use("set_projectionMatrix"); m_Projection = value; }
        }

        public Matrix4x4 nonJitteredProjectionMatrix
        {
            get => projectionMatrix;
            set => projectionMatrix = value;
        }

        /// <summary>World to clip space for the choice of what is drawn. A value set by hand sticks until it is reset.</summary>
        public Matrix4x4 cullingMatrix
        {
            get => m_Culling ?? projectionMatrix * worldToCameraMatrix;
            set => m_Culling = value;
        }

        public void ResetWorldToCameraMatrix() => m_WorldToCamera = null;

        public void ResetProjectionMatrix() => m_Projection = null;

        public void ResetCullingMatrix() => m_Culling = null;

        /// <summary>A ray from the near plane through a point of the picture, (0,0) bottom left to (1,1) top right.</summary>
        public Ray ViewportPointToRay(Vector3 pos) => ViewportPointToRay(pos, MonoOrStereoscopicEye.Mono);

        public Ray ViewportPointToRay(Vector3 pos, MonoOrStereoscopicEye eye)
        {
            var view = View(eye);
            var p = view.Projection;
            var nearZ = -(p.m23 + p.m33) / (p.m22 + p.m32);
            var start = Unproject(p, pos, nearZ);
            var isPerspective = p.m32 != 0f;
            var toWorld = view.View.inverse;
            return new Ray(toWorld.MultiplyPoint3x4(start), toWorld.MultiplyVector(isPerspective ? start / -nearZ : Vector3.back));
        }

        public Ray ScreenPointToRay(Vector3 pos) => ViewportPointToRay(ScreenToViewportPoint(pos));

        public Ray ScreenPointToRay(Vector3 pos, MonoOrStereoscopicEye eye) => ViewportPointToRay(ScreenToViewportPoint(pos), eye);

        /// <summary>The point at distance z (world units, along the view direction) behind a point of the picture.</summary>
        public Vector3 ViewportToWorldPoint(Vector3 position) => ViewportToWorldPoint(position, MonoOrStereoscopicEye.Mono);

        public Vector3 ViewportToWorldPoint(Vector3 position, MonoOrStereoscopicEye eye)
        {
            var view = View(eye);
            return view.View.inverse.MultiplyPoint3x4(Unproject(view.Projection, position, -position.z));
        }

        public Vector3 ScreenToWorldPoint(Vector3 position) => ViewportToWorldPoint(ScreenToViewportPoint(position));

        public Vector3 ScreenToWorldPoint(Vector3 position, MonoOrStereoscopicEye eye) => ViewportToWorldPoint(ScreenToViewportPoint(position), eye);

        /// <summary>Where a point is in the picture; z is its distance along the view direction.</summary>
        public Vector3 WorldToViewportPoint(Vector3 position) => WorldToViewportPoint(position, MonoOrStereoscopicEye.Mono);

        public Vector3 WorldToViewportPoint(Vector3 position, MonoOrStereoscopicEye eye)
        {
            var of = View(eye);
            var view = of.View.MultiplyPoint3x4(position);
            var ndc = of.Projection.MultiplyPoint(view);
            return new Vector3(ndc.x * 0.5f + 0.5f, ndc.y * 0.5f + 0.5f, -view.z);
        }

        public Vector3 WorldToScreenPoint(Vector3 position) => ViewportToScreenPoint(WorldToViewportPoint(position));

        public Vector3 WorldToScreenPoint(Vector3 position, MonoOrStereoscopicEye eye) => ViewportToScreenPoint(WorldToViewportPoint(position, eye));

        public Vector3 ScreenToViewportPoint(Vector3 position)
        {
            var r = pixelRect;
            return new Vector3((position.x - r.x) / r.width, (position.y - r.y) / r.height, position.z);
        }

        public Vector3 ViewportToScreenPoint(Vector3 position)
        {
            var r = pixelRect;
            return new Vector3(position.x * r.width + r.x, position.y * r.height + r.y, position.z);
        }

        /// <summary>The point of view space at depth z (negative in front) that projects to a point of the picture.</summary>
        static Vector3 Unproject(Matrix4x4 p, Vector3 viewport, float z)
        {
            var w = p.m32 * z + p.m33;
            var x = ((viewport.x * 2f - 1f) * w - p.m02 * z - p.m03) / p.m00;
            var y = ((viewport.y * 2f - 1f) * w - p.m12 * z - p.m13) / p.m11;
            return new Vector3(x, y, z);
        }

        /// <summary>The frusta in which something is seen: two of a stereo camera.</summary>
        internal Matrix4x4[] CullingMatrices()
        {
            if (m_Culling != null || !stereoEnabled)
                return new[] { cullingMatrix };
            var (left, right) = (View(MonoOrStereoscopicEye.Left), View(MonoOrStereoscopicEye.Right));
            return new[] { left.Projection * left.View, right.Projection * right.View };
        }

        Matrix4x4 CameraToWorldFromTransform() => Matrix4x4.TRS(transform.position, transform.rotation, new Vector3(1f, 1f, -1f));

        Matrix4x4 OwnProjection() => m_Orthographic
            ? Matrix4x4.Ortho(-m_Size * aspect, m_Size * aspect, -m_Size, m_Size, m_Near, m_Far)
            : Matrix4x4.Perspective(m_FieldOfView, aspect, m_Near, m_Far);
    }
}
