namespace UnityEditor
{
    /// <summary>What is built for. Headless it is always Linux.</summary>
    public enum BuildTarget
    {
        NoTarget = -2,
        StandaloneOSX = 2,
        StandaloneWindows = 5,
        iOS = 9,
        Android = 13,
        StandaloneWindows64 = 19,
        WebGL = 20,
        StandaloneLinux64 = 24,
        VisionOS = 47,
    }
}
