// Colours by texture coordinates, several passes, states by name: what the tests of targets and states draw with.
Shader "Tests/Gradient"
{
    Properties
    {
        _MainTex ("Texture", 2D) = "white" {}
        _Color ("Colour", Color) = (1, 1, 1, 1)
        _Value ("Value", Vector) = (0, 0, 0, 1)
        _Depth ("Depth", Range(0, 1)) = 0.5
        [HideInInspector] _SrcBlend ("", Float) = 1
        [HideInInspector] _DstBlend ("", Float) = 0
        _ZTest ("Depth test", Int) = 4
        _ZWrite ("Depth write", Int) = 1
        _Mask ("Mask", Int) = 15
        _Unused ("Unused", Integer) = 7
    }
    HLSLINCLUDE
    #include "UnityCG.cginc"

    UNITY_DECLARE_TEX2D(_MainTex);
    float4 _MainTex_TexelSize;
    float4 _Color;
    float4 _Value;
    float _Depth;

    struct v2f
    {
        float4 position : SV_POSITION;
        float2 uv : TEXCOORD0;
    };

    v2f vert(float4 vertex : POSITION, float2 uv : TEXCOORD0)
    {
        v2f o;
        o.position = UnityObjectToClipPos(vertex.xyz);
        o.uv = uv;
        return o;
    }
    ENDHLSL
    SubShader
    {
        Cull Off
        ZTest [_ZTest]
        ZWrite [_ZWrite]
        ColorMask [_Mask]
        Blend [_SrcBlend] [_DstBlend]
        Pass
        {
            Name "COORDINATES"
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            float4 frag(v2f i) : SV_Target { return float4(i.uv, 0, 1); }
            ENDHLSL
        }
        Pass
        {
            Name "VALUE"
            Tags { "LightMode" = "Never" }
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            float4 frag(v2f i, out float depth : SV_Depth) : SV_Target { depth = _Depth; return _Value; }
            ENDHLSL
        }
        Pass
        {
            Name "TEXTURE"
            Tags { "LightMode" = "Never" }
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            float4 frag(v2f i) : SV_Target { return UNITY_SAMPLE_TEX2D(_MainTex, i.uv) * _Color; }
            ENDHLSL
        }
        Pass
        {
            Name "TWO TARGETS"
            Tags { "LightMode" = "Never" }
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            void frag(v2f i, out float4 first : SV_Target0, out float4 second : SV_Target1)
            {
                first = _Value;
                second = float4(_MainTex_TexelSize.zw, _ScreenParams.xy);
            }
            ENDHLSL
        }
        Pass
        {
            Name "PARAMETERS"
            Tags { "LightMode" = "Never" }
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            float4 frag(v2f i) : SV_Target { return float4(_ProjectionParams.x, _ProjectionParams.y, _ProjectionParams.z, unity_OrthoParams.w); }
            ENDHLSL
        }
    }
}
