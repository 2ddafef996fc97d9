namespace UnityEngine
{
    /// <summary>The scene's settings for rendering; of them the host knows the ambient light.</summary>
    public sealed class RenderSettings : Object
    {
        RenderSettings()
        {
        }

        /// <summary>Light from everywhere.</summary>
        public static Color ambientLight { get; set; } = DefaultAmbient;

        public static float ambientIntensity { get; set; } = 1f;

        static Color DefaultAmbient => new(0.212f, 0.227f, 0.259f, 1f);

        internal static void Forget()
        {
            ambientLight = DefaultAmbient;
            ambientIntensity = 1f;
        }
    }
}
