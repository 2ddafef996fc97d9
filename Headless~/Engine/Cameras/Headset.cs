using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>How the eyes of a headset are drawn.</summary>
    enum StereoMode
    {
        /// <summary>There is no headset.</summary>
        None = 0,

        /// <summary>One eye after the other.</summary>
        MultiPass = 1,

        /// <summary>Both in one draw, whose instances choose the eye.</summary>
        SinglePassInstanced = 2,

        /// <summary>Both in one draw by the device's views.</summary>
        Multiview = 3,
    }

    /// <summary>The headset that the host pretends to have: eyes and their pictures. Its pose is the camera's.</summary>
    static class Headset
    {
        static RenderTexture s_Eyes;

        internal static StereoMode Mode { get; set; }

        internal static int EyeWidth { get; set; } = 1;

        internal static int EyeHeight { get; set; } = 1;

        /// <summary>From eye to eye in world units.</summary>
        internal static float Separation { get; set; }

        /// <summary>The left eye's frustum at distance 1.</summary>
        internal static FrustumPlanes Left { get; set; }

        /// <inheritdoc cref="Left"/>
        internal static FrustumPlanes Right { get; set; }

        /// <summary>The pictures: a slice per eye, made at their first use.</summary>
        internal static RenderTexture Eyes
        {
            get
            {
                if (s_Eyes != null && (s_Eyes.width != EyeWidth || s_Eyes.height != EyeHeight))
                    Clear();
                if (s_Eyes == null)
                {
                    var format = ColorSpaces.IsLinear ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm;
                    s_Eyes = new RenderTexture(new RenderTextureDescriptor(EyeWidth, EyeHeight, format, GraphicsFormat.D32_SFloat)
                    {
                        dimension = TextureDimension.Tex2DArray,
                        volumeDepth = 2,
                        vrUsage = VRTextureUsage.TwoEyes,
                    })
                    { name = "Eyes" };
                    s_Eyes.Create();
                    ObjectRegistry.Remove(s_Eyes);
                    EmptyPictures.ClearEyes(s_Eyes);
                }
                return s_Eyes;
            }
        }

        /// <summary>An eye's picture as it is stored, RGBA, the bottom row first.</summary>
        internal static byte[] Read(int eye)
        {
            var texture = Eyes;
            return Gpu.Context.Readbacks.ReadNow(texture.ColorNative, 0, new TexelBox(0, 0, eye, texture.width, texture.height, 1));
        }

        /// <summary>The view of an eye beside a camera.</summary>
        internal static Matrix4x4 View(Matrix4x4 camera, Camera.StereoscopicEye eye) =>
            Matrix4x4.Translate(new Vector3(eye == Camera.StereoscopicEye.Left ? Separation / 2 : -Separation / 2, 0, 0)) * camera;

        internal static Matrix4x4 Projection(Camera.StereoscopicEye eye, float near, float far)
        {
            var f = eye == Camera.StereoscopicEye.Left ? Left : Right;
            return Matrix4x4.Frustum(f.left * near, f.right * near, f.bottom * near, f.top * near, near, far);
        }

        internal static void Forget()
        {
            Clear();
            Mode = StereoMode.None;
        }

        /// <summary>Frees the pictures.</summary>
        internal static void Clear()
        {
            if (s_Eyes != null)
                Object.DestroyImmediate(s_Eyes, true);
            s_Eyes = null;
        }
    }
}
