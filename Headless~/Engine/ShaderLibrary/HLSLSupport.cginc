// What a compiler and a graphics API make of HLSL, in the words of Unity's file of this name. This host's own, from Unity's documentation: only what
// shaders of programmable passes use. It is compiled by glslang (SHADER_API_VULKAN) and by Microsoft's FXC and DXC (SHADER_API_D3D11).
#ifndef HLSL_SUPPORT_INCLUDED
#define HLSL_SUPPORT_INCLUDED

#define fixed half
#define fixed2 half2
#define fixed3 half3
#define fixed4 half4
#define fixed3x3 half3x3
#define fixed4x4 half4x4
#define sampler2D_half sampler2D
#define sampler2D_float sampler2D

#define CBUFFER_START(name) cbuffer name {
#define CBUFFER_END };
#define GLOBAL_CBUFFER_START(name) cbuffer name {
#define GLOBAL_CBUFFER_END }

// Both APIs: depth from 1 (near) to 0 (far), and textures whose first row is the top.
#define UNITY_REVERSED_Z 1
#define UNITY_NEAR_CLIP_VALUE (1.0)
#define UNITY_RAW_FAR_CLIP_VALUE (0.0)
#define UNITY_UV_STARTS_AT_TOP 1

#define UNITY_BRANCH [branch]
#define UNITY_FLATTEN [flatten]
#define UNITY_UNROLL [unroll]
#define UNITY_UNROLLX(n) [unroll(n)]
#define UNITY_LOOP [loop]

#define UNITY_INITIALIZE_OUTPUT(type, name) name = (type)0;
#define UNITY_VPOS_TYPE float4
#define UNITY_POSITION(position) float4 position : SV_POSITION

#include "StereoKeywords.hlsl"

#define UNITY_DECLARE_TEX2D(tex) Texture2D tex; SamplerState sampler##tex
#define UNITY_DECLARE_TEX2D_NOSAMPLER(tex) Texture2D tex
#define UNITY_SAMPLE_TEX2D(tex, coord) tex.Sample(sampler##tex, coord)
#define UNITY_SAMPLE_TEX2D_LOD(tex, coord, lod) tex.SampleLevel(sampler##tex, coord, lod)
#define UNITY_SAMPLE_TEX2D_SAMPLER(tex, samplertex, coord) tex.Sample(sampler##samplertex, coord)
#define UNITY_DECLARE_TEX3D(tex) Texture3D tex; SamplerState sampler##tex
#define UNITY_DECLARE_TEX3D_NOSAMPLER(tex) Texture3D tex
#define UNITY_SAMPLE_TEX3D(tex, coord) tex.Sample(sampler##tex, coord)
#define UNITY_SAMPLE_TEX3D_LOD(tex, coord, lod) tex.SampleLevel(sampler##tex, coord, lod)
#define UNITY_DECLARE_TEX2DARRAY(tex) Texture2DArray tex; SamplerState sampler##tex
#define UNITY_SAMPLE_TEX2DARRAY(tex, coord) tex.Sample(sampler##tex, coord)
#define UNITY_SAMPLE_TEX2DARRAY_LOD(tex, coord, lod) tex.SampleLevel(sampler##tex, coord, lod)

// Textures of the screen have a slice per eye where one draw makes both.
#ifdef USING_STEREO_MATRICES
    #define UNITY_DECLARE_SCREENSPACE_TEXTURE(tex) UNITY_DECLARE_TEX2DARRAY(tex)
    #define UNITY_SAMPLE_SCREENSPACE_TEXTURE(tex, uv) UNITY_SAMPLE_TEX2DARRAY(tex, float3((uv).xy, (float)unity_StereoEyeIndex))
    #define SAMPLE_DEPTH_TEXTURE(tex, uv) (tex.Sample(sampler##tex, float3((uv).xy, (float)unity_StereoEyeIndex)).r)
    #define SAMPLE_DEPTH_TEXTURE_LOD(tex, uv) (tex.SampleLevel(sampler##tex, float3((uv).xy, (float)unity_StereoEyeIndex), (uv).w).r)
    #define SAMPLE_RAW_DEPTH_TEXTURE(tex, uv) tex.Sample(sampler##tex, float3((uv).xy, (float)unity_StereoEyeIndex))
#else
    #define UNITY_DECLARE_SCREENSPACE_TEXTURE(tex) UNITY_DECLARE_TEX2D(tex)
    #define UNITY_SAMPLE_SCREENSPACE_TEXTURE(tex, uv) UNITY_SAMPLE_TEX2D(tex, uv)
    #define SAMPLE_DEPTH_TEXTURE(tex, uv) (tex.Sample(sampler##tex, (uv).xy).r)
    #define SAMPLE_DEPTH_TEXTURE_LOD(tex, uv) (tex.SampleLevel(sampler##tex, (uv).xy, (uv).w).r)
    #define SAMPLE_RAW_DEPTH_TEXTURE(tex, uv) tex.Sample(sampler##tex, (uv).xy)
#endif
#define UNITY_DECLARE_DEPTH_TEXTURE(tex) UNITY_DECLARE_SCREENSPACE_TEXTURE(tex)
#define SAMPLE_DEPTH_TEXTURE_PROJ(tex, uv) SAMPLE_DEPTH_TEXTURE(tex, (uv).xy / (uv).w)

#endif
