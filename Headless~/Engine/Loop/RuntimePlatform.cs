namespace UnityEngine
{
    /// <summary>Where the player runs; the host is a Linux player.</summary>
    public enum RuntimePlatform
    {
        OSXEditor = 0,
        OSXPlayer = 1,
        WindowsPlayer = 2,
        WindowsEditor = 7,
        IPhonePlayer = 8,
        Android = 11,
        LinuxPlayer = 13,
        LinuxEditor = 16,
        WebGLPlayer = 17,
        LinuxServer = 43,
        WindowsServer = 44,
        OSXServer = 45,
        VisionOS = 50,
    }
}
