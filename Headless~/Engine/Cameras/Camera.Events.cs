namespace UnityEngine
{
    public sealed partial class Camera
    {
        /// <summary>Called before a camera culls.</summary>
        public static CameraCallback onPreCull;

        /// <summary>Called before a camera draws.</summary>
        public static CameraCallback onPreRender;

        /// <summary>Called when a camera has drawn.</summary>
        public static CameraCallback onPostRender;
    }
}
