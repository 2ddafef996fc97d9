// Compatible with URP's SRP Batcher: what it declares lies in UnityPerMaterial. The colour outside is declared by nobody.
Shader "Tests/Batched"
{
    Properties
    {
        _Declared ("Declared", Vector) = (1, 0, 0, 1)
    }
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "UnityCG.cginc"
            cbuffer UnityPerMaterial { float4 _Declared; };
            cbuffer Others { float4 _Undeclared; };
            float4 vert(float3 position : POSITION) : SV_POSITION { return UnityObjectToClipPos(position); }
            float4 frag() : SV_Target { return _Declared + _Undeclared; }
            ENDHLSL
        }
    }
}
