// What every shader of URP includes.
#ifndef UNIVERSAL_PIPELINE_CORE_INCLUDED
#define UNIVERSAL_PIPELINE_CORE_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Input.hlsl"

// Textures of the screen have a slice per eye where one draw makes both.
#ifdef USING_STEREO_MATRICES
    #define TEXTURE2D_X(textureName) TEXTURE2D_ARRAY(textureName)
    #define TEXTURE2D_X_FLOAT(textureName) TEXTURE2D_ARRAY(textureName)
    #define SAMPLE_TEXTURE2D_X(textureName, samplerName, coord2) SAMPLE_TEXTURE2D_ARRAY(textureName, samplerName, coord2, SLICE_ARRAY_INDEX)
    #define SAMPLE_TEXTURE2D_X_LOD(textureName, samplerName, coord2, lod) SAMPLE_TEXTURE2D_ARRAY_LOD(textureName, samplerName, coord2, SLICE_ARRAY_INDEX, lod)
    #define LOAD_TEXTURE2D_X(textureName, unCoord2) LOAD_TEXTURE2D_ARRAY(textureName, unCoord2, SLICE_ARRAY_INDEX)
#else
    #define SLICE_ARRAY_INDEX 0
    #define TEXTURE2D_X(textureName) TEXTURE2D(textureName)
    #define TEXTURE2D_X_FLOAT(textureName) TEXTURE2D(textureName)
    #define SAMPLE_TEXTURE2D_X(textureName, samplerName, coord2) SAMPLE_TEXTURE2D(textureName, samplerName, coord2)
    #define SAMPLE_TEXTURE2D_X_LOD(textureName, samplerName, coord2, lod) SAMPLE_TEXTURE2D_LOD(textureName, samplerName, coord2, lod)
    #define LOAD_TEXTURE2D_X(textureName, unCoord2) LOAD_TEXTURE2D(textureName, unCoord2)
#endif

#define TRANSFORM_TEX(tex, name) ((tex).xy * name##_ST.xy + name##_ST.zw)

struct VertexPositionInputs
{
    float3 positionWS;
    float3 positionVS;
    float4 positionCS;
    float4 positionNDC; // texture coordinates in textures of the screen, times w
};

VertexPositionInputs GetVertexPositionInputs(float3 positionOS)
{
    VertexPositionInputs input;
    input.positionWS = TransformObjectToWorld(positionOS);
    input.positionVS = TransformWorldToView(input.positionWS);
    input.positionCS = TransformWorldToHClip(input.positionWS);
    float4 half_ = input.positionCS * 0.5;
    input.positionNDC = float4(float2(half_.x, half_.y * _ProjectionParams.x) + half_.w, input.positionCS.zw);
    return input;
}

bool IsPerspectiveProjection() { return unity_OrthoParams.w == 0.0; }

float3 GetCameraPositionWS() { return _WorldSpaceCameraPos; }
float3 GetCurrentViewPosition() { return GetCameraPositionWS(); }
float3 GetViewForwardDir() { return -UNITY_MATRIX_V[2].xyz; }

float3 GetWorldSpaceViewDir(float3 positionWS)
{
    return IsPerspectiveProjection() ? GetCurrentViewPosition() - positionWS : -GetViewForwardDir();
}

float3 GetWorldSpaceNormalizeViewDir(float3 positionWS) { return normalize(GetWorldSpaceViewDir(positionWS)); }

// Of a pixel, where textures of the screen have their first row at the bottom of the picture.
float2 GetNormalizedScreenSpaceUV(float2 positionCS)
{
    float2 uv = positionCS / _ScaledScreenParams.xy;
    return float2(uv.x, _ProjectionParams.x < 0.0 ? uv.y : 1.0 - uv.y);
}

float2 GetNormalizedScreenSpaceUV(float4 positionCS) { return GetNormalizedScreenSpaceUV(positionCS.xy); }

#endif
