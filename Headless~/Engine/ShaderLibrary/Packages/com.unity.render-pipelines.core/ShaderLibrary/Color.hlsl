// Colour spaces, by the names of the render pipelines' file.
#ifndef UNITY_COLOR_INCLUDED
#define UNITY_COLOR_INCLUDED

float SRGBToLinear(float c) { return c <= 0.04045 ? c / 12.92 : pow((max(c, 0.04045) + 0.055) / 1.055, 2.4); }
float3 SRGBToLinear(float3 c) { return float3(SRGBToLinear(c.r), SRGBToLinear(c.g), SRGBToLinear(c.b)); }
float4 SRGBToLinear(float4 c) { return float4(SRGBToLinear(c.rgb), c.a); }

float LinearToSRGB(float c) { return c <= 0.0031308 ? c * 12.92 : 1.055 * pow(max(c, 0.0031308), 1.0 / 2.4) - 0.055; }
float3 LinearToSRGB(float3 c) { return float3(LinearToSRGB(c.r), LinearToSRGB(c.g), LinearToSRGB(c.b)); }
float4 LinearToSRGB(float4 c) { return float4(LinearToSRGB(c.rgb), c.a); }

float Luminance(float3 linearRgb) { return dot(linearRgb, float3(0.2126729, 0.7151522, 0.0721750)); }

#endif
