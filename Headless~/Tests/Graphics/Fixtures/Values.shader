// Every kind of value that a material has, a pass for each.
Shader "Tests/Values"
{
    Properties
    {
        [MainTexture] _Picture ("Picture", 2D) = "black" {}
        [MainColor] _Tint ("Tint", Color) = (0.5, 0.25, 1, 0.5)
        _Number ("Number", Float) = 1.5
        _Ranged ("Ranged", Range(-1, 3)) = 2
        _Whole ("Whole", Integer) = 5
        _Old ("Old", Int) = 3
        _Direction ("Direction", Vector) = (1, 2, 3, 4)
        _Volume ("Volume", 3D) = "" {}
        _Layers ("Layers", 2DArray) = "" {}
        _White ("White", 2D) = "white" {}
        _Grey ("Grey", 2D) = "gray" {}
        _Bump ("Bump", 2D) = "bump" {}
    }
    HLSLINCLUDE
    #include "UnityCG.cginc"

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

    float4 _Tint;
    float4 _Direction;
    float _Number;
    float _Ranged;
    int _Whole;
    int _Old;
    float4x4 _Turn;
    float4 _Rows[3];
    float _Steps[4];
    float4 _Loose;
    UNITY_DECLARE_TEX2D(_Picture);
    float4 _Picture_ST;
    ENDHLSL
    SubShader
    {
        Tags { "Queue" = "Transparent+5" "RenderType" = "Custom" }
        Cull Off
        ZTest Always
        ZWrite Off
        Pass { Name "TINT" HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            float4 frag(v2f i) : SV_Target { return _Tint; }
            ENDHLSL }
        Pass { Name "NUMBERS" HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            float4 frag(v2f i) : SV_Target { return float4(_Number, _Ranged, _Whole, _Old); }
            ENDHLSL }
        Pass { Name "DIRECTION" HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            float4 frag(v2f i) : SV_Target { return _Direction; }
            ENDHLSL }
        Pass { Name "MATRIX" HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            float4 frag(v2f i) : SV_Target { return mul(_Turn, float4(1, 0, 0, 1)); }
            ENDHLSL }
        Pass { Name "ARRAYS" HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            float4 frag(v2f i) : SV_Target { return float4(_Rows[2].xy, _Steps[1], _Steps[3]); }
            ENDHLSL }
        Pass { Name "PICTURE" HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            float4 frag(v2f i) : SV_Target { return UNITY_SAMPLE_TEX2D(_Picture, TRANSFORM_TEX(i.uv, _Picture)); }
            ENDHLSL }
        Pass { Name "VOLUME" HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            UNITY_DECLARE_TEX3D(_Volume);
            UNITY_DECLARE_TEX2DARRAY(_Layers);
            float4 frag(v2f i) : SV_Target
            {
                return float4(UNITY_SAMPLE_TEX3D(_Volume, float3(0.5, 0.5, 0.75)).rg, UNITY_SAMPLE_TEX2DARRAY(_Layers, float3(i.uv, 1)).rg);
            }
            ENDHLSL }
        Pass { Name "DEFAULTS" HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            UNITY_DECLARE_TEX2D(_White);
            UNITY_DECLARE_TEX2D(_Grey);
            UNITY_DECLARE_TEX2D(_Bump);
            UNITY_DECLARE_TEX2D(_Missing);
            float4 frag(v2f i) : SV_Target
            {
                return float4(UNITY_SAMPLE_TEX2D(_White, i.uv).r, UNITY_SAMPLE_TEX2D(_Grey, i.uv).r, UNITY_SAMPLE_TEX2D(_Bump, i.uv).b,
                    UNITY_SAMPLE_TEX2D(_Missing, i.uv).r);
            }
            ENDHLSL }
        Pass { Name "BUFFER" HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex vert
            #pragma fragment frag
            StructuredBuffer<float4> _List;
            cbuffer Block { float4 _InBlock; float4 _AlsoInBlock; };
            float4 frag(v2f i) : SV_Target { return _List[1] + _AlsoInBlock; }
            ENDHLSL }
        Pass { Name "KEYWORDS" HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #pragma multi_compile_local _ IS_RED
            #pragma multi_compile _ IS_GREEN
            #pragma multi_compile_local_fragment SMALL LARGE
            float4 frag(v2f i) : SV_Target
            {
                float4 color = 0;
            #ifdef IS_RED
                color.r = 1;
            #endif
            #ifdef IS_GREEN
                color.g = 1;
            #endif
            #ifdef LARGE
                color.b = 2;
            #else
                color.b = 1;
            #endif
                return color;
            }
            ENDHLSL }
        Pass { Name "LOOSE" HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            float4 frag(v2f i) : SV_Target { return _Loose; }
            ENDHLSL }
        Pass { Name "WHOLE TEXTURE" HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex vert
            #pragma fragment frag
            Texture2D<uint> _Codes;
            float4 frag(v2f i) : SV_Target { return _Codes[uint2(1, 0)]; }
            ENDHLSL }
    }
}
