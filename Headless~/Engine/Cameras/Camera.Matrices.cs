namespace UnityEngine
{
    public sealed partial class Camera
    {
        Matrix4x4? m_WorldToCamera;
        Matrix4x4? m_Projection;

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

        public Matrix4x4 cullingMatrix => projectionMatrix * worldToCameraMatrix;

        public void ResetWorldToCameraMatrix() => m_WorldToCamera = null;

        public void ResetProjectionMatrix() => m_Projection = null;

        /// <summary>A ray from the near plane through a point of the picture, (0,0) bottom left to (1,1) top right.</summary>
        public Ray ViewportPointToRay(Vector3 pos)
        {
            var p = projectionMatrix;
            var nearZ = -(p.m23 + p.m33) / (p.m22 + p.m32);
            var start = Unproject(p, pos, nearZ);
            var isPerspective = p.m32 != 0f;
            var toWorld = cameraToWorldMatrix;
            return new Ray(toWorld.MultiplyPoint3x4(start), toWorld.MultiplyVector(isPerspective ? start * Mathf.Sign(-nearZ) : Vector3.back));
        }

        public Ray ViewportPointToRay(Vector3 pos, MonoOrStereoscopicEye eye) => ViewportPointToRay(pos);

        public Ray ScreenPointToRay(Vector3 pos) => ViewportPointToRay(ScreenToViewportPoint(pos));

        public Ray ScreenPointToRay(Vector3 pos, MonoOrStereoscopicEye eye) => ScreenPointToRay(pos);

        /// <summary>The point at distance z (world units, along the view direction) behind a point of the picture.</summary>
        public Vector3 ViewportToWorldPoint(Vector3 position) => cameraToWorldMatrix.MultiplyPoint3x4(Unproject(projectionMatrix, position, -position.z));

        public Vector3 ViewportToWorldPoint(Vector3 position, MonoOrStereoscopicEye eye) => ViewportToWorldPoint(position);

        public Vector3 ScreenToWorldPoint(Vector3 position) => ViewportToWorldPoint(ScreenToViewportPoint(position));

        /// <summary>Where a point is in the picture; z is its distance along the view direction.</summary>
        public Vector3 WorldToViewportPoint(Vector3 position)
        {
            var view = worldToCameraMatrix.MultiplyPoint3x4(position);
            var ndc = projectionMatrix.MultiplyPoint(view);
            return new Vector3(ndc.x * 0.5f + 0.5f, ndc.y * 0.5f + 0.5f, -view.z);
        }

        public Vector3 WorldToScreenPoint(Vector3 position) => ViewportToScreenPoint(WorldToViewportPoint(position));

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

        Matrix4x4 CameraToWorldFromTransform() => Matrix4x4.TRS(transform.position, transform.rotation, new Vector3(1f, 1f, -1f));

        Matrix4x4 OwnProjection() => m_Orthographic
            ? Matrix4x4.Ortho(-m_Size * aspect, m_Size * aspect, -m_Size, m_Size, m_Near, m_Far)
            : Matrix4x4.Perspective(m_FieldOfView, aspect, m_Near, m_Far);
    }
}
