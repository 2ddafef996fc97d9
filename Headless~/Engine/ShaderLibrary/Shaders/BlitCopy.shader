// Copies a texture.
Shader "@NAME@"
{
    Properties
    {
        _MainTex ("Texture", 2D) = "white" {}
    }
    SubShader
    {
        Pass
        {
            Cull Off
            ZTest Always
            ZWrite Off
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "UnityCG.cginc"

            UNITY_DECLARE_TEX2D(_MainTex);
            float4 _MainTex_ST;

            struct v2f
            {
                float4 position : SV_POSITION;
                float2 uv : TEXCOORD0;
            };

            v2f vert(float4 vertex : POSITION, float2 uv : TEXCOORD0)
            {
                v2f o;
                o.position = UnityObjectToClipPos(vertex.xyz);
                o.uv = TRANSFORM_TEX(uv, _MainTex);
                return o;
            }

            float4 frag(v2f i) : SV_Target
            {
                return UNITY_SAMPLE_TEX2D(_MainTex, i.uv);
            }
            ENDHLSL
        }
    }
}
