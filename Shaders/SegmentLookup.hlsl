#ifndef ANATOMYCARVE_SEGMENT_LOOKUP_INCLUDED
#define ANATOMYCARVE_SEGMENT_LOOKUP_INCLUDED

#include "VolumeFields.hlsl"

// Which segment a point between voxels belongs to: that of the most opaque of the eight voxels around it, by the opacity before
// anti-aliasing; where all eight are empty (filters spread opacity), of the 4x4x4 around it. Ties: the lowest index, i fastest.

#define NO_SEGMENT 0xFFFFu

Texture3D<uint> _Labels;
Texture2D<float4> _SegmentColors; // rgb: linear colour

// The segment shown at a corner: that of the most opaque of its eight voxels; where these are empty, of the 4x4x4 around; NO_SEGMENT when all are. Beyond the
// border the nearest voxels repeat.
uint SegmentAround(StoredBox box, int3 corner)
{
    int3 best = int3(0, 0, 0); // stored
    float highest = 0.0;
    uint count = 8u;
    [loop]
    for (uint n = 0u; n < count; n++)
    {
        uint m = n - 8u;
        int3 offset = n < 8u ? int3(n & 1u, (n >> 1) & 1u, n >> 2) : int3(m & 3u, (m >> 2) & 3u, m >> 4) - 1;
        int3 stored = StoredAt(box, corner + offset);
        float opacity = OpacityOf(stored);
        best = opacity > highest ? stored : best;
        highest = max(highest, opacity);
        if (n == 7u && highest == 0.0)
            count = 72u;
    }
    uint segment = highest > 0.0 ? _Labels.Load(int4(box.first + best, 0)) : NO_SEGMENT;
    return segment;
}

// Linear colour of a segment; NO_SEGMENT has the colour of segment 0.
float3 SegmentColor(uint segment)
{
    uint row = segment < SegmentCount() ? segment : 0u;
    return _SegmentColors.Load(int3(row % SEGMENTS_PER_ROW, row / SEGMENTS_PER_ROW, 0)).rgb;
}

// Linear colour of matter at a place between voxels: of the eight around, each counts by its share and its opacity before anti-aliasing. So borders between
// segments have no steps, and what is empty lends no colour. False where there is nothing.
bool MatterColor(StoredBox box, float3 index, out float3 color)
{
    float3 corner = floor(index);
    float3 part = index - corner;
    float weights[8];
    uint segments[8];
    float sum = 0.0;
    uint next = NO_SEGMENT; // the lowest that is not counted yet
    int n;
    [unroll]
    for (n = 0; n < 8; n++)
    {
        int3 offset = int3(n & 1, (n >> 1) & 1, n >> 2);
        float3 shares = float3(offset) * part + float3(1 - offset) * (1.0 - part);
        int3 stored = StoredAt(box, int3(corner) + offset);
        weights[n] = shares.x * shares.y * shares.z * OpacityOf(stored);
        segments[n] = _Labels.Load(int4(box.first + stored, 0));
        sum += weights[n];
        next = weights[n] > 0.0 ? min(next, segments[n]) : next;
    }
    color = float3(0.0, 0.0, 0.0);
    [loop]
    while (next != NO_SEGMENT) // once in most places
    {
        float weight = 0.0;
        uint larger = NO_SEGMENT;
        [unroll]
        for (n = 0; n < 8; n++)
        {
            weight += segments[n] == next ? weights[n] : 0.0;
            larger = weights[n] > 0.0 && segments[n] > next ? min(larger, segments[n]) : larger;
        }
        color += weight * SegmentColor(next);
        next = larger;
    }
    color /= max(sum, 1e-20);
    return sum > 0.0;
}

#endif
