// A colour of the material in red, a texture in green, whether the project is one of gamma in blue.
Shader "Tests/ColourSpace"
{
    Properties
    {
        _Color ("Colour", Color) = (0.5, 0, 0, 1)
        _MainTex ("Texture", 2D) = "white" {}
    }
    SubShader
    {
        Pass
        {
            Cull Off
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "UnityCG.cginc"

            float4 _Color;
            UNITY_DECLARE_TEX2D(_MainTex);

            float4 vert(float4 vertex : POSITION) : SV_POSITION { return UnityObjectToClipPos(vertex.xyz); }

            float4 frag() : SV_Target
            {
            #ifdef UNITY_COLORSPACE_GAMMA
                return float4(_Color.r, UNITY_SAMPLE_TEX2D(_MainTex, 0.5).g, 1, 1);
            #else
                return float4(_Color.r, UNITY_SAMPLE_TEX2D(_MainTex, 0.5).g, 0, 1);
            #endif
            }
            ENDHLSL
        }
    }
}
