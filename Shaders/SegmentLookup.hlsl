#ifndef ANATOMYCARVE_SEGMENT_LOOKUP_INCLUDED
#define ANATOMYCARVE_SEGMENT_LOOKUP_INCLUDED

#include "VolumeFields.hlsl"

// Which segment a point between voxels belongs to: that of the most opaque of the eight voxels around it, by the opacity before
// anti-aliasing; where all eight are empty (filters spread opacity), of the 4x4x4 around it. Ties: the lowest index, i fastest.

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

// Segment at a point whose index coordinates round down to corner; NO_SEGMENT when all 64 voxels are empty.
uint SegmentAround(int3 corner)
{
    float opacity;
    int3 voxel = MostOpaqueVoxel(corner, 1u, opacity);
    if (opacity == 0.0)
        voxel = MostOpaqueVoxel(corner - 1, 2u, opacity);
    uint segment = NO_SEGMENT;
    if (opacity > 0.0)
        segment = _Labels.Load(int4(voxel, 0));
    return segment;
}

// Linear colour of a segment; NO_SEGMENT has the colour of segment 0.
float3 SegmentColor(uint segment)
{
    uint row = segment < SegmentCount() ? segment : 0u;
    return _SegmentColors.Load(int3(row % SEGMENTS_PER_ROW, row / SEGMENTS_PER_ROW, 0)).rgb;
}

#endif
