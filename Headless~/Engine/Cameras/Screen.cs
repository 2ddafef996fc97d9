namespace UnityEngine
{
    /// <summary>The window; headless a size only.</summary>
    public sealed class Screen
    {
        public static int width { get; internal set; } = 1280;

        public static int height { get; internal set; } = 720;

        public static float dpi => 96f;

        public static Rect safeArea => new(0f, 0f, width, height);
    }
}
