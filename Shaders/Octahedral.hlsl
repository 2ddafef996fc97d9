#ifndef ANATOMYCARVE_OCTAHEDRAL_INCLUDED
#define ANATOMYCARVE_OCTAHEDRAL_INCLUDED

// Unit vectors in two bytes (RG8_UNorm), by the octahedral map of Cigolle et al., "A Survey of Efficient Representations for
// Independent Unit Vectors", JCGT 3(2), 2014. A code c in 0..254 stands for the coordinate (c - 127) / 127, so that the six axes are
// exact; the largest error is 0.95 degrees. Code (0, 0) is kept for "no direction": of the four corners of the map, which all
// mean -z, it is the one that is never written.

static const float OCTAHEDRAL_HALF_RANGE = 127.0;

float2 OctahedralSign(float2 v)
{
    return float2(v.x < 0.0 ? -1.0 : 1.0, v.y < 0.0 ? -1.0 : 1.0);
}

// The two codes, whole numbers of 0..254, for a unit vector. (0, 0) never comes out.
float2 OctahedralEncode(float3 direction)
{
    float2 p = direction.xy / (abs(direction.x) + abs(direction.y) + abs(direction.z));
    if (direction.z < 0.0)
        p = (1.0 - abs(p.yx)) * OctahedralSign(p);
    float2 code = clamp(floor(p * OCTAHEDRAL_HALF_RANGE + 0.5) + OCTAHEDRAL_HALF_RANGE, 0.0, 2.0 * OCTAHEDRAL_HALF_RANGE);
    if (code.x + code.y == 0.0)
        code = float2(2.0 * OCTAHEDRAL_HALF_RANGE, 2.0 * OCTAHEDRAL_HALF_RANGE);
    return code;
}

// The unit vector of two codes; (0, 0, 0) for "no direction".
float3 OctahedralDecode(float2 code)
{
    float2 p = (code - OCTAHEDRAL_HALF_RANGE) / OCTAHEDRAL_HALF_RANGE;
    float z = 1.0 - abs(p.x) - abs(p.y);
    float2 xy = z < 0.0 ? (1.0 - abs(p.yx)) * OctahedralSign(p) : p;
    float3 direction = float3(xy, z);
    float isDirection = code.x + code.y > 0.0 ? 1.0 : 0.0;
    return direction * (isDirection * rsqrt(dot(direction, direction)));
}

#endif
