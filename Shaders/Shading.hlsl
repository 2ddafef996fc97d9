#ifndef ANATOMYCARVE_SHADING_INCLUDED
#define ANATOMYCARVE_SHADING_INCLUDED

#include "Octahedral.hlsl"
#include "VolumeFields.hlsl"

// Normals between voxels, and Blinn-Phong (Blinn, "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977).

// Trilinear blend of the eight normals around a point in index space, those without a direction left out; not of unit length,
// (0, 0, 0) when none has one. Octahedral codes cannot be filtered by a sampler: they wrap around.
float3 BlendedNormal(StoredBox box, float3 index)
{
    float3 corner = floor(index);
    float3 part = index - corner;
    float3 sum = float3(0.0, 0.0, 0.0);
    [unroll]
    for (int n = 0; n < 8; n++)
    {
        int3 offset = int3(n & 1, (n >> 1) & 1, n >> 2);
        float3 weights = float3(offset) * part + float3(1 - offset) * (1.0 - part);
        sum += weights.x * weights.y * weights.z * OctahedralDecode(NormalCodeOf(StoredAt(box, int3(corner) + offset)));
    }
    return sum;
}

// Linear colour of a surface: base * (ambient + diffuse * (n.l) * light) + specular * (n.h)^shininess * light. Surfaces have two sides: a
// normal that points away from the viewer is mirrored to point towards him; turned around, it would jump where a surface bends away at its outline. toViewer,
// toLight: unit vectors, centred mm. No normal: the surface faces the viewer.
float3 BlinnPhong(float3 base, float3 normal, float3 toViewer, float3 toLight)
{
    float normalLength = length(normal);
    float3 n = normalLength > 1e-4 ? normal / max(normalLength, 1e-4) : toViewer;
    n -= 2.0 * min(dot(n, toViewer), 0.0) * toViewer;
    float3 halfway = toLight + toViewer;
    halfway *= rsqrt(max(dot(halfway, halfway), 1e-12));
    float diffuse = _Shading.y * max(dot(n, toLight), 0.0);
    float specular = _Shading.z * pow(clamp(dot(n, halfway), 1e-4, 1.0), _Shading.w); // never pow(0, 0)
    return base * (_Shading.x + diffuse * _LightColor.rgb) + specular * _LightColor.rgb;
}

#endif
