namespace UnityEngine.Experimental.Rendering
{
    /// <summary>What a format is to be used for.</summary>
    [System.Flags]
    public enum GraphicsFormatUsage
    {
        None = 0,
        Sample = 1,
        Linear = 2,
        Sparse = 4,
        Render = 16,
        Blend = 32,
        GetPixels = 64,
        SetPixels = 128,
        SetPixels32 = 256,
        ReadPixels = 512,
        LoadStore = 1024,
        MSAA2x = 2048,
        MSAA4x = 4096,
        MSAA8x = 8192,
        StencilSampling = 65536,
    }

    /// <summary>How a texture is made.</summary>
    [System.Flags]
    public enum TextureCreationFlags
    {
        None = 0,
        MipChain = 1,
        DontInitializePixels = 4,
        Crunch = 64,
        DontUploadUponCreate = 1024,
    }

    /// <summary>Formats that the platform chooses.</summary>
    public enum DefaultFormat
    {
        LDR = 0,
        HDR = 1,
        DepthStencil = 2,
        Shadow = 3,
        Video = 4,
    }
}
