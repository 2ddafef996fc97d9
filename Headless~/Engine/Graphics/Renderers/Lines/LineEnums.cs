namespace UnityEngine
{
    /// <summary>What a line's face is turned to.</summary>
    public enum LineAlignment
    {
        View = 0,
        TransformZ = 1,
    }

    /// <summary>How a texture lies along a line.</summary>
    public enum LineTextureMode
    {
        Stretch = 0,
        Tile = 1,
        DistributePerSegment = 2,
        RepeatPerSegment = 3,
        Static = 4,
    }
}
