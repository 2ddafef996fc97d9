namespace UnityEngine
{
    /// <summary>Where a text stands in its area.</summary>
    public enum TextAnchor
    {
        UpperLeft,
        UpperCenter,
        UpperRight,
        MiddleLeft,
        MiddleCenter,
        MiddleRight,
        LowerLeft,
        LowerCenter,
        LowerRight,
    }

    public enum FontStyle
    {
        Normal,
        Bold,
        Italic,
        BoldAndItalic,
    }

    /// <summary>What a line does that is too long.</summary>
    public enum HorizontalWrapMode
    {
        Wrap,
        Overflow,
    }

    /// <summary>What a text does that has too many lines.</summary>
    public enum VerticalWrapMode
    {
        Truncate,
        Overflow,
    }
}
