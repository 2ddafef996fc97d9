namespace UnityEngine
{
    /// <summary>The project's quality, of which the host has one level.</summary>
    public sealed class QualitySettings : Object
    {
        QualitySettings()
        {
        }

        public static ColorSpace activeColorSpace => ColorSpaces.Active;

        public static ColorSpace desiredColorSpace => ColorSpaces.Active;
    }
}
