// The main directional light and ambient light.
#ifndef UNIVERSAL_LIGHTING_INCLUDED
#define UNIVERSAL_LIGHTING_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

struct Light
{
    half3 direction;
    half3 color;
    float distanceAttenuation;
    half shadowAttenuation;
};

Light GetMainLight()
{
    Light light;
    light.direction = half3(_MainLightPosition.xyz);
    light.color = _MainLightColor.rgb;
    light.distanceAttenuation = 1.0;
    light.shadowAttenuation = 1.0;
    return light;
}

half3 LightingLambert(half3 lightColor, half3 lightDir, half3 normal) { return lightColor * saturate(dot(normal, lightDir)); }

half3 SampleSH(half3 normalWS)
{
    float4 normal = float4(normalWS, 1.0);
    return max(0.0, float3(dot(unity_SHAr, normal), dot(unity_SHAg, normal), dot(unity_SHAb, normal)));
}

#endif
