#ifndef ANATOMYCARVE_OPACITY_TILE_INCLUDED
#define ANATOMYCARVE_OPACITY_TILE_INCLUDED

#include "Bricks.hlsl"
#include "VolumeFields.hlsl"

// A brick's opacities with one voxel around, in memory that the group shares, and the 3x3x3 Sobel operator on them. Opacities are codes here, 0..255, and lie
// packed, four along z to a word, because each access to shared memory has its price.

#define TILE_SIZE (BRICK_SIZE + 2)
#define TILE_VOXELS (TILE_SIZE * TILE_SIZE * TILE_SIZE)
#define TILE_WORDS ((TILE_SIZE + 3) / 4) // of a column along z
#define PLANE 9
#define NEIGHBOURHOOD 27 // i fastest; 13 is the voxel itself

// Gradients below this are none, but for rounding: half of the smallest that opacities of one code can have, 1 / 32.
static const float NO_GRADIENT = 0.5 / 32.0;

groupshared uint OpacityTile[TILE_SIZE * TILE_SIZE * TILE_WORDS]; // x fastest, then y, then the word along z

// Called by all threads of a group, before a barrier: what the part of the brick between first and end needs. Voxels outside the volume get what the nearest
// inside have.
void FillOpacityTile(int3 brickOrigin, uint3 first, uint3 end, uint threadIndex)
{
    StoredBox box = StoredVoxels();
    uint rows = end.y - first.y + 2u, lastWord = end.z / 4u;
    [loop]
    for (uint item = threadIndex; item < TILE_SIZE * rows; item += GROUP_THREADS)
    {
        uint column = item + TILE_SIZE * first.y;
        int3 voxel = brickOrigin + int3(column % TILE_SIZE, column / TILE_SIZE, 0) - 1;
        uint word, n;
        [loop]
        for (word = first.z / 4u; word < lastWord; word++)
        {
            uint bits = 0u;
            [unroll]
            for (n = 0u; n < 4u; n++)
                bits |= OpacityCodeOf(StoredAt(box, voxel + int3(0, 0, 4u * word + n))) << (8u * n);
            OpacityTile[column + TILE_SIZE * TILE_SIZE * word] = bits;
        }
        uint rest = OpacityCodeOf(StoredAt(box, voxel + int3(0, 0, 4u * lastWord))) | OpacityCodeOf(StoredAt(box, voxel + int3(0, 0, 4u * lastWord + 1u))) << 8u;
        OpacityTile[column + TILE_SIZE * TILE_SIZE * lastWord] = rest;
    }
}

// The words of the 3x3 columns around a column of the brick (offset 0..7 per axis), i fastest: planes 4 * word to 4 * word + 3 of the tile (0..9).
void ReadWords(uint2 offset, uint word, out uint words[PLANE])
{
    uint first = offset.x + TILE_SIZE * (offset.y + TILE_SIZE * word);
    [unroll]
    for (uint n = 0u; n < PLANE; n++)
        words[n] = OpacityTile[first + n % 3u + TILE_SIZE * (n / 3u)];
}

// The opacities in one of the four planes of words.
void Unpack(uint words[PLANE], uint plane, out float o[PLANE])
{
    [unroll]
    for (uint n = 0u; n < PLANE; n++)
        o[n] = float((words[n] >> (8u * plane)) & 255u);
}

// Three-dimensional Sobel gradient, codes per voxel: [1 2 1] x [1 2 1] x [-1 0 1] / 32. Differences come first, so equal values on
// both sides give exactly 0.
float3 SobelGradient(float o[NEIGHBOURHOOD])
{
    const uint3 strides = uint3(1u, 3u, 9u);
    float3 gradient = float3(0.0, 0.0, 0.0);
    [unroll]
    for (uint axis = 0u; axis < 3u; axis++)
    {
        uint along = strides[axis], u = strides[(axis + 1u) % 3u], v = strides[(axis + 2u) % 3u];
        float sum = 0.0;
        [unroll]
        for (uint n = 0u; n < 9u; n++)
        {
            uint a = n % 3u, b = n / 3u;
            float weight = (a == 1u ? 2.0 : 1.0) * (b == 1u ? 2.0 : 1.0);
            uint low = a * u + b * v;
            sum += weight * (o[low + 2u * along] - o[low]);
        }
        gradient[axis] = sum / 32.0;
    }
    return gradient;
}

#endif
