#ifndef ANATOMYCARVE_CLIP_SPHERES_INCLUDED
#define ANATOMYCARVE_CLIP_SPHERES_INCLUDED

#include "VolumeLayout.hlsl"

// Clip spheres against voxels. The arithmetic that decides Eq. 1 is `precise` and in a fixed order (no fused multiply-add): the C# twin
// does the same operations, so both agree on every boundary voxel, bit for bit.

StructuredBuffer<SphereRow> _Spheres; // by slot
StructuredBuffer<uint> _MaskWords;
StructuredBuffer<uint2> _BrickSpheres; // for each brick of the list, which part of _SphereSlots is its own: x: first, y: how many
StructuredBuffer<uint> _SphereSlots;   // the spheres that meet a brick

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

// How deep p lies inside the sphere, in extents of a voxel along the sphere's normal there; negative outside.
float DepthInVoxels(float4 centreRadius, float3 p)
{
    float3 d = p - centreRadius.xyz;
    float distance = length(d);
    float extent = abs(dot(d, VoxelStepI())) + abs(dot(d, VoxelStepJ())) + abs(dot(d, VoxelStepK())); // of a voxel along d, times d's length
    return distance > 0.0 ? (centreRadius.w - distance) * (distance / max(extent, 1e-30)) : centreRadius.w / _CentreIndex.w;
}

// Within so many extents of a voxel from a sphere's surface the cut's normal may be the sphere's: as far as the voxels between which a visible point of
// the cut lies.
static const float SURFACE_REACH = 1.75;

// The share of a voxel that lies inside the sphere, the sphere's surface taken as flat: 0.5 + s / w, s = how deep the voxel's centre
// lies inside (mm), w = the voxel's extent along the surface's normal (mm).
float SmoothCoverage(float4 centreRadius, float3 p)
{
    float coverage = saturate(0.5 + DepthInVoxels(centreRadius, p));
    return centreRadius.w > 0.0 ? coverage : 0.0;
}

// Mask(s, label): whether the sphere clips the segment. mask: SphereRow's.
bool MaskHolds(uint4 mask, uint segment)
{
    uint word = segment >> 5;
    uint bits = word == 0u ? mask.y : word == 1u ? mask.z : mask.w;
    [branch]
    if (word > 2u)
        bits = _MaskWords[mask.x + word];
    return ((bits >> (segment & 31u)) & 1u) != 0u;
}

#endif
