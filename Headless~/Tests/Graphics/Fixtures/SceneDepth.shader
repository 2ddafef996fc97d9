// Shows in red how far away the depth texture says that opaque objects are, in green its own distance.
Shader "Tests/SceneDepth"
{
    Properties
    {
        _Unit ("Distance of a full colour", Float) = 1
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.universal" }
        Tags { "RenderPipeline" = "UniversalPipeline" "Queue" = "Transparent" }
        Pass
        {
            ZWrite Off
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareDepthTexture.hlsl"
            float SceneDistance(float2 uv) { return LinearEyeDepth(SampleSceneDepth(uv), _ZBufferParams); }
            #include "SceneDepth.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        Tags { "Queue" = "Transparent" }
        Pass
        {
            ZWrite Off
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "UnityCG.cginc"
            UNITY_DECLARE_DEPTH_TEXTURE(_CameraDepthTexture);
            float SceneDistance(float2 uv) { return LinearEyeDepth(SAMPLE_DEPTH_TEXTURE(_CameraDepthTexture, uv)); }
            #include "SceneDepth.hlsl"
            ENDHLSL
        }
    }
}
