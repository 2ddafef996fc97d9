namespace UnityEngine
{
    /// <summary>What the indices of a mesh form.</summary>
    public enum MeshTopology
    {
        Triangles = 0,
        Quads = 2,
        Lines = 3,
        LineStrip = 4,
        Points = 5,
    }

    /// <summary>Which textures of its depth a camera makes.</summary>
    [System.Flags]
    public enum DepthTextureMode
    {
        None = 0,
        Depth = 1,
        DepthNormals = 2,
        MotionVectors = 4,
    }

    /// <summary>How motion vectors come about; the host has none.</summary>
    public enum MotionVectorGenerationMode
    {
        Camera = 0,
        Object = 1,
        ForceNoMotion = 2,
    }
}

namespace UnityEngine.Rendering
{
    /// <summary>Which faces are left out.</summary>
    public enum CullMode
    {
        Off = 0,
        Front = 1,
        Back = 2,
    }

    /// <summary>Comparisons of depth and stencil.</summary>
    public enum CompareFunction
    {
        Disabled = 0,
        Never = 1,
        Less = 2,
        Equal = 3,
        LessEqual = 4,
        Greater = 5,
        NotEqual = 6,
        GreaterEqual = 7,
        Always = 8,
    }

    /// <summary>Factors of blending.</summary>
    public enum BlendMode
    {
        Zero = 0,
        One = 1,
        DstColor = 2,
        SrcColor = 3,
        OneMinusDstColor = 4,
        SrcAlpha = 5,
        OneMinusSrcColor = 6,
        DstAlpha = 7,
        OneMinusDstAlpha = 8,
        SrcAlphaSaturate = 9,
        OneMinusSrcAlpha = 10,
    }

    /// <summary>How source and target are combined; of Unity's many those that every device has.</summary>
    public enum BlendOp
    {
        Add = 0,
        Subtract = 1,
        ReverseSubtract = 2,
        Min = 3,
        Max = 4,
    }

    /// <summary>Which channels are written.</summary>
    [System.Flags]
    public enum ColorWriteMask
    {
        Alpha = 1,
        Blue = 2,
        Green = 4,
        Red = 8,
        All = 15,
    }

    /// <summary>What becomes of a stencil value.</summary>
    public enum StencilOp
    {
        Keep = 0,
        Zero = 1,
        Replace = 2,
        IncrementSaturate = 3,
        DecrementSaturate = 4,
        Invert = 5,
        IncrementWrap = 6,
        DecrementWrap = 7,
    }

    /// <summary>The order in which materials are drawn; above GeometryLast from back to front.</summary>
    public enum RenderQueue
    {
        Background = 1000,
        Geometry = 2000,
        AlphaTest = 2450,
        GeometryLast = 2500,
        Transparent = 3000,
        Overlay = 4000,
    }

    /// <summary>Kinds of shader properties.</summary>
    public enum ShaderPropertyType
    {
        Color = 0,
        Vector = 1,
        Float = 2,
        Range = 3,
        Texture = 4,
        Int = 5,
    }

    /// <summary>What attributes say of a shader property.</summary>
    [System.Flags]
    public enum ShaderPropertyFlags
    {
        None = 0,
        HideInInspector = 1,
        PerRendererData = 2,
        NoScaleOffset = 4,
        Normal = 8,
        HDR = 16,
        Gamma = 32,
        NonModifiableTextureData = 64,
        MainTexture = 128,
        MainColor = 256,
    }

    /// <summary>Whether something casts shadows; the host draws none.</summary>
    public enum ShadowCastingMode
    {
        Off = 0,
        On = 1,
        TwoSided = 2,
        ShadowsOnly = 3,
    }

    /// <summary>Use of light probes; the host has none.</summary>
    public enum LightProbeUsage
    {
        Off = 0,
        BlendProbes = 1,
        UseProxyVolume = 2,
        CustomProvided = 4,
    }

    /// <summary>Use of reflection probes; the host has none.</summary>
    public enum ReflectionProbeUsage
    {
        Off = 0,
        BlendProbes = 1,
        BlendProbesAndSkybox = 2,
        Simple = 3,
    }

    /// <summary>What to clear.</summary>
    [System.Flags]
    public enum RTClearFlags
    {
        None = 0,
        Color = 1,
        Depth = 2,
        Stencil = 4,
        ColorDepth = 3,
        ColorStencil = 5,
        DepthStencil = 6,
        All = 7,
    }

    /// <summary>What a target holds when drawing begins.</summary>
    public enum RenderBufferLoadAction
    {
        Load = 0,
        Clear = 1,
        DontCare = 2,
    }

    /// <summary>What becomes of a target when drawing ends.</summary>
    public enum RenderBufferStoreAction
    {
        Store = 0,
        Resolve = 1,
        StoreAndResolve = 2,
        DontCare = 3,
    }
}
