namespace UnityEngine
{
    /// <summary>Kinds of compute buffers.</summary>
    [System.Flags]
    public enum ComputeBufferType
    {
        Default = 0,
        Raw = 1,
        Append = 2,
        Counter = 4,
        Constant = 8,
        Structured = 16,
        IndirectArguments = 256,
    }
}

namespace UnityEngine.Rendering
{
    /// <summary>Graphics APIs.</summary>
    public enum GraphicsDeviceType
    {
        Direct3D11 = 2,
        Null = 4,
        OpenGLES3 = 11,
        PlayStation4 = 13,
        XboxOne = 14,
        Metal = 16,
        OpenGLCore = 17,
        Direct3D12 = 18,
        Vulkan = 21,
        Switch = 22,
        XboxOneD3D12 = 23,
        GameCoreXboxOne = 24,
        GameCoreXboxSeries = 25,
        PlayStation5 = 26,
        PlayStation5NGGC = 27,
        WebGPU = 28,
        Switch2 = 29,
    }

    /// <summary>Render targets that have no object.</summary>
    public enum BuiltinRenderTextureType
    {
        PropertyName = -4,
        BufferPtr = -3,
        RenderTexture = -2,
        BindableTexture = -1,
        None = 0,
        CurrentActive = 1,
        CameraTarget = 2,
        Depth = 3,
        DepthNormals = 4,
        ResolvedDepth = 5,
        GBuffer0 = 10,
        GBuffer1 = 11,
        GBuffer2 = 12,
        GBuffer3 = 13,
        Reflections = 14,
        MotionVectors = 15,
        GBuffer4 = 16,
        GBuffer5 = 17,
        GBuffer6 = 18,
        GBuffer7 = 19,
    }

    /// <summary>Where a keyword comes from.</summary>
    public enum ShaderKeywordType
    {
        None = 0,
        BuiltinDefault = 2,
        UserDefined = 16,
        Plugin = 32,
    }
}
