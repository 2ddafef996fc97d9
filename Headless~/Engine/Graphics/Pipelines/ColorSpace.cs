namespace UnityEngine
{
    /// <summary>How colours are stored and computed.</summary>
    public enum ColorSpace
    {
        Uninitialized = -1,
        Gamma = 0,
        Linear = 1,
    }

    /// <summary>The project's colour space, which the host chooses before it starts.</summary>
    static class ColorSpaces
    {
        internal static ColorSpace Active { get; set; } = ColorSpace.Linear;

        internal static bool IsLinear => Active == ColorSpace.Linear;

        /// <summary>A colour as people see it, turned into what shaders compute with.</summary>
        internal static Color ToShader(Color color) => IsLinear ? color.linear : color;
    }
}
