// Vertices out of a buffer, by their number; the instance gives green.
Shader "Tests/Procedural"
{
    SubShader
    {
        Cull Off
        ZTest Always
        Pass
        {
            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex vert
            #pragma fragment frag
            #include "UnityCG.cginc"

            StructuredBuffer<float4> _Corners;

            struct v2f
            {
                float4 position : SV_POSITION;
                nointerpolation float green : TEXCOORD0;
            };

            v2f vert(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
            {
                v2f o;
                o.position = _Corners[vertex];
                o.green = instance * 0.5;
                return o;
            }

            float4 frag(v2f i) : SV_Target { return float4(1, i.green, 0, 1); }
            ENDHLSL
        }
    }
}
