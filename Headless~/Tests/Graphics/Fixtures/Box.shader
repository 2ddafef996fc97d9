// A box of one colour, which writes a depth of its own: that of a plane of constant view distance _Distance if that is above 0.
Shader "Tests/Box"
{
    Properties
    {
        _Color ("Colour", Color) = (1, 0.5, 0.25, 1)
        _Distance ("Distance", Float) = 0
        [Enum(UnityEngine.Rendering.CullMode)] _Cull ("Cull", Float) = 2
    }
    SubShader
    {
        Tags { "Queue" = "Geometry" }
        Cull [_Cull]
        Pass
        {
            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex vert
            #pragma fragment frag
            #pragma multi_compile_instancing
            #include "UnityCG.cginc"

            float4 _Color;
            float _Distance;

            struct appdata
            {
                float4 vertex : POSITION;
                UNITY_VERTEX_INPUT_INSTANCE_ID
            };

            struct v2f
            {
                float4 position : SV_POSITION;
                UNITY_VERTEX_INPUT_INSTANCE_ID
                UNITY_VERTEX_OUTPUT_STEREO
            };

            v2f vert(appdata v)
            {
                v2f o;
                UNITY_SETUP_INSTANCE_ID(v);
                UNITY_INITIALIZE_OUTPUT(v2f, o);
                UNITY_TRANSFER_INSTANCE_ID(v, o);
                UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o);
                o.position = UnityObjectToClipPos(v.vertex.xyz);
                return o;
            }

            float4 frag(v2f i, out float depth : SV_Depth) : SV_Target
            {
                UNITY_SETUP_INSTANCE_ID(i);
                UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(i);
                float4 clip = mul(UNITY_MATRIX_P, float4(0, 0, -_Distance, 1));
                depth = _Distance > 0 ? clip.z / clip.w : i.position.z;
                return _Color;
            }
            ENDHLSL
        }
    }
}
