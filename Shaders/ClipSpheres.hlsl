#ifndef ANATOMYCARVE_CLIP_SPHERES_INCLUDED
#define ANATOMYCARVE_CLIP_SPHERES_INCLUDED

#include "VolumeLayout.hlsl"

// Clip spheres against voxels. The arithmetic that decides Eq. 1 is `precise` and in a fixed order (no fused multiply-add): the C# twin
// does the same operations, so both agree on every boundary voxel, bit for bit.

StructuredBuffer<SphereRow> _Spheres;
StructuredBuffer<uint> _MaskWords;

// A voxel's centre in centred mm.
float3 VoxelPosition(int3 voxel)
{
    precise float3 f = float3(voxel) - _CentreIndex.xyz;
    precise float x = (_IndexToMm0.x * f.x + _IndexToMm0.y * f.y) + _IndexToMm0.z * f.z;
    precise float y = (_IndexToMm1.x * f.x + _IndexToMm1.y * f.y) + _IndexToMm1.z * f.z;
    precise float z = (_IndexToMm2.x * f.x + _IndexToMm2.y * f.y) + _IndexToMm2.z * f.z;
    return float3(x, y, z);
}

// Inside(s, v) of Eq. 1; p in centred mm.
bool Inside(float4 centreRadius, float3 p)
{
    precise float dx = p.x - centreRadius.x;
    precise float dy = p.y - centreRadius.y;
    precise float dz = p.z - centreRadius.z;
    precise float distanceSquared = (dx * dx + dy * dy) + dz * dz;
    precise float radiusSquared = centreRadius.w * centreRadius.w;
    return centreRadius.w > 0.0 && distanceSquared <= radiusSquared;
}

// Columns of M: the steps between neighbouring voxels, in mm.
float3 VoxelStepI() { return float3(_IndexToMm0.x, _IndexToMm1.x, _IndexToMm2.x); }
float3 VoxelStepJ() { return float3(_IndexToMm0.y, _IndexToMm1.y, _IndexToMm2.y); }
float3 VoxelStepK() { return float3(_IndexToMm0.z, _IndexToMm1.z, _IndexToMm2.z); }

// The share of a voxel that lies inside the sphere, the sphere's surface taken as flat: 0.5 + s / w, s = how deep the voxel's centre
// lies inside (mm), w = the voxel's extent along the surface's normal (mm).
float SmoothCoverage(float4 centreRadius, float3 p)
{
    float3 d = p - centreRadius.xyz;
    float distance = length(d);
    float3 n = d / max(distance, 1e-30);
    float extent = abs(dot(n, VoxelStepI())) + abs(dot(n, VoxelStepJ())) + abs(dot(n, VoxelStepK()));
    float width = distance > 0.0 ? extent : _CentreIndex.w;
    float coverage = saturate(0.5 + (centreRadius.w - distance) / width);
    return centreRadius.w > 0.0 ? coverage : 0.0;
}

// True for every sphere that can cover part of a voxel of the brick, and for some that cannot: the bounding ball of the brick's voxel
// centres, with the voxel's half extent (smooth cut) and room for rounding.
bool ReachesBrick(float4 centreRadius, int3 brickOrigin)
{
    float3 i = VoxelStepI(), j = VoxelStepJ(), k = VoxelStepK();
    float3 first = VoxelPosition(brickOrigin);
    float3 centre = first + 0.5 * (BRICK_SIZE - 1) * (i + j + k);
    float diagonal = max(max(length(i + j + k), length(i + j - k)), max(length(i - j + k), length(j + k - i)));
    float halfVoxel = 0.5 * (length(i) + length(j) + length(k));
    float rounding = 1e-5 * (length(centre) + length(centreRadius.xyz) + abs(centreRadius.w));
    float reach = centreRadius.w + 0.5 * (BRICK_SIZE - 1) * diagonal + halfVoxel + rounding;
    float3 d = centre - centreRadius.xyz;
    return centreRadius.w > 0.0 && !(dot(d, d) > reach * reach);
}

// Mask(s, label): whether the sphere clips the segment.
bool MaskHolds(uint firstWord, uint segment)
{
    return ((_MaskWords[firstWord + (segment >> 5)] >> (segment & 31u)) & 1u) != 0u;
}

#endif
