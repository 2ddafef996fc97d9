using System;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>One eye's view: matrices as a camera has them, in OpenGL's manner.</summary>
    readonly struct EyeView
    {
        internal EyeView(Matrix4x4 view, Matrix4x4 projection)
        {
            View = view;
            Projection = projection;
        }

        internal readonly Matrix4x4 View;
        internal readonly Matrix4x4 Projection;

        internal Vector3 Position => View.inverse.GetColumn(3);
    }

    /// <summary>What all draws of a picture share.</summary>
    struct ViewSetup
    {
        /// <summary>The left eye's, or the only one.</summary>
        internal EyeView Left;

        /// <summary>The right eye's; counts in a picture of both only.</summary>
        internal EyeView Right;
        internal bool IsStereo;

        /// <summary>What shaders are told as the camera's place in a picture of one; null = where the view is from.</summary>
        internal Vector3? CameraPosition;

        /// <summary>Whether the picture is drawn into a texture, which turns it over on this API.</summary>
        internal bool IntoTexture;
        internal int Width;
        internal int Height;
        internal float Near;
        internal float Far;
        internal bool IsOrthographic;
        internal Vector2 OrthographicSize;

        /// <summary>What shaders are told of the eye in a picture of one; 0 or 1.</summary>
        internal int EyeIndex;

        /// <summary>A view with matrices of one's own, for a target of that size.</summary>
        internal static ViewSetup Of(Matrix4x4 view, Matrix4x4 projection, int width, int height)
        {
            var planes = projection.decomposeProjection;
            var orthographic = projection.m32 == 0;
            var setup = new ViewSetup { Left = new EyeView(view, projection), Width = width, Height = height, IsOrthographic = orthographic };
            (setup.Near, setup.Far) = planes.zFar > planes.zNear && planes.zNear > 0 ? (planes.zNear, planes.zFar) : (0.01f, 100f);
            if (orthographic)
                setup.OrthographicSize = new Vector2(1 / projection.m00, 1 / projection.m11);
            return setup;
        }
    }

    /// <summary>The values that the engine gives to shaders, by Unity's names.</summary>
    static class ViewValues
    {
        static readonly int s_Time = Id("_Time"), s_SinTime = Id("_SinTime"), s_CosTime = Id("_CosTime"), s_DeltaTime = Id("unity_DeltaTime"),
            s_TimeParameters = Id("_TimeParameters"), s_CameraPosition = Id("_WorldSpaceCameraPos"), s_ProjectionParams = Id("_ProjectionParams"),
            s_ScreenParams = Id("_ScreenParams"), s_ScaledScreenParams = Id("_ScaledScreenParams"), s_ZBufferParams = Id("_ZBufferParams"),
            s_OrthoParams = Id("unity_OrthoParams"), s_EyeIndex = Id("unity_StereoEyeIndex"), s_ObjectToWorld = Id("unity_ObjectToWorld"),
            s_WorldToObject = Id("unity_WorldToObject"), s_LodFade = Id("unity_LODFade"), s_TransformParams = Id("unity_WorldTransformParams"),
            s_ClipPlanes = Id("unity_CameraWorldClipPlanes"), s_StereoPosition = Id("unity_StereoWorldSpaceCameraPos"),
            s_StereoScaleOffset = Id("unity_StereoScaleOffset");

        // For one eye, and the array for both.
        static readonly (int One, int Both, Func<EyeView, bool, Matrix4x4> Value)[] s_Matrices =
        {
            Matrix("glstate_matrix_projection", "unity_StereoMatrixP", Gpu),
            Matrix("unity_MatrixV", "unity_StereoMatrixV", (e, _) => e.View),
            Matrix("unity_MatrixInvV", "unity_StereoMatrixInvV", (e, _) => e.View.inverse),
            Matrix("unity_MatrixInvP", "unity_StereoMatrixInvP", (e, t) => Gpu(e, t).inverse),
            Matrix("unity_MatrixVP", "unity_StereoMatrixVP", (e, t) => Gpu(e, t) * e.View),
            Matrix("unity_MatrixInvVP", "unity_StereoMatrixInvVP", (e, t) => (Gpu(e, t) * e.View).inverse),
            Matrix("unity_CameraProjection", "unity_StereoCameraProjection", (e, _) => e.Projection),
            Matrix("unity_CameraInvProjection", "unity_StereoCameraInvProjection", (e, _) => e.Projection.inverse),
            // Unlike the view matrix these keep Unity's z: positive in front.
            Matrix("unity_WorldToCamera", "unity_StereoWorldToCamera", (e, _) => s_Flip * e.View),
            Matrix("unity_CameraToWorld", "unity_StereoCameraToWorld", (e, _) => e.View.inverse * s_Flip),
        };

        static readonly Matrix4x4 s_Flip = Matrix4x4.Scale(new Vector3(1, 1, -1));
        static readonly Plane[] s_Planes = new Plane[6];
        static readonly Vector4[] s_PlaneRows = new Vector4[6];

        /// <summary>Writes what depends on the view.</summary>
        internal static void Write(PropertySheet sheet, in ViewSetup view)
        {
            var texture = view.IntoTexture;
            foreach (var (one, both, value) in s_Matrices)
            {
                sheet.Set(one, value(view.Left, texture), NumberKind.Float);
                if (view.IsStereo)
                    Set(sheet, both, value(view.Left, texture), value(view.Right, texture));
            }
            sheet.Set(s_CameraPosition, (Vector4)(view.CameraPosition ?? view.Left.Position), NumberKind.Float);
            if (view.IsStereo)
            {
                Set(sheet, s_StereoPosition, (Vector4)view.Left.Position, (Vector4)view.Right.Position);
                Set(sheet, s_StereoScaleOffset, new Vector4(1, 1, 0, 0), new Vector4(1, 1, 0, 0));
            }
            sheet.Set(s_EyeIndex, view.EyeIndex, NumberKind.Int);
            var (near, far) = (view.Near, view.Far);
            Set(sheet, s_ProjectionParams, new Vector4(texture ? -1 : 1, near, far, 1 / far));
            var size = new Vector4(view.Width, view.Height, 1 + 1f / view.Width, 1 + 1f / view.Height);
            Set(sheet, s_ScreenParams, size);
            Set(sheet, s_ScaledScreenParams, size);
            // Of reversed depth.
            Set(sheet, s_ZBufferParams, new Vector4(far / near - 1, 1, (far / near - 1) / far, 1 / far));
            Set(sheet, s_OrthoParams, new Vector4(view.OrthographicSize.x, view.OrthographicSize.y, 0, view.IsOrthographic ? 1 : 0));
            GeometryUtility.CalculateFrustumPlanes(view.Left.Projection * view.Left.View, s_Planes);
            for (var i = 0; i < s_Planes.Length; i++)
                s_PlaneRows[i] = new Vector4(s_Planes[i].normal.x, s_Planes[i].normal.y, s_Planes[i].normal.z, s_Planes[i].distance);
            sheet.Set(s_ClipPlanes, new ReadOnlySpan<Vector4>(s_PlaneRows), NumberKind.Float);
            Clock(sheet);
        }

        /// <summary>Writes what depends on the object.</summary>
        internal static void Write(PropertySheet sheet, Matrix4x4 objectToWorld)
        {
            sheet.Set(s_ObjectToWorld, objectToWorld, NumberKind.Float);
            sheet.Set(s_WorldToObject, objectToWorld.inverse, NumberKind.Float);
            Set(sheet, s_LodFade, new Vector4(1, 16, 0, 0));
            Set(sheet, s_TransformParams, new Vector4(0, 0, 0, objectToWorld.determinant < 0 ? -1 : 1));
        }

        static void Clock(PropertySheet sheet)
        {
            var (t, dt) = (Time.time, Time.deltaTime);
            Set(sheet, s_Time, new Vector4(t / 20, t, t * 2, t * 3));
            Set(sheet, s_SinTime, new Vector4(Mathf.Sin(t / 8), Mathf.Sin(t / 4), Mathf.Sin(t / 2), Mathf.Sin(t)));
            Set(sheet, s_CosTime, new Vector4(Mathf.Cos(t / 8), Mathf.Cos(t / 4), Mathf.Cos(t / 2), Mathf.Cos(t)));
            Set(sheet, s_DeltaTime, new Vector4(dt, dt > 0 ? 1 / dt : 0, dt, dt > 0 ? 1 / dt : 0));
            Set(sheet, s_TimeParameters, new Vector4(t, Mathf.Sin(t), Mathf.Cos(t), 0));
        }

        static Matrix4x4 Gpu(EyeView eye, bool intoTexture) => GL.GetGPUProjectionMatrix(eye.Projection, intoTexture);

        static int Id(string name) => Shader.PropertyToID(name);

        static (int, int, Func<EyeView, bool, Matrix4x4>) Matrix(string one, string both, Func<EyeView, bool, Matrix4x4> value) => (Id(one), Id(both), value);

        static void Set(PropertySheet sheet, int name, Vector4 value) => sheet.Set(name, value, NumberKind.Float);

        static unsafe void Set<T>(PropertySheet sheet, int name, T left, T right) where T : unmanaged
        {
            var both = stackalloc T[] { left, right };
            sheet.Set(name, both, 2 * sizeof(T), NumberKind.Float);
        }
    }
}
