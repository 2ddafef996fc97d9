// Colour, texture, the main directional light and ambient light: what stands for URP's lit shaders here.
Shader "@NAME@"
{
    Properties
    {
        [MainColor] _BaseColor ("Base Color", Color) = (1, 1, 1, 1)
        [MainTexture] _BaseMap ("Base Map", 2D) = "white" {}
        [HideInInspector] _Cull ("", Float) = 2
        [HideInInspector] _SrcBlend ("", Float) = 1
        [HideInInspector] _DstBlend ("", Float) = 0
        [HideInInspector] _ZWrite ("", Float) = 1
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.universal" }
        Tags { "RenderType" = "Opaque" "RenderPipeline" = "UniversalPipeline" }
        Pass
        {
            Name "ForwardLit"
            Tags { "LightMode" = "UniversalForward" }
            Blend [_SrcBlend] [_DstBlend]
            ZWrite [_ZWrite]
            Cull [_Cull]
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
            #include "UniversalSurface.hlsl"

            half4 frag(Varyings input) : SV_Target
            {
                half4 albedo = Albedo(input);
                Light light = GetMainLight();
                half3 normal = normalize(input.normalWS);
                return half4(albedo.rgb * (LightingLambert(light.color, light.direction, normal) + SampleSH(normal)), albedo.a);
            }
            ENDHLSL
        }
    }
}
