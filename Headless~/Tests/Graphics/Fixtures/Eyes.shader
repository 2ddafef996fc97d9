// Shows the eye: its x as red above 0.5, its index as green, in blue whether both stages agree.
Shader "Tests/Eyes"
{
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.universal" }
        Tags { "RenderPipeline" = "UniversalPipeline" }
        Pass
        {
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Eyes.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "UnityCG.cginc"
            #include "Eyes.hlsl"
            ENDHLSL
        }
    }
}
