// The values that the engine gives to shaders, by Unity's names, in buffers named as Unity names them.
#ifndef UNITY_SHADER_VARIABLES_INCLUDED
#define UNITY_SHADER_VARIABLES_INCLUDED

#include "HLSLSupport.cginc"

#ifdef USING_STEREO_MATRICES
    static uint unity_StereoEyeIndex;

    CBUFFER_START(UnityStereoGlobals)
        float4x4 unity_StereoMatrixP[2];
        float4x4 unity_StereoMatrixV[2];
        float4x4 unity_StereoMatrixInvV[2];
        float4x4 unity_StereoMatrixVP[2];
        float4x4 unity_StereoCameraProjection[2];
        float4x4 unity_StereoCameraInvProjection[2];
        float4x4 unity_StereoWorldToCamera[2];
        float4x4 unity_StereoCameraToWorld[2];
        float4 unity_StereoScaleOffset[2];
        float3 unity_StereoWorldSpaceCameraPos[2];
    CBUFFER_END

    #define glstate_matrix_projection unity_StereoMatrixP[unity_StereoEyeIndex]
    #define unity_MatrixV unity_StereoMatrixV[unity_StereoEyeIndex]
    #define unity_MatrixInvV unity_StereoMatrixInvV[unity_StereoEyeIndex]
    #define unity_MatrixVP unity_StereoMatrixVP[unity_StereoEyeIndex]
    #define unity_CameraProjection unity_StereoCameraProjection[unity_StereoEyeIndex]
    #define unity_CameraInvProjection unity_StereoCameraInvProjection[unity_StereoEyeIndex]
    #define unity_WorldToCamera unity_StereoWorldToCamera[unity_StereoEyeIndex]
    #define unity_CameraToWorld unity_StereoCameraToWorld[unity_StereoEyeIndex]
    #define _WorldSpaceCameraPos unity_StereoWorldSpaceCameraPos[unity_StereoEyeIndex]
#endif

CBUFFER_START(UnityPerCamera)
    float4 _Time; // t/20, t, 2t, 3t
    float4 _SinTime; // of t/8, t/4, t/2, t
    float4 _CosTime;
    float4 unity_DeltaTime; // dt, 1/dt, smoothed
#ifndef USING_STEREO_MATRICES
    float3 _WorldSpaceCameraPos;
#endif
    float4 _ProjectionParams; // 1 or -1 (turned over), near, far, 1/far
    float4 _ScreenParams; // width, height, 1 + 1/width, 1 + 1/height
    float4 _ZBufferParams; // for LinearEyeDepth and Linear01Depth
    float4 unity_OrthoParams; // half the width and height, 0, 1 if orthographic
CBUFFER_END

CBUFFER_START(UnityPerCameraRare)
    float4 unity_CameraWorldClipPlanes[6];
#ifndef USING_STEREO_MATRICES
    float4x4 unity_CameraProjection;
    float4x4 unity_CameraInvProjection;
    float4x4 unity_WorldToCamera;
    float4x4 unity_CameraToWorld;
#endif
CBUFFER_END

CBUFFER_START(UnityLighting)
    float4 _WorldSpaceLightPos0; // towards a directional light, w = 0
    float4 _LightColor0;
CBUFFER_END

CBUFFER_START(UnityPerDraw)
    float4x4 unity_ObjectToWorld;
    float4x4 unity_WorldToObject;
    float4 unity_LODFade;
    float4 unity_WorldTransformParams; // w = -1 if mirrored
CBUFFER_END

CBUFFER_START(UnityPerFrame)
    float4 glstate_lightmodel_ambient;
    float4 unity_AmbientSky;
#ifndef USING_STEREO_MATRICES
    float4x4 glstate_matrix_projection;
    float4x4 unity_MatrixV;
    float4x4 unity_MatrixInvV;
    float4x4 unity_MatrixVP;
    int unity_StereoEyeIndex;
#endif
CBUFFER_END

#define UNITY_LIGHTMODEL_AMBIENT (glstate_lightmodel_ambient)

#define UNITY_MATRIX_P glstate_matrix_projection
#define UNITY_MATRIX_V unity_MatrixV
#define UNITY_MATRIX_I_V unity_MatrixInvV
#define UNITY_MATRIX_VP unity_MatrixVP
#define UNITY_MATRIX_M unity_ObjectToWorld
#define UNITY_MATRIX_I_M unity_WorldToObject
#define UNITY_MATRIX_MV mul(unity_MatrixV, unity_ObjectToWorld)
#define UNITY_MATRIX_MVP mul(unity_MatrixVP, unity_ObjectToWorld)

#endif
