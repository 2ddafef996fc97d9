#ifndef ANATOMYCARVE_SEGMENT_LOOKUP_INCLUDED
#define ANATOMYCARVE_SEGMENT_LOOKUP_INCLUDED

#include "VolumeFields.hlsl"

// Which segment a point between voxels belongs to: that of the most opaque of the eight voxels around it, by the opacity before
// anti-aliasing; where all eight are empty (filters spread opacity), of the 4x4x4 around it. Ties: the lowest index, i fastest. The colour of a sample
// all of whose eight are empty is looked for one reference length further along its ray first, which is cheaper.

#define NO_SEGMENT 0xFFFFu

Texture3D<uint> _Labels;
Texture2D<float4> _SegmentColors; // rgb: linear colour

// The voxel of most opacity in a cube of 2^bits voxels per axis; opacity 0 when all are empty. Beyond the border the nearest repeat.
int3 MostOpaqueVoxel(int3 first, uint bits, out float opacity)
{
    uint size = 1u << bits;
    int3 last = VolumeDims() - 1;
    int3 best = clamp(first, int3(0, 0, 0), last);
    opacity = 0.0;
    for (uint n = 0u; n < size * size * size; n++)
    {
        uint3 offset = uint3(n, n >> bits, n >> (2u * bits)) & (size - 1u);
        int3 voxel = clamp(first + int3(offset), int3(0, 0, 0), last);
        float o = OpacityOf(voxel);
        if (o > opacity)
        {
            opacity = o;
            best = voxel;
        }
    }
    return best;
}

// Segment of the most opaque of the eight voxels of a corner; NO_SEGMENT when all are empty. isBorder: whether those that are not empty have several.
uint SegmentOfEight(int3 corner, out bool isBorder)
{
    int3 last = VolumeDims() - 1;
    uint segment = NO_SEGMENT, least = NO_SEGMENT, most = 0u;
    float highest = 0.0;
    [unroll]
    for (int n = 0; n < 8; n++)
    {
        int3 voxel = clamp(corner + int3(n & 1, (n >> 1) & 1, n >> 2), int3(0, 0, 0), last);
        float opacity = OpacityOf(voxel);
        uint own = _Labels.Load(int4(voxel, 0));
        segment = opacity > highest ? own : segment;
        highest = max(highest, opacity);
        least = opacity > 0.0 ? min(least, own) : least;
        most = opacity > 0.0 ? max(most, own) : most;
    }
    isBorder = highest > 0.0 && least != most;
    return segment;
}

// The same; where all eight are empty, of the 4x4x4 around; NO_SEGMENT when all 64 are.
uint SegmentAround(int3 corner)
{
    bool isBorder;
    uint segment = SegmentOfEight(corner, isBorder);
    [branch]
    if (segment == NO_SEGMENT)
    {
        float opacity;
        int3 voxel = MostOpaqueVoxel(corner - 1, 2u, opacity);
        if (opacity > 0.0)
            segment = _Labels.Load(int4(voxel, 0));
    }
    return segment;
}

// Linear colour of a segment; NO_SEGMENT has the colour of segment 0.
float3 SegmentColor(uint segment)
{
    uint row = segment < SegmentCount() ? segment : 0u;
    return _SegmentColors.Load(int3(row % SEGMENTS_PER_ROW, row / SEGMENTS_PER_ROW, 0)).rgb;
}

// Linear colour at a place between voxels of several segments: of the eight around, each counts by its share and its opacity before anti-aliasing. So
// borders between segments have no steps, and what is empty lends no colour.
float3 BorderColor(float3 index, float3 otherwise)
{
    float3 corner = floor(index);
    float3 part = index - corner;
    int3 last = VolumeDims() - 1;
    float4 sum = float4(0.0, 0.0, 0.0, 0.0);
    [loop]
    for (int n = 0; n < 8; n++)
    {
        int3 offset = int3(n & 1, (n >> 1) & 1, n >> 2);
        float3 weights = float3(offset) * part + float3(1 - offset) * (1.0 - part);
        int3 voxel = clamp(int3(corner) + offset, int3(0, 0, 0), last);
        float weight = weights.x * weights.y * weights.z * OpacityOf(voxel);
        sum += weight * float4(SegmentColor(_Labels.Load(int4(voxel, 0))), 1.0);
    }
    return sum.a > 0.0 ? sum.rgb / max(sum.a, 1e-20) : otherwise;
}

#endif
