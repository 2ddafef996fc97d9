// The functions of Unity's file of this name that programmable passes call: spaces, depth, colour space.
#ifndef UNITY_CG_INCLUDED
#define UNITY_CG_INCLUDED

#define UNITY_PI 3.14159265359f
#define UNITY_TWO_PI 6.28318530718f
#define UNITY_HALF_PI 1.57079632679f

#include "UnityShaderVariables.cginc"
#include "UnityInstancing.cginc"

#ifdef UNITY_COLORSPACE_GAMMA
    #define unity_ColorSpaceGrey fixed4(0.5, 0.5, 0.5, 0.5)
#else
    #define unity_ColorSpaceGrey fixed4(0.214041144, 0.214041144, 0.214041144, 0.5)
#endif

struct appdata_base
{
    float4 vertex : POSITION;
    float3 normal : NORMAL;
    float4 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct appdata_img
{
    float4 vertex : POSITION;
    half2 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct v2f_img
{
    float4 pos : SV_POSITION;
    half2 uv : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

#define TRANSFORM_TEX(tex, name) ((tex).xy * name##_ST.xy + name##_ST.zw)

float GammaToLinearSpaceExact(float value)
{
    return value <= 0.04045 ? value / 12.92 : pow((max(value, 0.04045) + 0.055) / 1.055, 2.4);
}

float LinearToGammaSpaceExact(float value)
{
    return value <= 0.0031308 ? value * 12.92 : 1.055 * pow(max(value, 0.0031308), 1.0 / 2.4) - 0.055;
}

float3 GammaToLinearSpace(float3 c)
{
    return float3(GammaToLinearSpaceExact(c.r), GammaToLinearSpaceExact(c.g), GammaToLinearSpaceExact(c.b));
}

float3 LinearToGammaSpace(float3 c)
{
    return float3(LinearToGammaSpaceExact(c.r), LinearToGammaSpaceExact(c.g), LinearToGammaSpaceExact(c.b));
}

float3 UnityObjectToWorldPos(float3 position) { return mul(unity_ObjectToWorld, float4(position, 1.0)).xyz; }
float4 UnityWorldToClipPos(float3 position) { return mul(UNITY_MATRIX_VP, float4(position, 1.0)); }
float4 UnityViewToClipPos(float3 position) { return mul(UNITY_MATRIX_P, float4(position, 1.0)); }
float3 UnityWorldToViewPos(float3 position) { return mul(UNITY_MATRIX_V, float4(position, 1.0)).xyz; }
float3 UnityObjectToViewPos(float3 position) { return UnityWorldToViewPos(UnityObjectToWorldPos(position)); }
float4 UnityObjectToClipPos(float3 position) { return UnityWorldToClipPos(UnityObjectToWorldPos(position)); }
float4 UnityObjectToClipPos(float4 position) { return UnityObjectToClipPos(position.xyz); }
float3 UnityObjectToWorldDir(float3 direction) { return normalize(mul((float3x3)unity_ObjectToWorld, direction)); }
float3 UnityWorldToObjectDir(float3 direction) { return normalize(mul((float3x3)unity_WorldToObject, direction)); }
float3 UnityObjectToWorldNormal(float3 normal) { return normalize(mul(normal, (float3x3)unity_WorldToObject)); }
float3 UnityWorldSpaceViewDir(float3 position) { return _WorldSpaceCameraPos.xyz - position; }
float3 WorldSpaceViewDir(float4 position) { return UnityWorldSpaceViewDir(UnityObjectToWorldPos(position.xyz)); }
float3 ObjSpaceViewDir(float4 position) { return mul(unity_WorldToObject, float4(_WorldSpaceCameraPos.xyz, 1.0)).xyz - position.xyz; }

// A depth texture's value as distance along the view, in world units or in parts of the far plane's.
float LinearEyeDepth(float z) { return 1.0 / (_ZBufferParams.z * z + _ZBufferParams.w); }
float Linear01Depth(float z) { return 1.0 / (_ZBufferParams.x * z + _ZBufferParams.y); }

// Texture coordinates of a clip position in textures of the screen, times w.
float4 ComputeNonStereoScreenPos(float4 clip)
{
    float4 screen = clip * 0.5;
    return float4(float2(screen.x, screen.y * _ProjectionParams.x) + screen.w, clip.zw);
}

float4 ComputeScreenPos(float4 clip) { return ComputeNonStereoScreenPos(clip); }

v2f_img vert_img(appdata_img v)
{
    v2f_img o;
    UNITY_INITIALIZE_OUTPUT(v2f_img, o);
    UNITY_SETUP_INSTANCE_ID(v);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o);
    o.pos = UnityObjectToClipPos(v.vertex);
    o.uv = v.texcoord;
    return o;
}

#endif
