// From space to space. Needs the matrices UNITY_MATRIX_*.
#ifndef UNITY_SPACE_TRANSFORMS_INCLUDED
#define UNITY_SPACE_TRANSFORMS_INCLUDED

float4x4 GetObjectToWorldMatrix() { return UNITY_MATRIX_M; }
float4x4 GetWorldToObjectMatrix() { return UNITY_MATRIX_I_M; }
float4x4 GetWorldToViewMatrix() { return UNITY_MATRIX_V; }
float4x4 GetViewToWorldMatrix() { return UNITY_MATRIX_I_V; }
float4x4 GetWorldToHClipMatrix() { return UNITY_MATRIX_VP; }
float4x4 GetViewToHClipMatrix() { return UNITY_MATRIX_P; }

float GetOddNegativeScale() { return unity_WorldTransformParams.w >= 0.0 ? 1.0 : -1.0; }

float3 TransformObjectToWorld(float3 positionOS) { return mul(UNITY_MATRIX_M, float4(positionOS, 1.0)).xyz; }
float3 TransformWorldToObject(float3 positionWS) { return mul(UNITY_MATRIX_I_M, float4(positionWS, 1.0)).xyz; }
float3 TransformWorldToView(float3 positionWS) { return mul(UNITY_MATRIX_V, float4(positionWS, 1.0)).xyz; }
float3 TransformViewToWorld(float3 positionVS) { return mul(UNITY_MATRIX_I_V, float4(positionVS, 1.0)).xyz; }
float4 TransformWorldToHClip(float3 positionWS) { return mul(UNITY_MATRIX_VP, float4(positionWS, 1.0)); }
float4 TransformWViewToHClip(float3 positionVS) { return mul(UNITY_MATRIX_P, float4(positionVS, 1.0)); }
float4 TransformObjectToHClip(float3 positionOS) { return TransformWorldToHClip(TransformObjectToWorld(positionOS)); }

float3 TransformObjectToWorldDir(float3 dirOS, bool doNormalize = true)
{
    float3 direction = mul((float3x3)UNITY_MATRIX_M, dirOS);
    return doNormalize ? SafeNormalize(direction) : direction;
}

float3 TransformWorldToObjectDir(float3 dirWS, bool doNormalize = true)
{
    float3 direction = mul((float3x3)UNITY_MATRIX_I_M, dirWS);
    return doNormalize ? normalize(direction) : direction;
}

float3 TransformWorldToViewDir(float3 dirWS, bool doNormalize = false)
{
    float3 direction = mul((float3x3)UNITY_MATRIX_V, dirWS);
    return doNormalize ? normalize(direction) : direction;
}

float3 TransformObjectToWorldNormal(float3 normalOS, bool doNormalize = true)
{
    float3 normal = mul(normalOS, (float3x3)UNITY_MATRIX_I_M);
    return doNormalize ? SafeNormalize(normal) : normal;
}

#endif
