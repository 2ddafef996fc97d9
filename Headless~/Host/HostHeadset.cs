using UnityEngine;

namespace AnatomyCarve.Headless
{
    /// <summary>How the eyes of a headset are drawn.</summary>
    public enum HostStereo
    {
        /// <summary>There is no headset.</summary>
        Mono = 0,

        /// <summary>One eye after the other.</summary>
        MultiPass = 1,

        /// <summary>Both in one draw, whose instances choose the eye.</summary>
        SinglePassInstanced = 2,

        /// <summary>Both in one draw by the device's views.</summary>
        Multiview = 3,
    }

    /// <summary>A headset's eyes. Its pose is that of the camera.</summary>
    public sealed class HostHeadset
    {
        /// <summary>An eye's picture in pixels.</summary>
        public int EyeWidth { get; set; } = 512;

        /// <inheritdoc cref="EyeWidth"/>
        public int EyeHeight { get; set; } = 512;

        /// <summary>From eye to eye in world units.</summary>
        public float Separation { get; set; } = 0.064f;

        /// <summary>The left eye's frustum at distance 1; near and far are the camera's.</summary>
        public FrustumPlanes LeftEye { get; set; } = new() { left = -1.376f, right = 0.839f, bottom = -1.428f, top = 0.966f };

        /// <summary>The right eye's frustum at distance 1.</summary>
        public FrustumPlanes RightEye { get; set; } = new() { left = -0.839f, right = 1.376f, bottom = -1.428f, top = 0.966f };
    }
}
