// Says by its colour which SubShader was chosen: red of URP, blue of HDRP, green of all others. URP's has two passes, of which only the first counts.
Shader "Tests/Pipelines"
{
    HLSLINCLUDE
    struct v2f
    {
        float4 position : SV_POSITION;
    };
    ENDHLSL

    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.universal" : "17.0" }
        Tags { "RenderPipeline" = "UniversalPipeline" }
        Pass
        {
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            v2f vert(float3 position : POSITION) { v2f o; o.position = TransformObjectToHClip(position); return o; }
            float4 frag(v2f i) : SV_Target { return float4(1, 0, 0, 1); }
            ENDHLSL
        }
        Pass
        {
            ZTest Always
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            v2f vert(float3 position : POSITION) { v2f o; o.position = TransformObjectToHClip(position); return o; }
            float4 frag(v2f i) : SV_Target { return float4(1, 1, 1, 1); }
            ENDHLSL
        }
    }
    SubShader
    {
        Tags { "RenderPipeline" = "HDRenderPipeline" }
        Pass
        {
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            v2f vert(float3 position : POSITION) { v2f o; o.position = float4(position, 1); return o; }
            float4 frag(v2f i) : SV_Target { return float4(0, 0, 1, 1); }
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
            v2f vert(float3 position : POSITION) { v2f o; o.position = UnityObjectToClipPos(position); return o; }
            float4 frag(v2f i) : SV_Target { return float4(0, 1, 0, 1); }
            ENDHLSL
        }
    }
}
